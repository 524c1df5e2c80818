"""The fit as a whole, on subjects whose legs are known and on real recordings."""

from dataclasses import replace

import jax
import jax.numpy as jnp
import numpy as np
import pytest
from scipy.stats import binom

from exoid.fitting.estimate import fit
from exoid.fitting.multistart.beginning.starts import draw
from exoid.fitting.result.estimates.found import ON_BOUND
from exoid.physics.anatomy import expected_leg
from exoid.physics.leg import LegModel, LegParameters
from exoid.physics.motion.simulate import simulate
from exoid.physics.torque import MeasuredTorque, NoTorque
from exoid.recordings.declared.sensors import Sensors
from exoid.recordings.declared.subject import Subject
from exoid.recordings.formats.own_table import read_table
from exoid.recordings.measured.segment import Segment
from exoid.recordings.recording import Recording
from exoid.twin.motion import Movement
from exoid.twin.protocols import record
from fit_cases import BODY, CYCLE, DROP, LOADED, NOISE, exact, leg, one, recorded, state

RIG = Subject(kind="rig")
NOBODY = Subject(kind="leg")
RATIOS = ("gravity_over_inertia", "stiffness_over_inertia", "damping_over_inertia")


def true_ratios(parameters: LegParameters, amplitude: float | None = None) -> dict[str, float]:
    ratios = LegModel(parameters, NoTorque()).ratios()
    values = [float(ratios.gravity), float(ratios.stiffness), float(ratios.damping)]
    named = dict(zip(RATIOS, values, strict=True))
    if amplitude is not None:
        named["torque_over_inertia"] = amplitude / float(parameters.inertia)
    return named


def errors(result, truth) -> list[float]:
    """Each ratio's distance from the truth, in its standard errors."""
    return [
        (result.ratios[name].value - value) / result.ratios[name].standard_error
        for name, value in truth.items()
    ]


def subject(generator: np.random.Generator) -> tuple[Subject, dict[str, float]]:
    """Somebody, and a leg such as anatomy and relaxed knees scatter."""
    mass, height = generator.uniform(50, 95), generator.uniform(1.55, 1.95)
    expected = expected_leg(mass, height)
    spread = {"mass": 0.1, "inertia": 0.07, "com_distance": 0.05, "damping": 0.3, "stiffness": 0.3}
    values = {
        name: getattr(expected, name).value * np.exp(share * generator.normal())
        for name, share in spread.items()
    }
    return Subject(kind="leg", body_mass=mass, height=height), values


def declared_exact(made: Recording) -> Recording:
    """The virtual exoskeleton's zero, seat and clock are exact: its sidecar may say so."""
    exact = {f"{name}_uncertainty": 0.0 for name in ("angle_zero", "gyro_scale", "clock")}
    return replace(
        made,
        sensors=replace(made.sensors, **exact),
        protocol=replace(made.protocol, thigh_angle_uncertainty=0.0),
    )


@pytest.mark.proof
def test_the_ratios_of_twenty_subjects_are_found_within_their_errors():
    """Of 80 ratios 95.4 % lie within two errors if the errors are true; fewer than the 1 % quantile
    of that count would be found by chance in one of a hundred such studies.
    """
    generator, all_errors = np.random.default_rng(7), []
    for seed in range(20):
        body, values = subject(generator)
        drop = Movement(np.radians(generator.uniform(-25, -5)), 2.3)
        amplitude = generator.uniform(-6, -3)
        cycle = Movement(np.radians(generator.uniform(-12, -2)), 1.19, amplitude=amplitude)
        made = declared_exact(recorded(drop, cycle, seed=seed, subject=body, **values))
        result = fit(made, multistart=8)
        all_errors += errors(result, true_ratios(leg(**values), amplitude))
        assert result.multistart.at_best == 8
    within = int(np.sum(np.abs(all_errors) < 2))
    assert within >= binom.ppf(0.01, len(all_errors), 0.9545)
    assert np.sqrt(np.mean(np.square(all_errors))) > 0.7  # nor are the errors too large


@pytest.mark.proof
def test_a_known_mass_beside_a_bare_drop_gives_what_depends_on_the_scale():
    result = fit(recorded(DROP, LOADED), multistart=8)
    found = {name: each.value for name, each in result.parameters.items()}
    assert found["inertia"] == pytest.approx(0.42, rel=0.01)
    assert found["mass"] * found["com_distance"] == pytest.approx(4.5 * 0.26, rel=0.01)
    assert found["stiffness"] == pytest.approx(2.6, rel=0.01)
    assert found["damping"] == pytest.approx(0.33, rel=0.01)
    for name in ("inertia", "stiffness", "damping"):
        assert result.parameters[name].determined_by == "data"
    for name in ("mass", "com_distance"):
        assert result.parameters[name].determined_by in ("prior", "both")


def rigged(torque: bool, seed=0) -> Recording:
    """A rig with the leg's own parameters, driven by a torque that is measured or not."""
    time = np.arange(240) * 0.01
    applied = 1.5 * np.sin(4 * time) if torque else np.zeros_like(time)
    drive = MeasuredTorque(jnp.asarray(time), jnp.asarray(applied))
    segment = exact(LegModel(leg(), drive), state(-0.3, -0.5), time, applied_torque=applied)
    generator = np.random.default_rng(seed)
    return one(noisy(segment, generator), "measured" if torque else "passive", RIG)


def noisy(segment: Segment, generator: np.random.Generator) -> Segment:
    size = segment.time.size
    return replace(
        segment,
        raw_angle=segment.raw_angle + NOISE.angle_noise * generator.normal(size=size),
        raw_angular_velocity=segment.raw_angular_velocity
        + NOISE.velocity_noise * generator.normal(size=size),
    )


def test_a_measured_torque_gives_absolute_values():
    result = fit(rigged(torque=True), multistart=8)
    for name, truth in (("inertia", 0.42), ("damping", 0.33), ("stiffness", 2.6)):
        each = result.parameters[name]
        assert each.value == pytest.approx(truth, rel=0.02)
        assert abs(each.value - truth) < 3 * each.standard_error
        assert each.determined_by == "data"
    for name in ("mass", "com_distance"):
        assert result.parameters[name].value is None
        assert "product m l" in result.parameters[name].reason


@pytest.mark.proof
def test_an_inertia_that_nothing_tells_stays_where_a_start_had_it():
    """A logged torque of nothing: along what is flat a search had gone to J = 254 kg m^2."""
    motion = recorded(DROP).segments[0]
    rig = replace(motion, applied_torque=np.zeros(motion.time.size))
    result = fit(one(rig, "measured", RIG), multistart=8)
    assert result.parameters["inertia"].value is None
    assert 0.01 < float(result.basis.ended.best.leg.inertia[0]) < 10


def test_a_damping_near_zero_is_no_more_told_than_the_inertia_that_it_goes_with():
    """J moves it little, less than the encoder's noise here, but nothing says which J it is of."""
    made = recorded(DROP, subject=RIG, damping=1e-3)
    noise = np.random.default_rng(0).normal(scale=0.02, size=made.segments[0].time.size)
    part = made.segments[0]
    coarse = Segment(part.time, raw_angle=part.raw_angle + noise)
    result = fit(replace(made, segments=(coarse,), sensors=Sensors()), multistart=4)
    assert result.ratios["damping_over_inertia"].determined_by == "data"
    assert result.parameters["inertia"].value is None
    damping = result.parameters["damping"]
    assert damping.value is None
    assert damping.standard_error is None
    assert "only the ratios to J" in damping.reason


@pytest.mark.parametrize("recording", [rigged(torque=False), None], ids=["a rig", "no prior"])
def test_without_scale_there_are_ratios_but_no_absolute_values(recording):
    if recording is None:
        result = fit(recorded(DROP), prior="none", multistart=8)
    else:
        result = fit(recording, multistart=8)
    for each in result.parameters.values():
        assert each.value is None
        assert each.standard_error is None
        assert "ratios" in each.reason
    assert max(np.abs(errors(result, true_ratios(leg())))) < 4


def test_a_leg_of_unknown_body_says_how_to_make_it_known():
    result = fit(recorded(DROP, subject=NOBODY), multistart=8)
    assert "--body-mass" in result.prior
    assert result.parameters["mass"].value is None


@pytest.mark.parametrize("reading", [pytest.param("1/T", marks=pytest.mark.proof), "2/T"])
def test_both_readings_of_eq_4_are_tried_and_the_right_one_is_named(reading):
    made = record(
        LegModel(leg(), NoTorque()),
        (replace(CYCLE, amplitude=-6.0),),
        jax.random.key(1),
        subject=BODY,
        torque_frequency=reading,
    )
    silent = replace(made, protocol=replace(made.protocol, torque_frequency=None))
    result = fit(silent, multistart=16)
    assert result.torque_frequency == reading
    assert result.other_reading_rmse > 3 * result.angle_rmse
    said = fit(made, multistart=16)
    assert said.torque_frequency == reading
    assert said.other_reading_rmse is None
    assert said.loss == result.loss


def test_a_scale_of_all_parameters_changes_no_motion_and_no_loss():
    """m, J, d, c and the torque times k: the same recording, the same ratios and misfit exactly."""
    results = []
    for k in (1.0, 1.25):
        values = {"mass": 4.5 * k, "inertia": 0.42 * k, "damping": 0.33 * k, "stiffness": 2.6 * k}
        cycle = replace(CYCLE, amplitude=-4.0 * k)
        results.append(fit(recorded(cycle, **values), prior="none", multistart=8))
    one_, other = results
    assert one_.loss == pytest.approx(other.loss, rel=1e-9)
    for name, each in one_.ratios.items():
        assert other.ratios[name].value == pytest.approx(each.value, rel=1e-6)


def test_two_equal_runs_are_equal_to_the_bit():
    recording = recorded(DROP)
    first, second = (fit(recording, multistart=8, seed=3) for _ in range(2))
    assert first.parameters == second.parameters
    assert first.ratios == second.ratios
    assert first.loss == second.loss
    assert np.array_equal(first.multistart.loss, second.multistart.loss)
    assert np.array_equal(first.segments[0].simulated_angle, second.segments[0].simulated_angle)


def test_other_starts_come_to_the_same_leg():
    recording = recorded(DROP)
    first, second = (fit(recording, multistart=8, seed=seed) for seed in (3, 4))
    for name, each in first.parameters.items():
        close = 0.01 * each.standard_error
        assert second.parameters[name].value == pytest.approx(each.value, abs=close)
    assert second.loss == pytest.approx(first.loss, rel=1e-6)


def test_missing_samples_and_gaps_do_not_hurt():
    recording = recorded(DROP)
    segment, generator = recording.segments[0], np.random.default_rng(5)
    size = segment.time.size
    angle, rate = segment.raw_angle.copy(), segment.raw_angular_velocity.copy()
    angle[generator.random(size) < 0.1] = np.nan
    rate[generator.random(size) < 0.1] = np.nan
    gone = (segment.time > 1.9) & (segment.time < 2.1)  # 0.2 s in full motion
    kept = {
        name: samples[~gone]
        for name, samples in replace(segment, raw_angle=angle, raw_angular_velocity=rate)
        .channels()
        .items()
    }
    broken = replace(recording, segments=(Segment(**kept),))
    whole, result = fit(recording, multistart=8), fit(broken, multistart=8)
    assert result.segments[0].time.size < whole.segments[0].time.size
    assert max(np.abs(errors(result, true_ratios(leg())))) < 4
    # The noise is told from the samples that are left, 300 of a channel, to 1 / sqrt(2 n) = 4 %; by
    # how much a leg with its foot may be off is told by that noise: up to 40 % of an error.
    for name in RATIOS:
        assert (
            0.7 * whole.ratios[name].standard_error
            < result.ratios[name].standard_error
            < 1.5 * whole.ratios[name].standard_error
        )


def test_nearly_every_start_of_the_whole_box_finds_the_best_leg():
    starts = draw(256, seed=11)
    report = fit(recorded(CYCLE), starts=starts).multistart
    assert report.starts == 256
    assert report.at_best >= 0.99 * 256


def test_a_ratio_on_a_limit_has_no_error_and_no_rounding_of_it():
    """m l g / J on the limit that no part of a leg is farther out than it reaches, c on zero."""
    result = fit(recorded(DROP, inertia=0.9), multistart=4)
    assert not result.follows
    for name in ("gravity_over_inertia", "stiffness_over_inertia"):
        held = result.ratios[name]
        assert (held.standard_error, held.determined_by, held.reason) == (None, "bound", ON_BOUND)
    assert result.ratios["gravity_over_inertia"].value > 0
    assert result.multistart.family["stiffness"] == (0.0, 0.0)


def test_every_member_of_the_family_moves_as_the_best_and_meets_the_limits():
    result = fit(recorded(CYCLE), starts=draw(64, seed=2))
    members = {name: values[:40] for name, values in result.multistart.members.items()}
    best = {name: result.parameters[name].value for name in members}
    reach = float(np.hypot(0.285, 0.118)) * BODY.height
    time = jnp.asarray(result.segments[0].time)
    start = state(result.segments[0].simulated_angle[0], result.segments[0].simulated_velocity[0])

    def moved(values):
        return simulate(LegModel(LegParameters(**values), NoTorque()), start, time).angle

    expected = jax.jit(moved)({name: jnp.asarray(value) for name, value in best.items()})
    found = jax.jit(jax.vmap(moved))(
        {name: jnp.asarray(values) for name, values in members.items()}
    )
    assert np.abs(found - expected).max() < 1e-9
    slack = 1e-9
    moment = members["mass"] * members["com_distance"]
    assert np.all(moment * members["com_distance"] <= members["inertia"] * (1 + slack))
    assert np.all(members["inertia"] <= reach * moment * (1 + slack))
    for name, values in members.items():
        each = result.parameters[name]
        assert values.min() >= each.lower - slack
        assert values.max() <= each.upper + slack
        low, high = result.multistart.family[name]
        assert low <= values.min() * (1 + slack)
        assert values.max() <= high * (1 + slack)
    assert np.ptp(members["inertia"]) > 0.1  # a family, not a point


REAL = {  # name: least and greatest angle RMSE in deg, and range of m l g / J in 1/s^2, if any
    "knee-drop": (0.9, 1.25, (24, 36)),
    "motor-ringing": (2.4, 2.85, None),  # most of what it does is friction, and the fit says so
    "motor-swing": (0.7, 0.95, (14, 19)),
    "servo-drop": (0.8, 1.5, (55, 85)),
}


@pytest.mark.proof
@pytest.mark.parametrize("name", REAL)
def test_real_recordings_are_fitted_as_well_as_a_wide_search_did(name, shared):
    """That search had 1.21, 2.75, 0.88 and 1.43 deg; clipping leaves out what is at rest."""
    recording, _ = read_table(shared / "real" / f"{name}.csv")
    result = fit(recording, multistart=16)
    least, greatest, gravity = REAL[name]
    assert least < np.degrees(result.angle_rmse) < greatest
    if gravity is None:
        assert not result.follows
    else:
        assert gravity[0] < result.ratios["gravity_over_inertia"].value < gravity[1]
    assert not any("tilted" in note for note in result.notes)  # friction makes no seat lie
    assert result.ratios["damping_over_inertia"].value > -1e-3
    assert result.multistart.at_best == 16
    # Dry friction is not in the model, nor what a knee's muscle, or a marker, did.
    assert result.disturbance.widening.max() > 10  # what only data sheets tell widens by nothing
    if result.follows:
        assert any("is more than the sensors' noise" in note for note in result.notes)


def test_that_the_simulation_does_not_follow_the_recording_is_said_first():
    # The paper's expected damping of 30 N m s/rad, weighed as its Eq. 11 does, lets no leg swing.
    lost = fit(recorded(DROP), multistart=4, misfit="paper", prior="paper")
    assert not lost.follows
    assert "does not follow the recording" in lost.notes[0]
    found = fit(recorded(DROP), multistart=4)
    assert found.follows
    assert not any("not follow" in note for note in found.notes)


@pytest.mark.parametrize("scatter", [0.0, 5e-3])  # rad, beside the encoder's
def test_a_misfit_that_weighs_every_sample_alike_has_the_noise_floor_of_the_recording(scatter):
    drop = recorded(DROP).segments[0]
    scattered = drop.raw_angle + np.random.default_rng(1).normal(0, scatter, drop.time.size)
    recording = Recording((Segment(drop.time, raw_angle=scattered),), BODY)
    plain = fit(recording, multistart=4, misfit="paper", prior="none")
    assert plain.angle_noise == fit(recording, multistart=4).angle_noise
    assert plain.angle_noise == pytest.approx(np.hypot(scatter, NOISE.angle_noise), rel=0.2)
    assert 0.9 < plain.angle_rmse / plain.angle_noise < 1.1
    assert not any("is white but" in note for note in plain.notes)


@pytest.mark.parametrize("seed", [0, 1])
def test_a_limit_that_the_search_happens_to_end_on_decides_nothing(seed):
    """Motion alone tells no mass and no place of it: seed 0 ends on m l^2 = J, seed 1 does not."""
    drop = recorded(DROP).segments[0]
    bare = Recording((Segment(drop.time, raw_angle=drop.raw_angle),), Subject(kind="leg"))
    found = fit(bare, multistart=64, seed=seed)
    for name in ("mass", "com_distance"):
        assert found.parameters[name].value is None
    assert not any("m l^2 <= J" in note for note in found.notes)
    ended = found.multistart  # every start is counted once
    assert ended.succeeded + sum(ended.failures.values()) == ended.starts


def test_an_angle_that_counts_the_other_way_is_named():
    drop = recorded(DROP).segments[0]
    turned = Segment(drop.time, raw_angle=-np.asarray(drop.raw_angle))
    with pytest.raises(ValueError, match=r'gravity comes out upwards .* flip="angle"'):
        fit(one(turned), multistart=4)
