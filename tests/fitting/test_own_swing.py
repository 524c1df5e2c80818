"""What a swing shows of itself, whatever limits a model has: its pull, and if gravity turns it."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from exoid.fitting.data.segment import movement
from exoid.fitting.result.refused.own_swing import own_swing
from legs import drop, recording

LEG = (26.5, 6.0, 0.8)  # m l g / J and c / J [1/s^2], d / J [1/s]
STARTS = (-0.2, -0.45, -0.7)


def asked(*segments, **tables):
    whole = recording(*segments, **tables)
    return own_swing([movement(whole, at, f"drop {at}") for at in range(len(segments))])


def test_gravity_and_a_spring_draw_a_leg_about_its_rest_with_their_sum():
    swing = asked(*(drop(LEG, at, gyro=False) for at in STARTS))
    assert swing is not None
    assert swing.smooth
    assert not swing.level
    assert swing.pull == pytest.approx(LEG[0] + LEG[1], rel=0.08)  # at -75 deg the sine is 0.97


@pytest.mark.parametrize("rate", [0.5, 1.5, 2.0])
def test_the_pull_goes_with_the_square_of_the_clock(rate):
    made = (drop(LEG, at, gyro=False) for at in STARTS)
    swing = asked(*(replace(each, time=rate * each.time) for each in made))
    assert swing is not None
    assert swing.smooth
    assert swing.pull == pytest.approx((LEG[0] + LEG[1]) / rate**2, rel=0.1)


def test_a_spring_alone_is_told_from_gravity_by_how_it_grows():
    """Of 45 deg gravity's pull grows 5 % less than in proportion, a linear spring's does not."""
    swing = asked(*(drop((0.0, 18.0, 0.8), at, slack=-0.9, gyro=False) for at in STARTS))
    assert swing is not None
    assert swing.level
    assert swing.pull == pytest.approx(18.0, rel=0.08)


def test_dry_friction_is_nothing_that_a_pull_explains():
    time = np.arange(0.0, 4.0, 0.01)

    def slope(_, state):
        angle, speed = state
        draws = LEG[0] * np.cos(angle) + LEG[1] * angle + LEG[2] * speed
        return [speed, -draws - 4.0 * np.tanh(speed / 0.01)]

    def rubbing(start):
        found = solve_ivp(slope, (0.0, 4.0), [start, 0.0], t_eval=time, max_step=0.005)
        return replace(drop(LEG, start, gyro=False), time=time, raw_angle=found.y[0])

    swing = asked(*map(rubbing, STARTS))
    assert swing is not None
    assert not swing.smooth
    assert not swing.level


def test_a_leg_that_a_muscle_moves_or_that_bears_a_mass_is_not_asked():
    made = [drop(LEG, at, gyro=False) for at in STARTS]
    subject = replace(recording(*made).subject, added_mass=1.0, added_mass_distance=0.3)
    assert asked(*made, subject=subject) is None
