"""How far a leg's parameters may lie from what its body lets expect, and those of any human."""

from typing import NamedTuple

from exoid.physics.anatomy.body.size import Body
from exoid.physics.anatomy.expect import expected_leg
from exoid.physics.anatomy.expected import ExpectedLeg

# Ten scatters and more, an exoskeleton below the knee included; of a knee, a hundred times a
# relaxed one's: five times as much as in the stiffest of twenty.
MASS = 3.0
COM_DISTANCE = 2.0
INERTIA = 6.0
KNEE = 100.0
TORQUE = 250.0 / (77.0 * 1.80)  # N m/(kg m): Eq. 13's for its subject, muscles by mass and height

SMALLEST = Body(2.5, 0.45)  # a newborn
GREATEST = Body(300.0, 2.20)


class Allowed(NamedTuple):
    """Lowest and highest of a parameter."""

    lower: float
    upper: float


def allowed(leg: ExpectedLeg) -> dict[str, Allowed]:
    """What a fit may find of this leg, by parameter."""
    return {
        "mass": around(leg.mass.value, MASS),
        "inertia": around(leg.inertia.value, INERTIA),
        "com_distance": around(leg.com_distance.value, COM_DISTANCE),
        "damping": Allowed(0.0, KNEE * leg.damping.value),
        "stiffness": Allowed(0.0, KNEE * leg.stiffness.value),
    }


def anybody() -> dict[str, Allowed]:
    """What a fit may find of any human, from a newborn to 300 kg."""
    small, great = (allowed(expected_leg(body.mass, body.height)) for body in (SMALLEST, GREATEST))
    return {name: Allowed(small[name].lower, great[name].upper) for name in small}


def strongest(body: Body | None) -> float:
    """Amplitude of a voluntary torque that no such body exceeds [N m]."""
    one = GREATEST if body is None else body
    return TORQUE * one.mass * one.height


def around(value: float, factor: float) -> Allowed:
    return Allowed(value / factor, value * factor)
