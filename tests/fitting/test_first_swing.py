"""A hand that lets go slowly carries a leg while it is slow, a stretch reflex brakes a fast one."""

from dataclasses import replace

import numpy as np
import pytest

from exoid.fitting.estimate import fit
from exoid.fitting.hands.first_swing import FirstSwing, by_energy
from exoid.fitting.hands.kept_back import AS, NEXT, what
from exoid.fitting.hands.slow_release import of_slow
from exoid.fitting.movements import movements_of
from exoid.fitting.result.fit_result import FitResult
from exoid.mismatch.conclude.verdict.begins_and_ends import begins_and_ends, what_next
from exoid.recordings.declared.protocol import Protocol
from exoid.recordings.declared.subject import Subject
from exoid.recordings.recording import Recording
from exoid.report.words.left_out import left_out
from hands import ADULT, Hand, Knee, dropped
from reflexes import ADULT as GROWN
from reflexes import START, measured, stretched

STARTS = 4
FREE = FirstSwing(carried=0.1, braked=0.0, speed=3.0)
HELD = FirstSwing(carried=0.5, braked=0.0, speed=3.0)
TRIPPED = FirstSwing(carried=0.1, braked=0.5, speed=4.0)
BOTH = FirstSwing(carried=0.5, braked=0.5, speed=4.0)
FAST = FirstSwing(carried=0.1, braked=0.0, speed=5.0)


@pytest.mark.parametrize(
    ("drops", "by"),
    [
        ([HELD, HELD], "hand"),
        ([HELD, FREE], "hand"),
        ([FREE, FAST], "neither"),
        ([TRIPPED, TRIPPED], "speed"),
        ([FREE, TRIPPED], "speed"),
        ([FAST, TRIPPED], "unknown"),
        ([HELD, TRIPPED], "unknown"),
        ([BOTH, BOTH], "unknown"),
    ],
    ids=[
        "hands",
        "one hand",
        "no energy",
        "reflexes",
        "one below its threshold",
        "once",
        "one each",
        "both at once",
    ],
)
def test_what_a_speed_trips_brakes_every_fast_leg_and_no_slow_one(drops, by):
    assert by_energy(drops) == by


def test_a_filter_blurs_a_release_as_a_hand_does_and_brakes_no_fast_leg():
    assert by_energy([HELD, HELD], blurred=True) == "filtered"
    assert by_energy([TRIPPED, TRIPPED], blurred=True) == "speed"
    assert "filter" in AS["filtered"]
    assert "as it was measured" in NEXT["filtered"]


def test_where_no_energy_is_missing_a_sensor_is_named_beside_a_spring_and_no_hand_blamed():
    """A goniometer whose gain changes with the angle bends a leg's largest swing most."""
    (whole,) = movements_of([("leg", dropped(ADULT, lasting=5.0)[0])])
    for by, named, blamed in (("neither", "goniometer", False), ("hand", "a hand lets go", True)):
        (note,) = of_slow([replace(whole, slow=0.6, kept_back=by)])
        assert named in note
        assert ("is kept back" in note) is blamed
        assert ("No leg falls like this" in note) is blamed
        assert what(by) in begins_and_ends([replace(whole, slow=0.6, kept_back=by)])[0]
    assert "known angles" in NEXT["neither"]


def kept_back(result: FitResult) -> set[str]:
    assert result.basis is not None
    return {each.kept_back for each in result.basis.problem.movements if each.slow}


@pytest.mark.parametrize("seed", [1, 2])
def test_a_reflex_is_no_hand_by_the_energy_that_is_missing(seed):
    gain = 4.0 + seed  # 1/s
    segments = [
        measured(stretched(GROWN, START, strength * gain, 1.5, 0.045), 100.0, seed=10 * seed + k)
        for k, strength in enumerate((0.8, 1.0, 1.2))
    ]
    body = Subject(kind="leg", body_mass=74.0, height=1.78)
    result = fit(Recording(tuple(segments), body, Protocol(kind="passive")), multistart=STARTS)
    assert result.follows
    assert kept_back(result) == {"speed"}
    (note,) = (note for note in result.notes if "were left out" in note)
    assert "stretch reflex" in note
    assert "but no hand" in note
    assert "to and fro" in left_out(result.segments)
    assert result.basis is not None
    movements = result.basis.problem.movements
    assert "stretch reflex" in begins_and_ends(movements)[0]
    assert "from several angles" in what_next(movements)[0]


def test_a_muscle_that_pulls_on_behind_the_bottom_is_out_of_the_damping():
    """A child before a camera: from the first turn on d / J comes out 2.1 errors too low."""
    knee = Knee(37.94, 3.544, 0.92)
    segments = [
        measured(
            stretched(knee, np.radians(start), 4.56, 2.73, 0.04, rise=0.044, lasting=6.7),
            50.0,
            seed=k,
            noise=0.4,
        )
        for k, start in enumerate((-12.0, -18.0, -25.0))
    ]
    body = Subject(kind="leg", body_mass=24.0, height=1.22)
    result = fit(Recording(tuple(segments), body, Protocol(kind="passive")), multistart=STARTS)
    assert result.follows
    assert kept_back(result) == {"speed"}
    found = result.ratios["damping_over_inertia"]
    assert abs(found.value - knee.damping) < 1.5 * found.standard_error


@pytest.mark.parametrize("fade", [0.3, 0.5])
def test_a_hand_that_lets_go_slowly_is_no_reflex(fade):
    result = fit(dropped(ADULT, Hand(fade=fade), lasting=5.0)[0], multistart=STARTS)
    assert kept_back(result) == {"hand"}
    assert "a quarter of a swing" in left_out(result.segments)


def test_nothing_is_left_out_of_a_drop_that_was_let_go_at_once():
    assert left_out(fit(dropped(ADULT, lasting=5.0)[0], multistart=STARTS).segments) == ""
