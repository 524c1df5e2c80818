"""A fit that does not follow its recording says of it only what does not hang on its model."""

from dataclasses import replace
from functools import cache

import numpy as np
import pytest

import exoid
from exoid.fitting.data.segment import movement
from exoid.fitting.estimate import fit
from exoid.fitting.model.prior_and_limits import believe
from exoid.fitting.result.estimates.estimate import Estimate
from exoid.fitting.result.estimates.scale import SCALE_FREE, reason_of
from exoid.fitting.result.refused.notes import (
    of_causes,
    of_rests,
    of_sensors,
    of_swing,
    of_the_top,
)
from exoid.fitting.result.refused.own_swing import own_swing
from exoid.fitting.result.refused.without_numbers import REFUSED, without_numbers
from exoid.recordings.declared.protocol import Protocol
from exoid.recordings.declared.sensors import Sensors
from exoid.recordings.declared.subject import Subject
from exoid.recordings.measured.segment import Segment
from exoid.trust.told import fit as public
from exoid.trust.told import told
from fit_cases import BODY, DROP, recorded
from legs import balance_of, drop, recording

BY_ITS_MODEL = (
    "use the ratios",
    "the ratios to J",
    "holds",
    "'if slack'",
    "takes for granted",
    "part of the variance",
    "ran into its limits",
    "would leave",
    "Errors are widened",
    "by this fit",
    "seem to disagree",
)
STARTS = (-0.2, -0.45)


@cache
def slow():
    """A long slow pendulum, J / (m l) 1.4 m, as a leg."""
    return fit(recording(drop((7.0, 1.2, 0.6), -0.3, duration=2.4)), multistart=4)


def cycles():
    """Three cycles that a controller moves by a raised cosine: no torque of Eq. 10 does."""
    time, random = np.arange(0.0, 3.0, 0.01), np.random.default_rng(0)

    def cycle(size):
        angle = -1.4 + size * (1 - np.cos(2 * np.pi * time / 3.0)) / 2
        speed = size * np.pi / 3.0 * np.sin(2 * np.pi * time / 3.0)
        return Segment(
            time,
            raw_angle=angle + 8e-4 * random.standard_normal(time.size),
            raw_angular_velocity=speed + 3e-3 * random.standard_normal(time.size),
        )

    return recording(*map(cycle, (0.5, 0.8, 1.1)), protocol=Protocol(kind="active"))


def moved(*segments, **tables):
    whole = recording(*segments, **tables)
    return [movement(whole, at, f"drop {at}") for at in range(len(segments))]


def test_notes_of_numbers_that_are_not_to_be_used_are_none():
    result = slow()
    assert not result.follows
    said = " ".join(result.notes)
    assert "Do not use its numbers" in said
    for each in BY_ITS_MODEL:
        assert each not in said, each


def test_a_leg_that_is_drawn_back_too_slowly_is_asked_for_its_times_and_its_body():
    """8 1/s^2 where gravity alone makes 27 of this body; its gyro has the clock of the encoder."""
    (told,) = [each for each in slow().notes if "by its swing alone" in each]
    assert "body mass, height and age" in told
    assert "sampling rate" not in told


def test_of_a_spring_that_is_slack_in_flexion_it_says_where():
    """A knee as others: Riener & Edrich have its spring slack at 61 deg of flexion."""
    knee, noise = (28.4, 11.5, 0.96), (3.5e-4, 2e-3)
    made = [drop(knee, at, slack=np.radians(-35.0), noise=noise) for at in (-0.2, -0.5, -0.8)]
    sensors = Sensors(angle_noise=noise[0], velocity_noise=noise[1])
    result = fit(recording(*made, sensors=sensors), multistart=4)
    assert not result.follows
    assert "the spring is slack elsewhere" in result.notes[0]
    (said,) = [each for each in result.notes if "slack at about" in each]
    found = float(said.partition("phi_r = ")[2].partition(" ")[0])
    assert found == pytest.approx(-35.0, abs=5.0)
    assert not [each for each in slow().notes if "slack at about" in each]


def test_cycles_are_refused_for_their_torque_alone():
    result = fit(cycles(), multistart=4)
    assert not result.follows
    said = " ".join(result.notes)
    assert "that of a muscle seldom is" in said
    for each in (*BY_ITS_MODEL, "on its side", "sampling rate", "disagree", "dry friction"):
        assert each not in said, each


@pytest.mark.parametrize("rate", [0.6, 1.5, 2.0])
def test_the_rate_of_wrong_times_is_told_where_no_gyro_speaks_against_it(rate):
    made = [drop(start=at, gyro=False) for at in STARTS]
    times = moved(*(replace(each, time=rate * each.time) for each in made))
    (told,) = of_swing(believe(BODY), times)
    found = float(told.partition("a sampling rate about ")[2].partition(" ")[0])
    assert found == pytest.approx(rate, rel=0.1)  # c / J is that of another leg, and J / (m l)


def test_times_that_are_far_off_are_told_where_noise_hides_how_smooth_the_swing_is():
    """A film of 100 frames a second that is said to be of 50, with 0.8 deg of noise."""
    draw = np.random.default_rng(0)
    made = [drop(start=at, gyro=False) for at in STARTS]
    noises = [np.radians(0.8) * draw.standard_normal(each.time.size) for each in made]
    pairs = zip(made, noises, strict=True)
    rough = [replace(each, raw_angle=each.raw_angle + noise) for each, noise in pairs]
    assert of_swing(believe(BODY), moved(*rough)) == []
    slow = moved(*(replace(each, time=2 * each.time) for each in rough))
    assert not own_swing(slow).smooth
    (told,) = of_swing(believe(BODY), slow)
    found = float(told.partition("a sampling rate about ")[2].partition(" ")[0])
    assert found == pytest.approx(2.0, rel=0.1)


@pytest.mark.parametrize("rate", [0.7, 1.5])
def test_the_rate_of_wrong_times_is_told_by_a_gyro(rate):
    made = [drop(start=at) for at in STARTS]
    times = moved(*(replace(each, time=rate * each.time) for each in made))
    (told,) = of_sensors(times)
    found = float(told.partition("a sampling rate ")[2].partition(" ")[0])
    assert found == pytest.approx(rate, rel=0.02)


def test_a_leg_as_others_are_and_sensors_that_agree_are_asked_nothing():
    own = moved(*(drop(start=at) for at in STARTS))
    assert of_swing(believe(BODY), own) == of_sensors(own) == []


def test_a_leg_on_its_side_is_asked_whether_it_lies_so():
    level = moved(*(drop((0.0, 18.0, 0.8), at, slack=-0.9) for at in STARTS))
    (told,) = of_swing(believe(BODY), level)
    assert "Does the leg lie on its side" in told


@pytest.mark.parametrize("stiffness", [2.0, 15.0])
def test_a_mass_that_was_on_the_leg_in_some_drops_alone_is_asked_for(stiffness):
    """2.5 kg at 0.35 m on a leg of m l g 11 N m and J 0.42 kg m^2."""
    bare = (27.0, stiffness, 0.8)
    heavier, larger = 1 + 2.5 * 0.35 / (11 / 9.81), 1 + 2.5 * 0.35**2 / 0.42
    loaded = (27.0 * heavier / larger, stiffness / larger, 0.8 / larger)
    own = moved(*(drop(bare, at, gyro=False) for at in (-0.15, -0.45, -0.8)))
    assert of_rests(own) == []
    mixed = moved(drop(bare, -0.3, gyro=False), drop(loaded, -0.3, gyro=False))
    expected = np.degrees([balance_of(bare), balance_of(loaded)])
    said = " ".join(of_rests(mixed))
    assert ("Was a mass on the leg in one of them" in said) == (expected[0] - expected[1] > 4)


@pytest.mark.parametrize(
    ("turned", "lost", "gravity", "said"),
    [(4.0, 0, None, 1), (4.0, 0, "none", 0), (0.2, 0, None, 0), (0.2, 40, None, 0)],
)
def test_one_that_goes_over_the_top_again_and_again_is_told_so(turned, lost, gravity, said):
    """There and back by so many turns; an angle that is missing goes nowhere, and without gravity
    nothing is the top.
    """
    time = np.arange(0.0, 10.0, 0.01)
    angle = -np.pi / 2 + turned * np.pi * (1 - np.cos(time))
    angle[np.arange(lost) * 20] = np.nan
    own = moved(
        Segment(time, raw_angle=angle, applied_torque=np.sin(time)),
        subject=Subject(kind="rig", spring="none", gravity=gravity),
        protocol=Protocol(kind="measured"),
    )
    assert len(of_the_top(own)) == said


def test_what_may_be_behind_it_is_what_was_recorded():
    drops, rig = of_causes({"passive"}, rig=False), of_causes({"passive"}, rig=True)
    assert "Eq. 10" not in drops + rig
    assert "a hand" in drops
    assert "dry friction" in rig
    assert "--with quadratic_drag" in rig
    assert "dry friction" in of_causes({"measured"}, rig=True)
    both = of_causes({"active", "measured"}, rig=False)
    assert "Eq. 10" in both
    assert "let go" not in both
    assert "its unit" in both


@cache
def tilted(thigh):
    """A leg whose thigh lies so [rad], with a sidecar that says nothing of it."""
    leg = (26.4, 2.4, 0.7)
    drops = [drop(leg, at, duration=4.0, thigh=thigh) for at in (-0.3, -0.5, -0.7)]
    return fit(recording(*drops), multistart=2)


@pytest.mark.parametrize("thigh", [-15.0, 20.0])
def test_a_seat_that_nobody_declared_is_named_first_where_a_fit_does_not_follow(thigh):
    found = tilted(np.radians(thigh))
    assert not found.follows
    assert "the thigh is tilted otherwise than is declared" in found.astray
    (named,) = (note for note in found.notes if "may be behind it" in note)
    assert "let go: a seat or posture that is not as declared (thigh_angle_deg" in named


def test_a_seat_is_named_where_gravity_comes_from_elsewhere_alone():
    assert "a seat or posture" in of_causes({"passive"}, rig=False, seat=True)
    assert "a seat or posture" not in of_causes({"passive"}, rig=False)
    assert "a seat or posture" not in of_causes({"passive"}, rig=True, seat=True)


def test_a_program_is_given_no_number_of_a_refused_model():
    """`exoid.fit` gave d / J as 0.70 ± 0.20 of an arm whose 0.32 no reader could then know."""
    kept = fit(recorded(DROP), multistart=2, fix={"damping": 0.2})
    lost = told(lambda: replace(kept, astray="it misses the angle"))()
    each = lost.ratios["gravity_over_inertia"]
    assert (each.value, each.standard_error, each.reason) == (None, None, REFUSED)
    assert told(lambda: kept)() is kept
    assert exoid.fit is public
    told_of = exoid.identify(lost)
    assert told_of.combinations == {}


def test_no_rig_is_asked_for_body_mass_and_height():
    lost = Estimate("F_c", "level", "N m", None, None, reason=SCALE_FREE)
    assert "body mass" not in reason_of(lost, rig=True).reason
    assert reason_of(lost, rig=False) is lost


def test_a_saved_fit_that_was_refused_is_read_without_its_numbers(tmp_path):
    kept = fit(recorded(DROP), multistart=2, fix={"damping": 0.2})
    exoid.save_result(replace(kept, astray="it misses"), tmp_path / "fit.json")
    found = exoid.load_result(tmp_path / "fit.json").result
    assert not found.follows
    assert found.parameters["inertia"].value is None


def test_no_number_of_a_refused_model_is_shown_but_what_the_user_fixed():
    result = fit(recorded(DROP), multistart=2, fix={"damping": 0.2})
    assert without_numbers(result) is result
    lost = without_numbers(replace(result, astray="it misses the angle"))
    known = {**lost.of_leg, **lost.ratios}
    fixed = known.pop("damping")
    assert fixed.value == 0.2
    assert {each.value for each in known.values()} == {None}
    assert {each.standard_error for each in known.values()} == {None}
    assert {each.reason for each in known.values()} == {REFUSED}
    assert lost.mountings == []
    assert lost.multistart.family == lost.multistart.members == {}
    assert [each.angle_rmse for each in lost.segments] == [
        each.angle_rmse for each in result.segments
    ]
    assert repr(replace(result, astray="it misses the angle")).count("±") == 1
