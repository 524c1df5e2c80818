"""The terms that MuJoCo has a body, a limit or an actuator of its own for. All others go by what
their torque hangs on.
"""

from collections.abc import Callable

import numpy as np

from exoid.interchange.formats.mujoco.piece import Piece
from exoid.interchange.model.body import Body, hung
from exoid.interchange.model.joint import Joint, Kept, Part
from exoid.physics.leg import GRAVITY
from exoid.physics.term import Term
from exoid.physics.terms.device.cuff_compliance import CuffCompliance
from exoid.physics.terms.device.hard_stop import HardStop
from exoid.physics.terms.muscle.activation_lag import ActivationLag
from exoid.physics.terms.tissue.stiffness_rest_angle import StiffnessRestAngle
from exoid.physics.terms.tissue.wobbling_mass import WobblingMass

# A soft limit of MuJoCo mixes its own acceleration into the free one by this share. At the least
# that it allows, what is left is a spring and a damper per inertia, within 1e-4.
SOFT = "0.0001 0.0001 0.001 0.5 2"
QUICK, QUICKEST = 2.5e-4, 5e-5  # s, steps that a cuff and a stop allow
NOTHING = 1e-12  # kg: of less an engine makes no body
POINT = 1e-9  # kg m^2: a mass point has no inertia, but an engine wants one


def values(part: Part) -> dict[str, float]:
    """Its numbers by their own names."""
    return {each.name.removeprefix(f"{part.name}_"): each.value for each in part.numbers}


def rest_angle(part: Part, joint: Joint) -> Piece:
    """springref of the knee."""
    return Piece((Kept(part.name, "exact", "springref"),), rest=values(part)["rest_angle"])


def stop(part: Part, joint: Joint) -> Piece:
    """A range with a spring and a damper per inertia, which never pull."""
    own = values(part)
    rate = np.pi / own["contact_time"]
    where = "range, solreflimit: 1e-4 of J phi'' less while it touches"
    return Piece(
        (Kept(part.name, "approximate", where),),
        limits=(
            f'range="{own["flexion_angle"]:.12g} {own["extension_angle"]:.12g}"',
            f'solreflimit="{-(rate**2):.12g} {-2 * own["damping_ratio"] * rate:.12g}"',
            f'solimplimit="{SOFT}"',
        ),
        step=QUICKEST,
    )


def lag(part: Part, joint: Joint) -> Piece:
    """The motor's activation."""
    kept = Kept(part.name, "exact", 'dyntype="filter" of the motor "drive"')
    return Piece((kept,), lag=values(part)["lag"], carried=float(part.begun[0]))


def frame(part: Part, joint: Joint) -> Piece:
    """A second body about the knee, tied to the shank; encoder and gyro ride on it."""
    own, begun = values(part), part.begun
    spring = 1 / own["compliance"]
    damper = 2 * own["damping_ratio"] * np.sqrt(spring * own["frame_inertia"])
    made = hung(own["frame_inertia"], own["frame_gravity"])
    joints = f'<joint name="cuff" axis="0 -1 0" stiffness="{spring:.12g}" damping="{damper:.12g}"/>'
    turn = '<joint joint="knee" coef="1"/> <joint joint="cuff" coef="1"/>'
    return Piece(
        (Kept(part.name, "exact", 'body "frame", joint "cuff", tendon "frame"'),),
        bodies=(f'<body name="frame"> {joints} {inertial(made)} <site name="imu"/> </body>',),
        tendons=(f'<fixed name="frame" damping="{own["hinge_damping"]:.12g}"> {turn} </fixed>',),
        positions=(float(begun[0]),),
        speeds=(float(begun[1]) - joint.rate,),
        frame=True,
        step=QUICK,
    )


def tissue(part: Part, joint: Joint) -> Piece:
    """A mass point on two slides and springs of the shank."""
    own, leg = values(part), joint.value
    mass = own["share"] * leg["gravity"] / (GRAVITY * own["radius"])
    if mass < NOTHING:
        return Piece((Kept(part.name, "exact", "no body: it weighs nothing"),))
    rate = 2 * np.pi * own["frequency"]
    spring, damper = mass * rate**2, 2 * own["damping_ratio"] * rate * mass
    said = f'type="slide" stiffness="{spring:.12g}" damping="{damper:.12g}"'
    point = f'<inertial pos="0 0 0" mass="{mass:.12g}" diaginertia="{POINT} {POINT} {POINT}"/>'
    return Piece(
        (Kept(part.name, "exact", 'body "tissue" on two slides'),),
        bodies=(
            f'<body name="tissue" pos="{own["radius"]:.12g} 0 0"> {point} '
            f'<joint name="across" axis="0 0 1" {said}/> <joint name="along" axis="1 0 0" {said}/> '
            "</body>",
        ),
        taken=(mass, mass * own["radius"], mass * own["radius"] ** 2),
        positions=tuple(map(float, part.begun[:2])),
        speeds=tuple(map(float, part.begun[2:])),
        step=QUICK,
    )


def inertial(made: Body) -> str:
    """A body's mass and inertia, its centre on the x axis."""
    return (
        f'<inertial pos="{made.distance:.12g} 0 0" mass="{made.mass:.12g}" '
        f'diaginertia="{made.along:.12g} {made.central:.12g} {made.central:.12g}"/>'
    )


SHAPES: dict[type[Term], Callable[[Part, Joint], Piece]] = {
    ActivationLag: lag,
    CuffCompliance: frame,
    HardStop: stop,
    StiffnessRestAngle: rest_angle,
    WobblingMass: tissue,
}
