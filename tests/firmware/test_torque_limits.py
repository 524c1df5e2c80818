"""What holds of the commanded torque whatever legs, hosts and sensors do.

Held on NumPy float32, which is the firmware to the bit (`test_torque_exactness.py`).
"""

from dataclasses import replace

import numpy as np
import pytest
from float32_torque import (
    ANGLE_STALE,
    ARM,
    ARMED,
    DISABLED,
    ENABLE,
    ENABLED,
    HOST_SILENT,
    LONGEST_UNHEARD,
    NAMES,
    NOT_FINITE,
    OFF,
    SETTLING,
    STEP,
    SWITCHED_OFF,
    F,
    Heard,
    TorqueNodes,
    wanted_torque,
    way,
)
from hypothesis import given
from hypothesis import strategies as st

from exoid.recordings.commissioning.torque_parameters import TorqueParameters, bounds, fields

LEG = TorqueParameters(8.0, 0.1, 2.0, 0.3, 0.2, 0.3, 1.0, 0.5, 0.5, 0.5, 5.0, 50.0)
MOST = 63  # counts of what a host allows: 15.75 N m
LISTENING = SETTLING + 1  # ticks after which nothing stands against arming


def node(leg: TorqueParameters = LEG) -> TorqueNodes:
    return TorqueNodes({name: np.array([getattr(leg, name)], F) for name in NAMES})


def still(wish: int | None, number: int, limit: int = MOST) -> Heard:
    """A leg that rests at 0.5 rad below the horizontal, and a host that says this."""
    some = np.ones(1, int)
    single = (np.array([each], F) for each in (-0.5, 0.0, 0.0))
    host = (np.array([wish is not None]), some * (wish or OFF), some * (number % 16), some * limit)
    return Heard(some * 27552, some * 0, *single, some * 0, *host, np.zeros(1, F))


def enabled() -> tuple[TorqueNodes, int]:
    """A node that commands a torque, and the number of the tick that comes."""
    one = node()
    for tick in range(LISTENING):
        one.tick(still(ARM, tick))
    assert one.permit[0] == ARMED
    for tick in range(LISTENING, LISTENING + 60):
        one.tick(still(ENABLE, tick))
    assert one.permit[0] == ENABLED
    assert one.torque[0] == LEG.limit
    return one, LISTENING + 60


@pytest.mark.parametrize("bit", range(8))
def test_every_fault_bit_cuts_at_the_tick_that_shows_it(bit):
    one, tick = enabled()
    torque, permit, doubts = one.tick(replace(still(ENABLE, tick), faults=np.array([1 << bit])))
    assert (torque[0], permit[0]) == (0.0, DISABLED)
    assert doubts[0] & 1 << bit
    assert stays_off(one, tick + 1)


@pytest.mark.parametrize(
    ("what", "value", "doubt"),
    [
        ("angle", np.nan, NOT_FINITE),
        ("angle", 8.0, NOT_FINITE),
        ("velocity", np.inf, NOT_FINITE),
        ("acceleration", np.nan, NOT_FINITE),
        ("bias", np.nan, ANGLE_STALE),
    ],
)
def test_a_number_that_is_none_cuts_at_its_tick(what, value, doubt):
    one, tick = enabled()
    torque, permit, doubts = one.tick(replace(still(ENABLE, tick), **{what: np.array([value], F)}))
    assert (torque[0], permit[0], doubts[0]) == (0.0, DISABLED, doubt)


def test_a_host_that_is_silent_cuts_ten_ticks_behind_the_one_that_heard_it():
    one, _ = enabled()
    torques = [one.tick(still(None, 0))[0][0] for _ in range(LONGEST_UNHEARD + 5)]
    assert np.flatnonzero(np.array(torques) == 0.0)[0] + 1 == LONGEST_UNHEARD
    assert one.cut_by[0] == HOST_SILENT


def test_the_echo_of_a_frame_is_no_host_but_off_is_off_even_as_an_echo():
    one, tick = enabled()
    torques = [one.tick(still(ENABLE, tick - 1))[0][0] for _ in range(LONGEST_UNHEARD + 1)]
    assert torques[-1] == 0.0
    one, tick = enabled()
    assert one.tick(still(OFF, tick - 1))[0][0] == 0.0
    assert one.cut_by[0] == SWITCHED_OFF


@pytest.mark.parametrize(("rate", "ticks"), [(0.5, 26), (1.0, 12), (3.0, 4), (10.0, 2)])
def test_an_encoder_that_hangs_while_the_gyro_turns_cuts_within(rate, ticks):
    """0.1 rad at `rate` [rad/s], and what is forgotten meanwhile: ln(1 - 0.2 / rate) / ln 0.98."""
    one, tick = enabled()
    gyro = np.array([round(rate / np.radians(0.07))])
    torques = [one.tick(replace(still(ENABLE, tick + k), gyro=gyro))[0][0] for k in range(40)]
    assert np.flatnonzero(np.array(torques) == 0.0)[0] + 1 == pytest.approx(ticks, abs=1)
    assert one.cut_by[0] == ANGLE_STALE


def stays_off(one: TorqueNodes, tick: int) -> bool:
    """Whatever a host goes on to enable, until it arms again."""
    torques = [one.tick(still(ENABLE, tick + k))[0][0] for k in range(2 * SETTLING)]
    rearmed = [one.tick(still(ARM, tick + 2 * SETTLING))[1][0]]
    return not any(torques) and rearmed == [ARMED]


def test_what_is_enabled_without_being_armed_stays_off():
    one = node()
    assert not any(one.tick(still(ENABLE, tick))[0][0] for tick in range(200))


ANY = {
    "leg": st.tuples(*(st.floats(*bounds(each), width=32) for each in fields(TorqueParameters))),
    "ticks": st.lists(
        st.tuples(
            st.floats(width=32),  # angle
            st.floats(width=32),  # velocity
            st.floats(width=32),  # acceleration
            st.sampled_from([None, OFF, ARM, ARM, ENABLE, ENABLE, ENABLE, ENABLE]),
            st.integers(0, 15),
            st.integers(0, MOST),
            st.sampled_from([0] * 20 + [1, 128]),
        ),
        max_size=60,
    ),
}


@given(**ANY)
def test_no_sequence_leads_beyond_the_limits(leg, ticks):
    """A step may be larger by the rounding of a sum of float32: two units in the last place."""
    parameters = TorqueParameters(*leg)
    one, before, unheard = node(parameters), 0.0, LONGEST_UNHEARD
    for tick in range(LISTENING):
        one.tick(still(ARM, tick))
    allowed = MOST * 0.25
    for angle, velocity, acceleration, wish, number, limit, faults in ticks:
        now = replace(
            still(wish, number, limit),
            angle=np.array([angle], F),
            velocity=np.array([velocity], F),
            acceleration=np.array([acceleration], F),
            faults=np.array([faults]),
        )
        counts = wish is not None and number != one.number[0]
        unheard = 0 if counts else unheard + 1
        allowed = limit * 0.25 if counts and wish == ARM else allowed
        torque, permit, _ = (each[0] for each in one.tick(now))
        assert np.isfinite(torque)
        assert abs(torque) <= min(parameters.limit, allowed)
        if torque != 0.0:
            assert permit == ENABLED
            assert faults == 0
            assert unheard < LONGEST_UNHEARD
            step = F(parameters.rate_limit) * STEP
            assert abs(torque - before) <= step + 2 * np.spacing(F(MOST))
        before = torque


@given(angle=st.floats(-8, 8, width=32, exclude_min=True, exclude_max=True))
def test_all_of_a_leg_that_is_taken_off_is_what_acts_on_it(angle):
    """The order of the sums and the sine's own 1e-7 make 2e-6 N m of these."""
    shares = ("gravity_share", "stiffness_share", "damping_share", "friction_share")
    leg = replace(LEG, **dict.fromkeys(shares, 1.0))
    given = {name: np.array([getattr(leg, name)], F) for name in NAMES}
    at, velocity = np.array([angle], F), np.array([0.7], F)
    torque = wanted_torque(given, at, velocity, np.array([2.0], F))[0]
    leg_own = 8.0 * np.cos(angle + 0.1) + 2.0 * angle + 0.3 * 0.7 + 0.2
    assert torque == pytest.approx(0.3 * 2.0 + leg_own, abs=1e-5)


def test_the_way_goes_smoothly_through_rest():
    velocity = np.linspace(-0.3, 0.3, 6001).astype(F)
    found = way(velocity)
    assert np.all(np.diff(found) >= 0)
    assert np.all(found[velocity >= 0.1] == 1.0)
    np.testing.assert_array_equal(found, -found[::-1])
    assert np.diff(found).max() == pytest.approx(15 * 1e-4, rel=1e-2)  # its slope is 15 s/rad
