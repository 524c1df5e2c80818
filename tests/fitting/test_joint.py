"""Several recordings of one leg: what the leg owns is shared, what a recording owns is its own."""

from dataclasses import replace

import jax
import numpy as np
import pytest

from exoid.fitting.estimate import fit
from exoid.fitting.model.systematics import WEIGHED
from exoid.fitting.multistart.beginning.starts import draw
from exoid.physics.leg import GRAVITY, LegModel
from exoid.physics.torque import NoTorque
from exoid.recordings.recording import Recording
from exoid.twin.protocols import record
from fit_cases import BODY, DROP, leg, recorded

DISTANCE = 0.4  # m
ZERO = np.radians(2.0)
LONG = DROP
TRUTH = leg()
NO_MARKS = {"segment_start": None, "segment_end": None}


def loaded(movement):
    return replace(movement, added_mass=1.0, added_mass_distance=DISTANCE)


def unplaced(recording: Recording) -> Recording:
    """Nobody measured where the mass sat."""
    return replace(recording, subject=replace(recording.subject, added_mass_distance=None))


def remounted(recording):
    """As an exoskeleton that was put on again shows the same motion."""
    zero, scale, bias = ZERO, -0.02, 0.01
    segments = tuple(
        replace(
            each,
            raw_angle=each.raw_angle + zero,
            raw_angular_velocity=(1 + scale) * each.raw_angular_velocity + bias,
        )
        for each in recording.segments
    )
    return replace(recording, segments=segments)


def check_leg(result, within):
    """J, m l, c and d against the truth."""
    found = {name: each.value for name, each in result.parameters.items()}
    moment = float(TRUTH.mass * TRUTH.com_distance)
    assert found["mass"] * found["com_distance"] == pytest.approx(moment, rel=within)
    for name in ("inertia", "damping", "stiffness"):
        assert found[name] == pytest.approx(float(getattr(TRUTH, name)), rel=within)
        each = result.parameters[name]
        assert each.determined_by == "data"
        assert abs(each.value - float(getattr(TRUTH, name))) < 4 * each.standard_error
    for name in ("mass", "com_distance"):
        assert result.parameters[name].determined_by == "prior"


@pytest.fixture(scope="module")
def bare():
    return recorded(LONG)


@pytest.fixture(scope="module")
def heavy():
    return recorded(loaded(LONG), seed=1)


@pytest.mark.parametrize("seed", range(4))
def test_bare_and_loaded_recordings_recover_the_leg_within_one_per_cent(seed):
    pair = [("bare", recorded(LONG, seed=seed)), ("loaded", recorded(loaded(LONG), seed=50 + seed))]
    check_leg(fit(pair, multistart=4), 0.01)


def test_the_place_of_the_mass_is_found_where_nobody_measured_it(bare, heavy):
    result = fit([("bare", bare), ("loaded", unplaced(heavy))], multistart=4)
    check_leg(result, 0.01)
    mounting = result.mountings[-1]
    assert mounting.recording == "loaded"
    assert mounting.added_mass_distance is not None
    each = mounting.added_mass_distance
    assert each.value == pytest.approx(DISTANCE, abs=4 * each.standard_error)
    assert each.standard_error < 1e-3


def test_an_exoskeleton_that_was_put_on_again_is_recognised(bare, heavy):
    result = fit([("bare", bare), ("loaded", remounted(heavy))], multistart=4)
    check_leg(result, 0.01)
    known = result.mountings[-1].known
    truth = {"zero": ZERO, "gyro_scale": -0.02, "gyro_bias": 0.01}
    for name, value in truth.items():
        assert known[name].value == pytest.approx(value, abs=4 * known[name].standard_error)


def test_starts_own_their_starts_and_find_the_same_joint_fit(bare, heavy):
    pair = [("bare", bare), ("loaded", unplaced(heavy))]
    result = fit(pair, starts=draw(12, 3))
    assert result.multistart.at_best == 12


@pytest.mark.proof
def test_loaded_drops_alone_leave_the_scale_to_the_prior(heavy):
    for recording in (heavy, unplaced(heavy)):
        result = fit(recording, multistart=2)
        assert result.parameters["inertia"].determined_by == "prior"
        nobody = replace(recording.subject, body_mass=None, height=None)
        alone = fit(replace(recording, subject=nobody), multistart=2)
        assert alone.parameters["inertia"].determined_by != "data"


def test_recordings_of_different_bodies_are_refused(bare):
    def of(**body):
        return replace(bare, subject=replace(BODY, **body))

    with pytest.raises(ValueError, match="a says body_mass 60 kg, b says 74 kg"):
        fit([("a", of(body_mass=60.0)), ("b", bare)])
    with pytest.raises(ValueError, match="height"):
        fit([("a", of(height=1.9)), ("b", bare)])
    with pytest.raises(ValueError, match="rig"):
        fit([("a", of(kind="rig")), ("b", bare)])


def test_slsqp_refuses_what_only_the_joint_fit_can_do(bare, heavy):
    with pytest.raises(ValueError, match="slsqp"):
        fit([("bare", bare), ("loaded", heavy)], multistart=1, method="slsqp")


def test_one_recording_has_a_mounting_of_its_own():
    (mounting,) = fit(recorded(DROP), multistart=1).mountings
    for name in ("gyro_scale", "gyro_bias"):
        each = mounting.known[name]
        assert abs(each.value) < 4 * each.standard_error


@pytest.mark.proof
def test_the_seats_angle_is_taken_from_the_sidecar():
    """Two drops on a seat that was tilted between them: gravity turns, the leg stays."""
    model = LegModel(TRUTH, NoTorque(), np.asarray(0.35))
    tilted = record(model, [LONG], jax.random.key(5), subject=BODY)
    level = recorded(LONG)
    assert tilted.thigh_angle(0) == 0.35
    both = replace(
        level,
        segments=level.segments + tilted.segments,
        protocol=replace(level.protocol, kind="passive", thigh_angle=(0.0, 0.35), **NO_MARKS),
    )
    result = fit(both, multistart=4)
    assert result.angle_rmse < 1.1 * result.angle_noise
    gravity = float(TRUTH.mass * TRUTH.com_distance * GRAVITY / TRUTH.inertia)
    each = result.ratios["gravity_over_inertia"]
    assert abs(each.value - gravity) < 4 * each.standard_error
    untold = replace(both, protocol=replace(both.protocol, thigh_angle=None))
    assert fit(untold, multistart=4).angle_rmse > 10 * result.angle_rmse


def test_the_same_recording_twice_is_refused(bare):
    with pytest.raises(ValueError, match="a and b hold the same samples"):
        fit([("a", bare), ("b", bare)])


def test_the_error_of_weighing_is_in_the_inertia_and_said(bare, heavy):
    result = fit([("bare", bare), ("loaded", heavy)], multistart=2)
    assert any("weight of the added mass limits J" in note for note in result.notes)
    inertia = result.parameters["inertia"]
    assert inertia.standard_error / inertia.value == pytest.approx(WEIGHED, rel=0.2)
    assert not any("added mass" in note for note in fit(bare, multistart=2).notes)
