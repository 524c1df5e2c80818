"""The recordings of others move as physics says, by independent integrators and by laws."""

import numpy as np
import pytest
from benchmarks.others import hand
from benchmarks.others.leg import Physics
from benchmarks.others.motion import TICK, march, swing_freely
from benchmarks.others.protocol import Drop, Protocol, resting_angle
from benchmarks.others.session import hold_session
from scipy.integrate import solve_ivp

LEG = Physics(inertia=0.45, weight=11.8, stiffness=2.8, damping=0.35)
START = (-0.2, 0.0)


def odd_leg():
    """Everything smooth that Eq. 9 may lack."""
    return LEG._replace(
        tilt=0.02, rest_angle=-0.3, drag=0.05, cubic=1.0, maxwell_stiffness=2.0, maxwell_time=0.4
    )


def test_energy_is_kept_where_nothing_takes_it():
    leg = LEG._replace(damping=0.0, cubic=1.0)
    motion = swing_freely(leg, START, 10.0, TICK)
    energy = (
        leg.inertia * motion.rate**2 / 2
        + leg.weight * np.sin(motion.angle)
        + leg.stiffness * motion.angle**2 / 2
        + leg.cubic * motion.angle**4 / 4
    )
    # order four at 4 kHz: (5 rad/s * 2.5e-4 s)^4 per step, over 40,000 steps
    assert np.ptp(energy) < 1e-8 * leg.weight


def test_a_swing_is_that_of_another_integrator():
    leg = odd_leg()

    def slope(_, y):
        angle, rate, stretch = y
        torque = -leg.weight * np.cos(angle + leg.tilt) - leg.damping * rate
        torque -= leg.stiffness * (angle - leg.rest_angle) + leg.cubic * angle**3
        torque -= leg.drag * rate * abs(rate) + leg.maxwell_stiffness * stretch
        return rate, torque / leg.inertia, rate - stretch / leg.maxwell_time

    motion = swing_freely(leg, START, 6.0, TICK)
    time = np.linspace(0, 6, 301)
    other = solve_ivp(slope, (0, 6), (*START, 0.0), "DOP853", t_eval=time, rtol=1e-11, atol=1e-12).y
    # both are far better than any sensor; |rate| has a kink at every turn
    np.testing.assert_allclose(motion.angle_at(time), other[0], atol=1e-8)
    np.testing.assert_allclose(motion.rate_at(time), other[1], atol=1e-7)


def test_dry_friction_takes_the_same_of_every_half_swing_and_then_holds():
    leg = Physics(inertia=0.5, weight=0.0, stiffness=5.0, damping=0.0, friction=0.2)
    motion = swing_freely(leg, (0.5, 0.0), 10.0, TICK)
    turns = np.flatnonzero((motion.rate[1:-1] == 0) | (np.diff(np.sign(motion.rate[1:])) != 0)) + 1
    extremes = [abs(motion.angle[k]) for k in turns if motion.time[k] < 6.5]
    # a linear spring: the amplitude falls by 2 F_c / c in each half swing, until F_c holds it
    half = np.pi * np.sqrt(leg.inertia / leg.stiffness)
    at_turn = np.abs(motion.angle_at(half * np.arange(7)))
    expected = np.abs(0.5 - 2 * leg.friction / leg.stiffness * np.arange(7))
    np.testing.assert_allclose(at_turn, expected, atol=1e-5)
    assert extremes
    assert motion.rate[-1] == 0
    assert motion.angle[-1] == pytest.approx(0.02, abs=1e-5)  # 0.5 - 6 * 0.08


def test_a_reflex_acts_its_delay_after_the_threshold_and_only_while_flexing():
    leg = LEG._replace(reflex_gain=1.0, reflex_threshold=1.5, reflex_delay=0.05)
    calm, reflex = (swing_freely(each, START, 2.0, TICK) for each in (LEG, leg))
    crossed = calm.time[np.flatnonzero(calm.rate < -leg.reflex_threshold)[0]]
    acts = calm.time[np.flatnonzero(np.abs(reflex.acceleration - calm.acceleration) > 1e-9)[0]]
    assert acts == pytest.approx(crossed + leg.reflex_delay, abs=3 * TICK)
    assert np.max(reflex.angle[: int(1.2 / TICK)] - calm.angle[: int(1.2 / TICK)]) > 0.01


def test_a_stop_only_pushes_and_turns_the_leg_back():
    leg = LEG._replace(stop_angle=-1.8, stop_stiffness=800.0, stop_damping=5.0)
    free, stopped = (swing_freely(each, START, 1.0, TICK) for each in (LEG, leg))
    inside = free.angle > leg.stop_angle
    first = np.flatnonzero(~inside)[0]
    np.testing.assert_array_equal(free.angle[:first], stopped.angle[:first])
    # energy at the stop over its stiffness: some hundredths of a radian
    assert -1.8 - 0.35 < stopped.angle.min() < -1.8
    assert free.angle.min() < stopped.angle.min()


def test_a_hand_holds_still_and_its_torque_is_gone_when_it_has_let_go():
    calm = hand.Tremor(0.0, (5.0, 9.0), (0.0, 0.0))
    drop = Drop(-0.2, 0.5, 0.06, "caught", 1.3, 0.4, 0.0, calm)
    session = hold_session(LEG, Protocol((drop, drop), table=True, hanging=1.0))
    motion = session.motion
    assert motion.angle[0] == pytest.approx(resting_angle(LEG), abs=1e-9)
    for happened in session.drops:
        held = (motion.time > happened.held + 0.05) & (motion.time < happened.released)
        free = (motion.time >= happened.free) & (motion.time < happened.end - TICK / 2)
        # after a lift the leg creeps to where it is held as the damped grip settles
        assert np.ptp(motion.angle[held]) < np.radians(0.01)
        assert motion.angle[held][-1] == pytest.approx(-0.2, abs=1e-4)
        assert np.all(motion.hand[free] == 0)
        assert np.ptp(motion.angle[free]) > 1.0
        late = (motion.time > happened.over - 0.2) & (motion.time < happened.over)
        assert np.abs(motion.rate[late]).max() < 0.05


def test_the_pieces_of_a_session_are_one_motion():
    calm = hand.Tremor(0.003, (5.0, 9.0), (0.3, 1.0))
    drops = tuple(Drop(-0.3, 0.2, 0.05, end, 0.9, 0.3, 0.0, calm) for end in ("rest", "caught"))
    motion = hold_session(odd_leg(), Protocol(drops, table=True, hanging=0.0)).motion
    # the trapezium rule over the rates; its error is a twelfth of jerk times the tick squared
    step = (motion.rate[1:] + motion.rate[:-1]) / 2 * TICK
    np.testing.assert_allclose(np.diff(motion.angle), step, atol=1e-8)
    assert np.all(np.diff(motion.time) > 0)


def test_what_is_seen_ahead_is_what_happens():
    rows = hand.leave(0.5)
    state, past = (-0.2, -1.0, 0.0, 0.0), np.zeros(300)
    whole, _, _ = march(LEG, state, (0.0, 0.0), rows, past, TICK)
    half = hand.leave(0.25)
    first, between, felt = march(LEG, state, (0.0, 0.0), half, past, TICK)
    second, _, _ = march(LEG, between, (0.0, 0.0), half, felt, TICK)
    np.testing.assert_array_equal(whole, np.concatenate([first[:, :-1], second], axis=1))
