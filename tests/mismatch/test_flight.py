"""What a recording itself tells of a frame with play, on two bodies that SciPy moved."""

from dataclasses import replace
from types import SimpleNamespace
from unittest.mock import Mock

import numpy as np
import pytest

from exoid.fitting.estimate import fit
from exoid.fitting.model.coordinates import flattened
from exoid.mismatch import prepare as preparing
from exoid.mismatch.flight.accelerations import accelerations
from exoid.mismatch.flight.laws import of_frame, of_leg, straight
from exoid.mismatch.flight.starts import partners, starts_in_flight
from exoid.mismatch.prepare import prepare
from exoid.mismatch.screen.prepared_recording import PreparedRecording
from exoid.physics.terms.device.backlash import Backlash
from exoid.physics.terms.device.coulomb_friction import CoulombFriction
from exoid.physics.terms.tissue.quadratic_drag import QuadraticDrag
from small_library import SMALL
from two_bodies import Frame, Leg, Session, recorded

ADULT, SMALL_LEG = Leg(), Leg(0.21, 7.4, 0.6, 0.12, friction=0.2)
LIGHT, HEAVY = Frame(), Frame(0.02, 0.018, 1.3, 0.06, 0.012, 1200.0, 0.7)
QUICKLY = Session(rate=200.0)


def seen(leg, frame, how):
    """Its accelerations."""
    recording = recorded(leg, frame, how)
    rows = {
        "time": [each.time for each in recording.segments],
        "angular_velocity": [each.raw_angular_velocity for each in recording.segments],
    }
    rows = {name: np.stack(each) for name, each in rows.items()}
    weight = np.full(rows["time"].shape, 1 / how.gyro_noise)
    angle = np.stack([each.raw_angle for each in recording.segments])
    shown = SimpleNamespace(**rows, velocity_weight=weight)
    motion = SimpleNamespace(angle=angle)
    return accelerations(Mock(spec=PreparedRecording, seen=shown, measured_motion=motion))


PLAYING = {
    "light": (ADULT, LIGHT, Session()),
    "light, 200 Hz": (ADULT, LIGHT, QUICKLY),
    "heavy": (ADULT, HEAVY, QUICKLY),
    "dry friction": (SMALL_LEG, HEAVY, Session()),
    "dry friction, 200 Hz": (SMALL_LEG, HEAVY, QUICKLY),
}


@pytest.mark.parametrize("name", PLAYING)
def test_before_strikes_the_frame_shows_its_own_law_and_between_them_the_leg_its_own(name):
    leg, frame, how = PLAYING[name]
    along = seen(leg, frame, how)
    law = of_frame(along)
    assert law is not None
    swings = np.array([frame.gravity, frame.damping, frame.friction]) / frame.inertia
    assert law[0] == pytest.approx(swings[0], rel=0.02)
    assert law[1:] == pytest.approx(swings[1:], abs=0.5)  # of what slows it, of which one the other
    rubbing = -np.sign(along.angular_velocity)
    own, _ = of_leg(along, law, frame.inertia / leg.inertia, rubbing)
    expected = np.array([leg.gravity, leg.stiffness, leg.damping, leg.friction]) / leg.inertia
    assert own[0] == pytest.approx(expected[0], rel=0.05)
    assert own[1:] == pytest.approx(expected[1:], abs=0.45)  # a start, and no more


def test_nothing_is_told_of_a_frame_where_nothing_strikes():
    along = seen(ADULT, Frame(half_play=0.0, friction=0.0, stiffness=3000.0), Session())
    assert not along.flying.any()
    assert of_frame(along) is None
    assert along.joined.any()


def test_a_line_is_straight_through_most_of_what_is_seen():
    random = np.random.default_rng(0)
    columns = random.normal(size=(200, 2))
    value = columns @ [3.0, -2.0] + random.normal(0, 0.05, 200)
    value[:40] += 30.0  # of another law
    assert straight(columns, value)[0] == pytest.approx([3.0, -2.0], abs=0.05)


@pytest.fixture(scope="module")
def sticking():
    """A leg with dry friction in a frame with play, prepared."""
    patch = pytest.MonkeyPatch()
    patch.setattr(preparing, "library", lambda: SMALL)
    recordings = [("drops", recorded(SMALL_LEG, HEAVY, QUICKLY))]
    yield prepare(fit(recordings), recordings)
    patch.undo()


def test_the_other_cause_is_seen_between_strikes_and_both_begin_near_where_they_are(sticking):
    prepared, base = sticking
    others = (QuadraticDrag, CoulombFriction, Backlash)
    (beside, *_) = partners(prepared, others, base.candidate)
    assert beside.terms == (CoulombFriction,)
    starts = starts_in_flight(prepared, beside)
    assert {one.terms for one in starts} == {(CoulombFriction, Backlash)}
    for one in starts:
        inertia = float(np.exp(prepared.coordinates(one).shared.log_inertia))
        _, frame, pull, *_ = one.values[-1]
        assert pull / frame == pytest.approx(HEAVY.gravity / HEAVY.inertia, rel=0.02)
        expected = SMALL_LEG.friction / SMALL_LEG.inertia
        assert one.values[0][0] / inertia == pytest.approx(expected, rel=0.25)
        gravity = float(prepared.coordinates(one).shared.gravity)
        # Half of the frame's weight may be taken for the leg's.
        assert gravity == pytest.approx(SMALL_LEG.gravity / SMALL_LEG.inertia, rel=0.1)


def test_with_masses_the_frame_is_told_and_the_leg_stays_what_it_was(sticking):
    prepared, base = sticking
    heavier = [replace(each, added_mass=1.0) for each in prepared.problem.movements]
    other = replace(prepared, problem=replace(prepared.problem, movements=heavier))
    assert partners(other, (CoulombFriction,), base.candidate) == []
    leg = other.coordinates(base.candidate).shared
    starts = starts_in_flight(other, base.candidate)
    assert starts
    for one in starts:
        _, frame, pull, *_ = one.values[-1]
        assert pull / frame == pytest.approx(HEAVY.gravity / HEAVY.inertia, rel=0.02)
        assert flattened(other.coordinates(one).shared) == pytest.approx(flattened(leg))
