"""Drops that a hand ends unseen: the leg is stopped softly near where it would rest, and kept."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from exoid.fitting.estimate import fit
from exoid.fitting.hands.last_instants import ended, swung
from exoid.fitting.movements import movements_of
from exoid.recordings.declared.protocol import Protocol
from exoid.recordings.declared.subject import Subject
from exoid.recordings.measured.segment import Segment
from exoid.recordings.recording import Recording
from hands import ADULT, Device, Hand, Knee, dropped

STIFF = Knee(27.0, 30.0, 2.0)
CAMERA = Device(60.0, np.radians(0.3), None)
STARTS = 4
TRUTH = {
    "gravity_over_inertia": STIFF.gravity,
    "stiffness_over_inertia": STIFF.stiffness,
    "damping_over_inertia": STIFF.damping,
}


def session(*stops: float) -> Recording:
    """A drop for every time after the release at which a hand stops the leg."""
    each = [
        dropped(STIFF, Hand(start=-0.3 - 0.1 * n, stop=stop), CAMERA, lasting=5.0, seed=n)[0]
        for n, stop in enumerate(stops)
    ]
    return replace(each[0], segments=tuple(one.segments[0] for one in each))


def kept(result):
    return [each.kept for each in result.basis.problem.movements]


def check_truth(result):
    for name, truth in TRUTH.items():
        found = result.ratios[name]
        assert abs(found.value - truth) < 4 * found.standard_error


@pytest.mark.proof
@pytest.mark.parametrize("stop", [1.6, 2.0])
def test_a_hand_that_keeps_one_leg_near_its_rest_moves_no_number(stop):
    result = fit(session(np.inf, stop, np.inf), multistart=STARTS)
    assert result.basis.problem.movements[1].extent.ended == "at rest"  # it looks like one
    first, second, third = kept(result)
    assert (first, third) == (None, None)
    assert 0 < second / CAMERA.rate < stop
    assert result.disturbance.kinds["passive"].cause is None
    assert any("stops the leg" in note for note in result.notes)
    check_truth(result)


@pytest.mark.proof
def test_one_leg_that_is_left_alone_tells_what_hands_did_to_all_others():
    result = fit(session(2.0, np.inf, 2.0, 2.0), multistart=STARTS)
    first, alone, *others = kept(result)
    assert alone is None
    assert all(each is not None for each in (first, *others))
    check_truth(result)


@pytest.mark.proof
def test_legs_that_rest_by_themselves_keep_their_rest():
    result = fit(session(np.inf, np.inf), multistart=STARTS)
    assert kept(result) == [None, None]
    check_truth(result)


@pytest.mark.proof
def test_a_single_drop_has_nobody_to_contradict_it():
    result = fit(session(2.0), multistart=STARTS)
    assert kept(result) == [None]


def caught(number: int, start: float, at: float, seed: int) -> Segment:
    """A drop that a hand takes over within 0.35 s, from that time on, and leads to its rest."""
    rng, step = np.random.default_rng(10 * seed + number), 0.01

    def slope(t, y):
        grip = min(max((t - at) / 0.35, 0.0), 1.0)
        return y[1], ADULT.pull(y[0], y[1]) - grip * (90.0 * (y[0] + 1.35) + 10.0 * y[1])

    free = np.arange(0.0, 3.8, step)
    found = solve_ivp(
        slope, (0.0, 3.8), [start, 0.0], t_eval=free, rtol=1e-9, atol=1e-10, max_step=0.02
    ).y
    angle, rate = np.concatenate([np.repeat([[start], [0.0]], 60, axis=1), found], axis=1)
    return Segment(
        step * np.arange(angle.size),
        raw_angle=angle + 6e-4 * rng.standard_normal(angle.size),
        raw_angular_velocity=rate + 2e-3 * rng.standard_normal(angle.size),
    )


def softly_caught(seed: int) -> Recording:
    """A hand ends every drop amid its swings."""
    drops = zip((-0.3, -0.65, -1.0), (2.0, 1.6, 1.8), strict=True)
    segments = [caught(number, *each, seed) for number, each in enumerate(drops)]
    body = Subject(kind="leg", body_mass=74.0, height=1.78)
    return Recording(tuple(segments), body, Protocol(kind="passive"))


def test_a_movement_says_up_to_when_it_is_fitted_where_a_hand_ended_it():
    """A hand of 0.35 s is felt within 0.2 s, and the swing in which it comes is left out from its
    begin on; the paper's clipping keeps what it does.
    """
    by_hand, free = caught(0, -0.3, 2.0, 1), caught(0, -0.3, np.inf, 1)
    body = Subject(kind="leg", body_mass=74.0, height=1.78)
    both = [("leg", Recording((by_hand, free), body, Protocol(kind="passive")))]
    ended_by_hand, whole = movements_of(both)
    assert 0.6 + 2.0 - 0.5 < ended_by_hand.caught < 0.6 + 2.0 + 0.2
    assert whole.caught is None
    assert {each.caught for each in movements_of(both, clip="paper")} == {None}
    later = ended(whole, int(np.searchsorted(whole.segment.time, 1.5)))
    assert later.caught == pytest.approx(whole.segment.begins + 1.5, abs=0.02)


@pytest.mark.slow
@pytest.mark.parametrize("seed", [1, 2])
def test_swings_before_hands_that_end_every_drop_softly_tell_the_leg(seed):
    """Friction that ends such swings would take as much from each before."""
    result = fit(softly_caught(seed), multistart=STARTS)
    assert result.follows
    assert all(each.caught is not None for each in result.segments)
    for name in ("gravity", "stiffness", "damping"):
        found = result.ratios[f"{name}_over_inertia"]
        assert abs(found.value - getattr(ADULT, name)) < 4 * found.standard_error
    assert result.ratios["gravity_over_inertia"].standard_error < 0.1


def test_only_a_hand_ends_a_wide_swing_within_one():
    (whole,) = movements_of([("leg", dropped(Knee(damping=2.0), lasting=8.0)[0])])
    early, late = (int(np.searchsorted(whole.segment.time, at)) for at in (1.5, 5.0))
    assert swung(replace(whole, kept=early))
    assert not swung(replace(whole, kept=late))
    assert swung(whole)
