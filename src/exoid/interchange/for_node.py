"""What a node takes of a fitted leg, to command a torque by it."""

from collections.abc import Iterable
from dataclasses import asdict, dataclass

import jax

from exoid.fitting.result.fit_result import FitResult
from exoid.interchange.export import doubts
from exoid.interchange.model.gather import gather
from exoid.interchange.model.joint import Joint, Part
from exoid.mismatch.answer.diagnosis import Diagnosis
from exoid.physics.terms.device.coulomb_friction import CoulombFriction
from exoid.recordings.commissioning.torque_parameters import TorqueParameters

ROUNDING = 1e-6  # by which a solver may stop beyond its bound of 0
UNTOLD = (
    "nothing told the leg's inertia, and its ratios alone make no torque in N m. Fit with body "
    "mass and height or with a known mass, or give the inertia where you know it."
)
TOLD = "the fit has told the leg's inertia: another is given only where it has not."
NO_COUNTERPART = (
    "a node has nothing that acts like {names}: it holds gravity, stiffness, damping and one level "
    "of dry friction. Fit without, or take the header of exoid export --as c."
)


@dataclass(frozen=True)
class Wanted:
    """What of a leg the motor is to take off, from 0 to 1 of each, and within what limits."""

    gravity_share: float
    stiffness_share: float
    damping_share: float
    friction_share: float
    limit: float  # N m
    rate_limit: float  # N m/s


@dataclass(frozen=True)
class ForNode:
    """The parameters, and the terms that do not act on the leg and stay behind."""

    parameters: TorqueParameters
    left: tuple[str, ...]


def for_node(
    found: FitResult | Diagnosis,
    wanted: Wanted,
    *,
    segment: int | None = None,
    inertia: float | None = None,
) -> ForNode:
    """The parameters of a fitted leg: bare, or with the added mass of one of its segments.

    `inertia` [kg m^2] is for a fit that knows ratios alone.

    **Raises** `ValueError` where a node cannot hold the leg, by the names of its terms; where its
    inertia is not known; where the fit is not to be trusted; and as `gather` does.
    """
    result = found.fit if isinstance(found, Diagnosis) else found
    with jax.enable_x64(True):
        joint = gather(result, segment)
    for doubt in doubts(found, result):
        raise ValueError(doubt)
    untold = result.parameters["inertia"].value is None
    if untold is (inertia is None):
        raise ValueError(UNTOLD if untold else TOLD)
    acting = [part for part in joint.parts if part.pushes and not part.term.voluntary]
    scale = 1.0 if inertia is None else inertia / joint.value["inertia"]
    leg = {name: scale * value for name, value in held(joint, acting).items()}
    parameters = TorqueParameters(thigh_angle=joint.thigh_angle, **leg, **asdict(wanted))
    parameters.check()
    left = tuple(part.name for part in joint.parts if part not in acting)
    return ForNode(parameters, left)


def held(joint: Joint, acting: Iterable[Part]) -> dict[str, float]:
    """What has a unit with a mass in it.

    **Raises** `ValueError` for terms that act otherwise.
    """
    acting = list(acting)
    others = [part for part in acting if not isinstance(part.term, CoulombFriction)]
    if others:
        names = ", ".join(f"{part.name} ({part.title})" for part in others)
        raise ValueError(NO_COUNTERPART.format(names=names))
    own = {name: joint.value[name] for name in ("gravity", "stiffness", "damping", "inertia")}
    own |= {"friction": sum(part.values[f"{part.name}_level"] for part in acting)}
    return {name: 0.0 if -ROUNDING < value < 0.0 else value for name, value in own.items()}
