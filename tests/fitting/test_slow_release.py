"""Drops whose hand lets go over a quarter of a second or more: the swings after it tell the leg."""

from dataclasses import dataclass

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from exoid.fitting.estimate import fit
from exoid.fitting.hands.first_swing import bottom, fastest
from exoid.fitting.hands.slow_release import begun
from exoid.fitting.movements import movements_of
from exoid.fitting.multistart.settle import settle
from exoid.mismatch.conclude.verdict.begins_and_ends import begins_and_ends, what_next
from exoid.mismatch.prepare import prepare
from exoid.recordings.declared.protocol import Protocol
from exoid.recordings.declared.subject import Subject
from exoid.recordings.loading.named import named_recordings
from exoid.recordings.measured.segment import Segment
from exoid.recordings.recording import Recording
from hands import ADULT, Hand, Knee, dropped

TRUTH = ("gravity", "stiffness", "damping")
STARTS = 4
HELD = 120  # samples


def drop(fade: float, knee: Knee = ADULT):
    return dropped(knee, Hand(fade=fade), lasting=5.0)[0]


def slow(result):
    return [each.slow for each in result.basis.problem.movements]


@pytest.mark.parametrize("fade", [0.3, 0.5, 0.7])
def test_a_leg_that_is_let_go_slowly_is_told_by_its_swings_after_that(fade):
    result = fit(drop(fade), multistart=STARTS)
    assert result.follows
    assert slow(result)[0] > fade / 2  # by then a soft hand carries less than half
    assert any("lets go slowly" in note for note in result.notes)
    for name in TRUTH:
        found = result.ratios[f"{name}_over_inertia"]
        assert abs(found.value - getattr(ADULT, name)) < 4 * found.standard_error
    # a hundredth of the leg's own; with the hand in the fit it is as large as that
    assert result.ratios["damping_over_inertia"].standard_error < 0.01 * ADULT.damping


def test_a_leg_that_is_let_go_quickly_keeps_its_fall():
    assert slow(fit(drop(0.05), multistart=STARTS)) == [0.0]


@dataclass(frozen=True)
class InAir:
    """ADULT, which the air slows down by a torque that goes with the square of its speed."""

    drag: float  # over J

    def pull(self, angle, rate):
        return ADULT.pull(angle, rate) - self.drag * rate * np.abs(rate)


def test_what_acts_in_every_swing_is_no_hand():
    """Most of it acts in the fall, as of a hand, and the fit follows it as roughly."""
    result = fit(dropped(InAir(drag=0.1), lasting=5.0)[0], multistart=STARTS)
    assert result.follows
    assert result.disturbance.like("passive").cause == "torque"
    assert slow(result) == [0.0]


def test_a_glance_ends_where_its_answer_is_plain(monkeypatch):
    """What is held closer misses more: only the fit whose numbers are told meets the limits."""
    seen = []

    def noting(*given):
        seen.append(given)
        return settle(*given)

    monkeypatch.setattr("exoid.fitting.multistart.search.settle", noting)
    fit(dropped(InAir(drag=0.1), lasting=5.0)[0], multistart=STARTS)
    assert len(seen) == 1


def led(swings: float, seed: int) -> Recording:
    """A hand lowers the leg ever faster for 0.6 s, lets it swing, and lifts it softly again."""
    rng, step = np.random.default_rng(seed), 0.01
    lowering = np.linspace(0.0, np.radians(-25.0), 60)
    begin = np.radians(-15.0) + step * np.cumsum(lowering)
    time = np.arange(0.0, swings, step)
    free = solve_ivp(
        lambda _, y: [y[1], ADULT.pull(y[0], y[1])],
        (0.0, swings),
        [begin[-1], lowering[-1]],
        t_eval=time,
        rtol=1e-9,
        atol=1e-10,
    ).y
    up = np.linspace(0.0, 1.0, 180)  # of a lift by 50 deg, as softly as a hand can
    lift = free[0, -1] + np.radians(50.0) * (10 * up**3 - 15 * up**4 + 6 * up**5)
    speed = np.radians(50.0) / 1.8 * (30 * up**2 - 60 * up**3 + 30 * up**4)
    held = np.full(HELD, np.radians(-15.0))
    angle = np.concatenate([held, begin, free[0, 1:], lift[: HELD // 2]])
    rate = np.concatenate([0 * held, lowering, free[1, 1:], speed[: HELD // 2]])
    segment = Segment(
        step * np.arange(angle.size),
        raw_angle=angle + 1e-3 * rng.standard_normal(angle.size),
        raw_angular_velocity=rate + 3e-3 * rng.standard_normal(angle.size),
    )
    body = Subject(kind="leg", body_mass=74.0, height=1.78)
    return Recording((segment,), body, Protocol(kind="passive"))


@pytest.mark.slow
def test_a_leg_that_a_hand_led_is_told_by_its_swings():
    result = fit(led(swings=10.0, seed=1), multistart=STARTS)
    assert result.follows
    assert slow(result)[0] > 0.5
    for name in TRUTH:
        found = result.ratios[f"{name}_over_inertia"]
        assert abs(found.value - getattr(ADULT, name)) < 4 * found.standard_error


@pytest.mark.parametrize("swings", [6.0, 10.0, 12.0])
def test_swings_that_follow_a_fall_in_a_hand_end_before_a_soft_lift(swings):
    """Such a fall makes the law of a free leg so rough that a lift goes by it."""
    (whole,) = movements_of([("led", led(swings, seed=1))])
    each = begun(whole, fastest(whole))
    lift = 0.01 * (HELD + 60) + swings  # s; it moves the leg by 0.1 deg in its first 0.1 s
    assert lift - 1.0 < each.segment.begins + each.segment.time[-1] < lift + 0.1


@dataclass(frozen=True)
class Stiff:
    """ADULT in a hinge with dry friction, which stops it after a few swings."""

    dry: float  # over J [1/s^2]

    def pull(self, angle, rate):
        return ADULT.pull(angle, rate) - self.dry * np.tanh(rate / 0.02)


@pytest.mark.parametrize(("dry", "start"), [(0.7, -64.0), (0.8, -62.0), (1.0, -60.0), (1.1, -57.0)])
def test_a_leg_that_stops_soon_after_its_bottom_keeps_the_swings_behind_it(dry, start):
    """Too few samples there are surely free, so that nothing tells how a free leg moves."""
    hand = Hand(start=np.radians(start))
    (whole,) = movements_of([("stiff", dropped(Stiff(dry), hand, lasting=5.0, seed=1)[0])])
    count = bottom(whole)
    assert count > 0
    assert begun(whole, count).angle.size == whole.angle.size - count


def test_no_hand_is_looked_for_where_it_let_go_at_once_by_the_user_s_word():
    result = fit(drop(0.5), multistart=STARTS, at_once=True)
    assert slow(result) == [0.0]
    assert not result.follows


def test_a_drop_without_swings_after_it_stays_refused():
    result = fit(drop(0.7, Knee(28.0, 5.0, 12.0)), multistart=STARTS)
    assert slow(result) == [0.0]


def test_a_diagnosis_that_finds_nothing_in_the_swings_speaks_of_the_hand():
    named = named_recordings(drop(0.5))
    prepared, _ = prepare(fit(named, multistart=STARTS), named, ())
    movements = prepared.problem.movements
    assert "a hand lets go slowly" in begins_and_ends(movements)[0]
    assert what_next(movements) == ["Let go at once."]
