"""The ranges of a rig's terms go with the size of its torque, its angle and its time."""

import pytest

from exoid.fitting.data.size_of_rig import beside
from exoid.physics.library import library
from exoid.physics.parameter import declarations
from exoid.physics.scale import AS_A_LEG, Scale, powers, ranged

POWERS = {
    "N m": (1, 0, 0),
    "N m/rad": (1, -1, 0),
    "N m s/rad": (1, -1, 1),
    "N m s^2/rad^2": (1, -2, 2),
    "N m/rad^3": (1, -3, 0),
    "kg m^2": (1, -1, 2),  # N m over rad/s^2
    "rad/(N m)": (-1, 1, 0),
    "rad/s": (0, 1, -1),
    "Hz": (0, 0, -1),
    "1": (0, 0, 0),
    "m": (0, 0, 0),  # a length is of the rig's making, and no angle
}
DECLARED = [each for term in library() for _, each in declarations(term)]


@pytest.mark.parametrize("unit", POWERS)
def test_a_unit_is_made_of_torque_angle_and_time(unit):
    assert powers(unit) == POWERS[unit]


def test_every_unit_of_the_library_is_understood():
    assert {each.unit for each in DECLARED} <= {*POWERS, "rad", "s", "kg"}


def test_a_leg_has_what_is_declared():
    assert all(ranged(each, AS_A_LEG) is each for each in DECLARED)
    assert beside(3.0, 1.0) == 1.0  # a rig about as large as a leg is as a leg


def test_a_rig_has_at_least_a_legs_range_and_begins_as_much_farther_off():
    small = Scale(torque=1e-2, angle=1e-3, time=1e-2)
    for each in DECLARED:
        own = ranged(each, small)
        assert own.lower <= each.lower
        assert own.upper >= each.upper
        factor = small.of(each.unit)
        if not callable(each.starts):
            assert own.starts == pytest.approx(tuple(factor * start for start in each.starts))
