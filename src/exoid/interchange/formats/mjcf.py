"""The joint as a model of MuJoCo."""

from collections.abc import Iterable, Mapping

import numpy as np

from exoid.interchange.formats.mujoco.piece import Piece, together
from exoid.interchange.formats.mujoco.pieces import piece_of
from exoid.interchange.formats.mujoco.shapes import inertial
from exoid.interchange.model.body import body
from exoid.interchange.model.described import described, xml_comment
from exoid.interchange.model.drive_over_time import drive_over_time
from exoid.interchange.model.formulas import undriven
from exoid.interchange.model.joint import Exported, Joint, Kept
from exoid.physics.leg import GRAVITY

CLINGS = 2.0  # over the step: how fast dry friction ends a movement, as RK4 still bears it
HELD = "0.9999 0.9999 0.001 0.5 2"  # of dry friction: as hard as MuJoCo allows
WHY = (
    "Integrator RK4: it is the one with which exoid fitted, and the leg is smooth between turns.",
    "The step divides the recording's, so that every sample falls on one; with dry friction, cuffs",
    "or a stop it is short enough for them. mj_step from the keyframe `start` replays the fit.",
)


def mjcf(joint: Joint) -> Exported:
    """The model.

    **Raises** `ValueError` where a term has nothing like it in MuJoCo.
    """
    parts = joint.parts if joint.driven else undriven(joint.parts)
    piece = together(piece_of(part, joint) for part in parts)
    leg, step = joint.value, step_of(joint, piece)
    moment = leg["mass"] * leg["com_distance"]
    shank, odd = body(*np.subtract((leg["mass"], moment, leg["inertia"]), piece.taken).tolist())
    driven = joint.driven or bool(piece.drives)
    text = "\n".join(
        [
            '<mujoco model="leg">',
            xml_comment([*described(joint), "", *([odd, ""] if odd else []), *WHY]),
            '  <compiler angle="radian" autolimits="true"/>',
            f'  <option timestep="{step:.12g}" integrator="RK4" gravity="0 0 {-GRAVITY}"/>',
            *(drive_table(joint, piece) if driven else ()),
            "  <worldbody>",
            f'    <body name="thigh" pos="0 0 1" axisangle="0 -1 0 {joint.thigh_angle:.12g}">',
            '      <body name="shank">',
            f"        {knee(leg, piece, step)}",
            f"        {inertial(shank)}",
            f'        <geom type="capsule" fromto="0 0 0 {2 * abs(shank.distance) + 0.01:.6g} 0 0" '
            'size="0.03" contype="0" conaffinity="0" mass="0"/>',
            *(() if piece.frame else ('        <site name="imu"/>',)),
            *(f"        {each}" for each in piece.bodies),
            "      </body>",
            "    </body>",
            "  </worldbody>",
            *section("tendon", piece.tendons),
            *section("actuator", [motor(piece), *piece.actuators]),
            *section("sensor", sensors(joint, piece)),
            *section("keyframe", [start(joint, piece)]),
            "</mujoco>",
            "",
        ]
    )
    kept = [Kept("leg", "exact", "inertial, stiffness, damping"), *piece.kept]
    if driven:
        kept.append(Kept("drive", "exact", 'numeric "drive_time" and "drive_torque", for ctrl'))
    kept.append(Kept("encoder and gyro", "in words", "noise in the sensors, the rest in a comment"))
    return Exported(text, tuple(kept), (odd,) if odd else ())


def step_of(joint: Joint, piece: Piece) -> float:
    """A part of the time between two samples that is short enough [s]."""
    between = float(np.median(np.diff(joint.times)))
    return between / np.ceil(between / piece.step - 1e-6)


def knee(leg: Mapping[str, float], piece: Piece, step: float) -> str:
    """The joint."""
    first, second, third = piece.damping
    damping = " ".join(f"{each:.12g}" for each in (leg["damping"] + first, second, third))
    said = [
        f'stiffness="{leg["stiffness"]:.12g}" springref="{piece.rest:.12g}"',
        f'damping="{damping if second or third else damping.split()[0]}"',
        *piece.limits,
    ]
    if piece.friction:
        said.append(f'frictionloss="{piece.friction:.12g}" solimpfriction="{HELD}"')
        said.append(f'solreffriction="-1 {-CLINGS / step:.12g}"')
    return f'<joint name="knee" axis="0 -1 0" {" ".join(said)}/>'


def motor(piece: Piece) -> str:
    """What the drive acts through."""
    if piece.lag:
        return (
            f'<general name="drive" joint="knee" dyntype="filter" dynprm="{piece.lag:.12g}" '
            'gainprm="1" biastype="none"/>'
        )
    return '<motor name="drive" joint="knee" gear="1"/>'


def drive_table(joint: Joint, piece: Piece) -> Iterable[str]:
    """The torque over time; MuJoCo's XML has no place for a torque that changes."""
    yield xml_comment(
        [
            "The torque that drove it. Before every mj_step:",
            "  t, torque = (model.numeric(f'drive_{each}').data for each in ('time', 'torque'))",
            "  data.ctrl[0] = numpy.interp(data.time + model.opt.timestep / 2, t, torque)",
        ]
    )
    time, torque = drive_over_time(joint, piece.drives)
    yield from section(
        "custom",
        [
            f'<numeric name="drive_{name}" size="{each.size}" data="{numbers(each)}"/>'
            for name, each in (("time", time), ("torque", torque))
        ],
    )


def numbers(values: Iterable[float]) -> str:
    return " ".join(f"{each:.12g}" for each in values)  # a clock may have run for weeks


def sensors(joint: Joint, piece: Piece) -> Iterable[str]:
    """Encoder and gyro, with the recording's noise."""
    angle = f'noise="{joint.sensing.angle_noise:.6g}"'
    if piece.frame:
        yield f'<tendonpos name="encoder" tendon="frame" {angle}/>'
    else:
        yield f'<jointpos name="encoder" joint="knee" {angle}/>'
    yield '<jointvel name="rate" joint="knee"/>'
    noise = joint.sensing.rate_noise
    told = "" if noise is None else f' noise="{noise:.6g}"'
    yield f'<gyro name="gyro" site="imu"{told}/>'


def start(joint: Joint, piece: Piece) -> str:
    """Where the fitted motion begins."""
    position = exact([joint.angle, *piece.positions])
    speed = exact([joint.rate, *piece.speeds])
    act = "" if piece.carried is None else f' act="{piece.carried:.12g}"'
    return f'<key name="start" time="{joint.times[0]:.12g}" qpos="{position}" qvel="{speed}"{act}/>'


def section(name: str, lines: Iterable[str]) -> Iterable[str]:
    """An element, where there is anything in it."""
    said = list(lines)
    if said:
        yield f"  <{name}>"
        yield from (f"    {each}" for each in said)
        yield f"  </{name}>"


def exact(values: Iterable[float]) -> str:
    return " ".join(repr(float(each)) for each in values)
