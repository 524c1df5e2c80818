"""Missing torques are J (phi'' - Eq. 9): a leg with another J lacks others in the same motion."""

from dataclasses import replace

import numpy as np
import pytest

from exoid.fitting.estimate import fit
from exoid.mismatch.conclude.verdict.segments.own_torques import of_own_torques, own_torques
from exoid.mismatch.evidence.locate import between, explained, lacking, regions_of
from exoid.mismatch.evidence.location import Location, Missing, Region
from exoid.mismatch.prepare import prepare
from legs import drop, fall, recording

OWN, ADDED = 0.33, 0.2  # kg m^2, of the leg and of a known mass on it


def missing(name, moves):
    time = np.arange(5.0)
    return Missing(name, time, time, time, time + 1.0, 0.1, 2 * time, 3, moves)


def test_of_a_leg_with_another_inertia_the_accelerations_that_lack_stay():
    bare, loaded = missing("bare", OWN), missing("loaded", OWN + ADDED)
    region = Region("loaded", 0.0, 1.0, "-10 to 5 deg, extending", "", 0.44)
    other = Location([bare, loaded], [region], 0.1, 0.8, OWN).with_inertia(0.40)
    assert other.inertia == 0.40
    for before, after, moves in zip((bare, loaded), other.missing, (0.40, 0.60), strict=True):
        assert after.torque / moves == pytest.approx(before.torque / before.inertia)
        assert after.band / moves == pytest.approx(before.band / before.inertia)
        assert after.modelled / moves == pytest.approx(before.modelled / before.inertia)
    (told,) = other.regions
    assert told.torque == pytest.approx(0.44 * 0.60 / 0.53)
    assert told.description == "0.5 N m towards extension are missing at -10 to 5 deg, extending"


@pytest.mark.parametrize(("level", "says"), [(0.3, True), (0.03, False)])
def test_a_torque_of_each_segments_own_is_told_from_what_comes_back_in_all(level, says):
    """Beside an oscillation of 0.1 N m, of which a mean over a segment shows nothing."""
    swing = 0.1 * np.array([0.0, 1.0, 0.0, -1.0, 0.0])
    each = [replace(missing("", OWN), torque=swing + own) for own in (0.0, level, -level)]
    location = Location(each, [], 0.05, 0.05, by_segment=between(each))
    assert ("within each segment" in location.pattern) is says
    assert ("muscle" in location.pattern) is says
    assert "muscle" not in replace(location, rig=True).pattern


@pytest.mark.parametrize(("swing", "explains"), [(0.1, True), (0.5, False)])
def test_a_torque_of_each_segments_own_explains_it_only_down_to_the_noise(swing, explains):
    """Beside an oscillation that the noise of 0.1 N m makes, or that something else does."""
    own = {"first": 0.6, "second": 0.0, "third": -0.9}
    waves = swing * np.array([0.0, 1.0, 0.0, -1.0, 0.0])
    each = [replace(missing(name, OWN), torque=waves + level) for name, level in own.items()]
    found = own_torques(Location(each, [], 0.05, 0.05, by_segment=between(each)))
    assert found == pytest.approx(own if explains else {})


def test_one_segment_alone_has_no_torque_of_its_own():
    lone = [replace(missing("", OWN), torque=np.full(5, 0.3))]
    assert own_torques(Location(lone, [], 0.05, 0.05, by_segment=between(lone))) == {}


def test_torques_of_segments_are_told_over_an_inertia_that_is_a_guess():
    own = {"0": 0.3, "1": -0.15}
    assert "+0.3 N m in segment 0, -0.15 N m in segment 1" in of_own_torques(
        own, 0.5, guessed=False
    )
    assert "+0.6 1/s^2 in segment 0, -0.3 1/s^2" in of_own_torques(own, 0.5, guessed=True)


@pytest.mark.parametrize(("size", "named"), [(0.15, 0), (0.5, 2)])
def test_no_place_is_named_inside_the_noise(size, named):
    """A torque along a square wave, as a model has it, beside sensors that tell 0.1 N m."""
    time = np.arange(100) / 100
    wave = size * np.sign(0.5 - time)
    noise = 0.01 * np.cos(50 * time)
    each = Missing("", time, time, time, wave + noise, 0.1, wave, 3, OWN)
    assert len(regions_of(each)) == named


def test_what_hangs_on_speed_alone_is_told_so_of_a_swing_that_decays():
    """Most samples are of small swings, where hardly anything is missing."""
    time = np.arange(0.0, 12.0, 0.01)
    swing = np.exp((8j - 0.5) * time)
    speed = ((8j - 0.5) * swing).real
    drag = -speed * np.abs(speed) + 2.0 * speed
    assert explained(speed, drag) > 0.95
    assert explained(swing.real, drag) < 0.5
    assert explained(speed, np.random.default_rng(0).normal(size=time.size)) < 0.05


def test_what_a_late_gyro_shows_is_no_torque_that_a_model_explains():
    """By a gyro that is a step of 12 ms late: taken for what the leg does, that is 0.7 N m."""
    step, both = 0.012, drop(step=0.012)
    late = replace(both, raw_angular_velocity=np.roll(both.raw_angular_velocity, 1))
    named = [("drop", recording(late))]
    prepared, base = prepare(fit(named, multistart=2), named, ())
    _, angle, speed = fall(step=step)
    room = prepared.seen.time.shape[1] - angle.size
    shown = np.pad(np.stack([angle, np.roll(speed, 1)], axis=1), ((0, room), (0, 0)), mode="edge")
    one = lacking(prepared, base.candidate, 0, shown)
    assert one.modelled == pytest.approx(one.torque, abs=0.1)
