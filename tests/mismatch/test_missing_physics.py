"""The whole diagnosis, on recordings whose truth is known."""

from dataclasses import replace

import jax.numpy as jnp
import numpy as np
import pytest
from diagnosis_cases import DROPS, FRICTION, Broken, Detent, Release, session

from exoid.mismatch import prepare as preparing
from exoid.mismatch.missing_physics import diagnose
from exoid.mismatch.with_model import doubts, ended_elsewhere
from exoid.physics.sensing.angle_offset import AngleOffset
from exoid.physics.sensing.gyro_scale import GyroScale
from exoid.physics.terms.device.coulomb_friction import CoulombFriction
from exoid.physics.terms.tissue.quadratic_drag import QuadraticDrag
from exoid.recordings.declared.subject import Subject
from exoid.recordings.measured.segment import Segment
from exoid.recordings.recording import Recording
from small_library import SMALL


@pytest.fixture(autouse=True, scope="module")
def _small_library():
    with pytest.MonkeyPatch.context() as patched:
        patched.setattr(preparing, "library", lambda: SMALL)
        yield


@pytest.fixture(scope="module")
def heard():
    """The phases of the diagnosis of the leg with friction, as they were told."""
    return []


@pytest.fixture(scope="module")
def of_friction(heard):
    return diagnose(session(FRICTION), told=heard.append)


@pytest.fixture(scope="module")
def of_nothing():
    return diagnose(session())


def test_a_fit_in_another_minimum_than_the_search_gives_no_numbers(of_friction):
    """The one with friction stands where the search ended; the one without leaves 20 times that."""
    assert of_friction.after is not None
    assert not ended_elsewhere(of_friction, of_friction.after)
    elsewhere = replace(of_friction.before, astray=None)
    assert ended_elsewhere(of_friction, elsewhere)
    (reason,) = doubts(of_friction, elsewhere)
    assert "coulomb friction predicts what it did not see" in reason
    assert "in another minimum" in reason


def cut(recording: Recording, until: float) -> Recording:
    """Every segment up to `until` [s]."""
    segments = tuple(shortened(each, until) for each in recording.segments)
    return Recording(segments, recording.subject, recording.protocol, recording.sensors)


def shortened(segment, until):
    kept = segment.time <= until
    return Segment(**{name: samples[kept] for name, samples in timed(segment).items()})


def without(segment, lost):
    """The segment without its `lost` samples, of which the first and the last are none."""
    kept = ~lost
    kept[[0, -1]] = True
    return Segment(**{name: samples[kept] for name, samples in timed(segment).items()})


def timed(segment):
    return segment.channels() | {"time": segment.time}


def test_friction_is_named_and_proved_and_taken_out_of_the_damping(of_friction):
    found = of_friction
    assert found.verdict == "mismatch"
    assert found.selected == ["coulomb_friction"]
    assert found.equivalent == ["coulomb_friction"]
    assert found.proof.after.total < 1.2 * found.proof.noise_floor < found.proof.before.total
    damping = next(each for each in found.booked if each.name == "damping")
    assert damping.after < damping.before
    assert found.false_alarm_rate < 0.05
    assert found.power > 0.95


@pytest.mark.proof
def test_what_the_damping_has_swallowed_is_still_found():
    # So little friction that the baseline looks good: its angle is within twice the noise.
    found = diagnose(session(CoulombFriction(jnp.asarray(0.012))))
    assert found.fit.angle_rmse < 2.0 * found.fit.angle_noise
    assert found.selected == ["coulomb_friction"]


def test_nothing_is_found_where_nothing_is(of_nothing):
    assert of_nothing.verdict == "none"
    assert of_nothing.selected == of_nothing.equivalent == []


def test_no_torque_is_missing_where_none_is_least_of_all_at_the_release(of_nothing):
    # Noise alone exceeds five of its deviations once in two million samples.
    for each in of_nothing.location.missing:
        assert np.abs(each.torque).max() < 5 * each.band


@pytest.mark.proof
def test_a_wrong_gyro_is_a_sensor_and_no_torque():
    found = diagnose(session(GyroScale(jnp.asarray(-0.02))))
    assert found.selected == ["gyro_scale"]
    value = next(each for each in found.parameters if each.name == "gyro_scale.scale")
    assert value.value == pytest.approx(-0.02, abs=0.001)


@pytest.mark.proof
def test_a_zero_as_it_usually_is_bends_nothing_to_it():
    found = diagnose(session(GyroScale(jnp.asarray(-0.03)), AngleOffset(jnp.asarray(0.012))))
    assert found.selected == ["gyro_scale"]


@pytest.mark.proof
def test_a_zero_that_is_certain_but_usual_is_told():
    recording = session(AngleOffset(jnp.asarray(-0.012)))
    level = replace(recording.protocol, thigh_angle_uncertainty=1e-4)
    found = diagnose(replace(recording, protocol=level))
    assert found.verdict == "none"
    assert "zero is off by -0.7 deg, no more than is to be expected" in found.reasons[0]


@pytest.mark.proof
def test_the_zero_of_every_recording_is_told():
    found = diagnose([session(), session(AngleOffset(jnp.asarray(0.09)), seed=1)])
    assert found.verdict == "none"
    (told,) = found.reasons
    assert "is off by 5" in told
    assert "deg, more than is to be expected" in told


@pytest.mark.proof
def test_a_zero_that_is_farther_off_is_named_and_proved_with_all_of_its_error():
    found = diagnose(session(AngleOffset(jnp.asarray(0.06))))
    assert found.selected == ["angle_offset"]
    assert found.proof.after.total < 1.1 * found.proof.noise_floor < found.proof.before.total
    (zero,) = found.parameters
    assert abs(zero.value - 0.06) < 2.6 * zero.standard_error
    assert zero.standard_error > 0.5 * np.radians(0.2)  # no drop tells it apart from a seat's tilt


@pytest.mark.proof
def test_two_effects_are_both_named():
    found = diagnose(session(FRICTION, GyroScale(jnp.asarray(0.03))))
    assert sorted(found.selected) == ["coulomb_friction", "gyro_scale"]


@pytest.mark.proof
def test_what_happened_in_one_segment_is_no_new_physics():
    recording = session(FRICTION)
    touched = recording.segments[1]
    gone = np.clip(touched.time - 1.2, 0.0, 0.4) / 0.4
    moved = replace(
        touched,
        raw_angle=touched.raw_angle + 0.015 * gone**2 * (3 - 2 * gone),
        raw_angular_velocity=touched.raw_angular_velocity + 0.225 * gone * (1 - gone),
    )
    segments = (recording.segments[0], moved, *recording.segments[2:])
    found = diagnose(replace(recording, segments=segments))
    assert found.verdict == "cannot_tell"
    assert "lies in segment 1 alone" in found.reasons[0]


@pytest.mark.proof
def test_a_leg_that_is_like_no_other_may_hide_something(of_nothing):
    child = Subject(kind="leg", body_mass=30.0, height=1.35)
    found = diagnose(replace(session(), subject=child))
    assert (found.verdict, of_nothing.verdict) == ("none", "none")
    assert "J / (m l) = 0.359 m, and anatomy expects 0.2" in found.reasons[0]
    assert "would look like this" in found.reasons[0]
    assert of_nothing.reasons == []


@pytest.mark.proof
def test_a_term_of_the_users_own_is_tested_like_any_other():
    found = diagnose(session(Detent(jnp.asarray(0.2))), terms=(Detent,))
    assert found.selected == ["detent"]


@pytest.mark.proof
def test_a_term_that_cannot_be_differentiated_is_left_out_by_name():
    found = diagnose(session(FRICTION), terms=(Broken,))
    assert found.excluded == ["broken"]
    assert found.selected == ["coulomb_friction"]


@pytest.mark.proof
def test_what_no_term_describes_is_called_novel_and_gets_a_formula():
    found = diagnose(session(Detent(jnp.asarray(0.3))))
    assert found.verdict == "mismatch"
    assert found.formula is not None
    assert found.formula.explained > 0.9
    assert "8 x" in found.formula.words


@pytest.mark.proof
def test_a_formula_over_an_unknown_inertia_is_the_one_of_the_table():
    found = diagnose(replace(session(Detent(jnp.asarray(0.3))), subject=Subject(kind="rig")))
    assert found.formula is not None
    size = float(found.formula.over_inertia.split()[4])  # of "tau / J = 1.23 ..."
    ratio = found.fit.of_terms["formula.c_0_over_inertia"]
    assert size == pytest.approx(ratio.value, rel=5e-3)  # three figures of it are told


@pytest.mark.proof
def test_nothing_is_called_new_by_who_cannot_tell():
    cycles = [Release(angle, duration=1.2, amplitude=-4.0) for angle in (-6, -8)]
    found = diagnose(session(Detent(jnp.asarray(0.3)), movements=cycles))
    assert (found.verdict, found.best.terms) == ("cannot_tell", ["formula"])
    assert "cannot tell the leg from the muscles" in found.reasons[0]
    assert not found.novel
    assert found.formula is None


def test_a_single_segment_is_split_in_time():
    found = diagnose(session(FRICTION, movements=DROPS[:1]))
    assert found.proof.in_time
    assert found.selected == ["coulomb_friction"]


def test_what_is_too_short_cannot_tell():
    found = diagnose(cut(session(FRICTION, movements=DROPS[:1]), 1.0))
    assert found.verdict == "cannot_tell"
    assert any("too short" in reason for reason in found.reasons)


def test_one_voluntary_cycle_never_claims_physics_of_the_leg():
    cycle = (Release(-6, 1.19, amplitude=-4.0),)
    found = diagnose(session(QuadraticDrag(jnp.asarray(0.05)), movements=cycle))
    assert found.verdict in ("cannot_tell", "none")
    assert found.selected == []


def test_the_phases_are_told(of_friction, heard):
    assert heard[0] == "fitting the baseline"
    assert len(heard) == len(set(heard)) >= 4


def test_a_leg_that_hardly_moves_cannot_tell():
    quiet = tuple(Release(angle) for angle in (-67, -67.5, -68))
    found = diagnose(session(FRICTION, movements=quiet))
    assert found.verdict == "cannot_tell"
    assert "release it from higher up" in found.reasons[0]
    assert found.selected == []


@pytest.mark.proof
def test_without_a_gyro_friction_is_found_by_the_encoder_alone():
    recording = session(FRICTION)
    segments = tuple(Segment(each.time, raw_angle=each.raw_angle) for each in recording.segments)
    blind = Recording(segments, recording.subject, recording.protocol, recording.sensors)
    found = diagnose(blind)
    assert found.selected == ["coulomb_friction"]
    assert found.sensors == []


@pytest.mark.proof
def test_samples_that_were_lost_here_and_there_change_nothing():
    rng = np.random.default_rng(1)
    recording = session(FRICTION)
    segments = tuple(without(each, rng.random(each.time.size) < 0.1) for each in recording.segments)
    patchy = Recording(segments, recording.subject, recording.protocol, recording.sensors)
    assert diagnose(patchy).selected == ["coulomb_friction"]


def test_clear_friction_is_found_in_every_resample_of_the_segments(of_friction, of_nothing):
    assert of_friction.inclusion == 1.0
    assert of_nothing.inclusion is None


@pytest.mark.proof
def test_of_twenty_recordings_that_lack_nothing_at_most_one_is_called_wrong():
    alarms = [diagnose(session(seed=seed)).verdict == "mismatch" for seed in range(100, 120)]
    assert sum(alarms) <= 1  # 5 %; the rate that is promised is below 0.1 %
