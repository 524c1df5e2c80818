"""A body as anthropometry sees it, and what no body can be."""

from math import hypot
from typing import Literal, NamedTuple

Sex = Literal["female", "male"]

BUILDS = (9.0, 80.0)  # kg/m2, body mass over height squared: from starved to the heaviest
# Knee to toe, ankle at a right angle: 0.285 H down to the sole, 0.118 H forward (Winter 2009).
REACH = hypot(0.285, 0.118)


class Body(NamedTuple):
    """Whose leg."""

    mass: float  # kg
    height: float  # m
    sex: Sex | None = None
    age: float | None = None  # years

    @property
    def mass_index(self) -> float:
        """kg/m^2."""
        return self.mass / self.height**2


def reach(height: float) -> float:
    """The greatest distance of any mass of the leg from the knee axis [m]: 0.555 m at 1.80 m.

    Knee to toe with the ankle at a right angle. With it J <= reach m l holds for every such leg,
    the upper bound that Eq. 12 lacks.
    """
    check_height(height)
    return REACH * height


def check_body(body: Body) -> None:
    """Refuse what is not one person in kg and m."""
    if body.sex not in (None, "female", "male"):
        raise ValueError(f"sex is {body.sex!r}; it can be 'female', 'male' or None (their mean).")
    check_height(body.height)
    if not 2.0 <= body.mass <= 400.0:
        raise ValueError(f"body_mass {body.mass:g} kg is no person's. Is it in grams or pounds?")
    if not BUILDS[0] <= body.mass_index <= BUILDS[1]:
        raise ValueError(
            f"body_mass {body.mass:g} kg and height {body.height:g} m make a body mass index of "
            f"{body.mass_index:.3g}, beyond {BUILDS[0]:g} to {BUILDS[1]:g}. Check both: the "
            "mass in kilograms, the height in metres."
        )


def check_height(height: float) -> None:
    if not 0.4 <= height <= 2.6:
        raise ValueError(f"height {height:g} m is no person's. It must be in metres; is it in cm?")
