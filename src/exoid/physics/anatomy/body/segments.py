"""Shank and foot as two rigid segments that hang from the knee, the ankle at a right angle."""

from math import hypot
from typing import NamedTuple

# Where the foot hangs, as fractions of body height. Below the ankle: Dumas 2007, 40 mm at 1.77 m.
# Ahead of it: de Leva 1996 (44 % of 0.148 H from the heel) less heel to ankle, about 0.034 H.
FOOT_BELOW = 0.0226
FOOT_AHEAD = 0.0316


class Fractions(NamedTuple):
    """What a table says: masses of body mass, lengths of body height or segment length."""

    shank_mass: float
    foot_mass: float
    shank_length: float  # knee to ankle, of body height
    shank_com: float  # from the knee, of shank length
    shank_gyration: float  # about the shank's COM, flexion axis, of shank length
    foot_gyration: float  # about the foot's COM, flexion axis, of body height
    foot_below: float = FOOT_BELOW  # COM of the foot below the ankle, of body height
    foot_ahead: float = FOOT_AHEAD  # and ahead of it


def leg_mass(part: Fractions, body_mass: float) -> float:
    """Eq. 5-6: shank and foot as fractions of body mass."""
    return (part.shank_mass + part.foot_mass) * body_mass


def com_distance(part: Fractions, height: float, shank_length: float) -> float:
    """Eq. 7: the norm of the mass-weighted mean of both COM, d_S and d_F, seen from the knee."""
    below, ahead = foot_com(part, height, shank_length)
    whole = part.shank_mass + part.foot_mass
    down = (part.shank_mass * part.shank_com * shank_length + part.foot_mass * below) / whole
    return hypot(down, part.foot_mass * ahead / whole)


def two_segment_inertia(
    part: Fractions, body_mass: float, height: float, shank_length: float
) -> float:
    """J = sum of m (distance^2 + gyration^2) over shank and foot, about the knee (Steiner)."""
    below, ahead = foot_com(part, height, shank_length)
    shank = (part.shank_com**2 + part.shank_gyration**2) * shank_length**2
    foot = below**2 + ahead**2 + (part.foot_gyration * height) ** 2
    return body_mass * (part.shank_mass * shank + part.foot_mass * foot)


def foot_com(part: Fractions, height: float, shank_length: float) -> tuple[float, float]:
    """d_F: how far the foot's COM lies below the knee and ahead of the shank [m]."""
    return shank_length + part.foot_below * height, part.foot_ahead * height
