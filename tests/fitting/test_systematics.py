"""What is not as declared, made by SciPy: zero, seat, gyro, clock and added mass cost no truth."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from exoid.fitting.data.segment import movement
from exoid.fitting.estimate import fit
from exoid.fitting.model.systematics import ALIKE, ONE_SCALE, in_common
from exoid.fitting.result.chief import chief
from exoid.fitting.result.systematics.limiting import ADVICE, limited_anew, limiting, what_to_do
from exoid.physics.sensing.clock_rate import ClockRate
from exoid.recordings.declared.protocol import Protocol
from exoid.recordings.measured.segment import Segment
from exoid.recordings.recording import Recording
from fit_cases import BODY, NOISE

LEG = {"inertia": 0.42, "gravity": 27.0, "stiffness": 6.2, "damping": 0.8}  # kg m^2, over J
RATIOS = ("gravity", "stiffness", "damping")
STARTS = np.radians([-10.0, -25.0, -40.0, -10.0, -25.0])
TIME = np.arange(240) * 0.01  # s, as recorded
WITHIN = 3.0  # standard errors: 0.3 % of normal draws are beyond
QUARTZ = replace(NOISE, clock_uncertainty=1e-4)


def drop(
    rng,
    start,
    *,
    zero=0.0,
    tilt=0.0,
    scale=0.0,
    bias=0.0,
    clock=0.0,
    load=(0.0, 0.0, 0.0),
    curved=0.0,
):
    """Eq. 9 by DOP853, seen by sensors that are not as declared; a `curved` spring [N m/rad^2]."""
    mass, distance, gyration = load
    inertia = LEG["inertia"] + mass * (distance**2 + gyration**2)
    moment = LEG["gravity"] * LEG["inertia"] + mass * distance * 9.81
    spring, damper = (LEG[name] * LEG["inertia"] for name in ("stiffness", "damping"))

    def rate(_, at):
        torque = moment * np.cos(at[0] + tilt) + spring * at[0] + damper * at[1]
        torque += curved * (at[0] + 0.8) * abs(at[0] + 0.8)
        return [at[1], -torque / inertia]

    true = (1 + clock) * TIME
    motion = solve_ivp(rate, (0, true[-1]), [start, 0.0], "DOP853", true, rtol=1e-10, atol=1e-12).y
    noise = rng.normal(size=(2, TIME.size)) * [[NOISE.angle_noise], [NOISE.velocity_noise]]
    return Segment(
        TIME,
        raw_angle=motion[0] + zero + noise[0],
        raw_angular_velocity=(1 + scale) * motion[1] + bias + noise[1],
    )


def drops(seed=0, sensors=QUARTZ, **wrong):
    """Five drops of one leg."""
    rng = np.random.default_rng(seed)
    segments = tuple(drop(rng, start, **wrong) for start in STARTS)
    return Recording(segments, BODY, Protocol(kind="passive"), sensors)


def off(result):
    """(estimate - truth) / standard error of every ratio."""
    each = {name: result.ratios[f"{name}_over_inertia"] for name in RATIOS}
    return {name: (one.value - LEG[name]) / one.standard_error for name, one in each.items()}


WRONG = {
    "a zero of 2 deg": {"zero": np.radians(2.0)},
    "a seat tilted by 3 deg": {"tilt": np.radians(3.0)},
    "a gyro of another scale": {"scale": -0.02},
    "a gyro with a bias": {"bias": np.radians(3.0)},
    "a quartz clock": {"clock": 1e-4},
    "all of them": {
        "zero": np.radians(-1.5),
        "tilt": np.radians(0.3),
        "scale": 0.015,
        "bias": np.radians(-5.0),
        "clock": -1e-4,
    },
}


QUICK = "all of them"  # on every run; each by itself as a proof


@pytest.mark.proof
@pytest.mark.parametrize(
    "wrong",
    [
        pytest.param(wrong, id=name, marks=[] if name == QUICK else pytest.mark.proof)
        for name, wrong in WRONG.items()
    ],
)
def test_what_is_not_as_declared_stays_within_the_errors(wrong):
    result = fit(drops(**wrong), multistart=2)
    assert max(map(abs, off(result).values())) < WITHIN, off(result)
    assert result.disturbance.cause is None
    truth = {"zero": "zero", "tilt": "tilt", "gyro_scale": "scale", "gyro_bias": "bias"}
    for name, each in result.mountings[0].known.items():
        if name in truth:
            expected = wrong.get(truth[name], 0.0)
            assert abs(each.value - expected) < WITHIN * each.standard_error


def test_a_tilted_seat_is_named_and_measured():
    result = fit(drops(tilt=np.radians(3.0)), multistart=2)
    assert any("tilted" in note for note in result.notes)
    told = fit(drops(tilt=0.0), multistart=2)
    assert not any("tilted" in note for note in told.notes)


def test_a_spring_that_a_seat_has_to_stand_for_is_no_tilted_seat():
    result = fit(drops(curved=2.0), multistart=2)
    assert result.disturbance.cause == "torque"
    said = " ".join(result.notes)
    assert "That may be what the model misses, as of a spring" in said
    assert "seems to be tilted" not in said


def test_a_clock_that_nobody_vouches_for_is_allowed_for_where_the_sensors_disagree():
    """Half a per cent of the clock is one of m l g / J, and looks like a gyro's scale."""
    result = fit(drops(clock=5e-3, sensors=NOISE), multistart=2)
    assert max(map(abs, off(result).values())) < WITHIN, off(result)
    assert any("clock" in note for note in result.notes)
    assert result.ratios["gravity_over_inertia"].limited_by["clock"] > 0.5
    sure = fit(drops(scale=5e-3), multistart=2)
    assert max(map(abs, off(sure).values())) < WITHIN
    error = [each.ratios["gravity_over_inertia"].standard_error for each in (result, sure)]
    assert error[0] > 3 * error[1]


OFF = [(0.03, 0.0), (0.022, 0.0), (-0.022, 0.0), (0.015, 0.0), (0.0, 0.022)]


@pytest.mark.parametrize(("clock", "scale"), OFF)
def test_a_wrong_rate_of_samples_is_within_the_errors(clock, scale):
    """Beside a gyro it looks as if that were off, by whatever size: either is as likely."""
    result = fit(drops(clock=clock, scale=scale, sensors=NOISE), multistart=2)
    assert max(map(abs, off(result).values())) < WITHIN, off(result)


@pytest.mark.parametrize("clock", [0.06, -0.09])
def test_a_leg_as_anatomy_has_it_makes_nobody_surer_of_a_clock_that_is_far_off(clock):
    """Its m l g / J as told is one that anatomy does not expect: that speaks against the clock as
    declared, by which it is told, and made ± half as wide as 60 % of the disagreement (4 to 7
    errors off). Of a clock that is off by x, m l g / J is by 2 x.
    """
    result = fit(drops(clock=clock, sensors=NOISE), multistart=2)  # J / (m l) = 0.363 m
    assert max(map(abs, off(result).values())) < WITHIN, off(result)
    gravity = result.ratios["gravity_over_inertia"]
    least = 2 * 0.5 * abs(clock)
    assert gravity.standard_error > least * gravity.value
    assert gravity.standard_error < 3 * least * gravity.value


def test_the_rate_of_a_clock_as_a_term_gives_back_the_leg():
    """By the gyro, as well as that is known: within 1.5 %. What legs are like tells a little."""
    result = fit(drops(clock=0.03, sensors=NOISE), multistart=2, terms=(ClockRate,))
    rate = result.terms["clock_rate"]["rate"]
    assert abs(rate.value - 0.03) < rate.standard_error / 3
    assert 0.007 < rate.standard_error < 0.015
    assert max(map(abs, off(result).values())) < WITHIN, off(result)


def loaded(wrong_mass=1.0, seed=0, **declared):
    """Three bare drops and three with 2 kg of 6 cm radius of gyration, at 0.35 m."""
    rng = np.random.default_rng(seed)
    loads = [0.0] * 3 + [2.0] * 3
    segments = tuple(
        drop(rng, start, load=(load * wrong_mass, 0.35, 0.06))
        for start, load in zip(np.tile(STARTS[:3], 2), loads, strict=True)
    )
    subject = replace(BODY, added_mass=tuple(loads), added_mass_distance=(0.35,) * 6, **declared)
    return Recording(segments, subject, Protocol(kind="passive"), QUARTZ)


@pytest.mark.proof
def test_a_mass_that_is_no_point_and_was_weighed_light_stays_within_the_errors():
    result = fit(loaded(1.005), multistart=2)
    inertia = result.parameters["inertia"]
    assert abs(inertia.value - LEG["inertia"]) < 2 * inertia.standard_error
    assert inertia.determined_by == "data"
    assert inertia.limited_by["added_mass_gyration"] > 0.1
    assert any("added mass" in note or "extent" in note for note in result.notes)


def test_what_is_declared_of_the_mass_narrows_the_inertia():
    plain = fit(loaded(), multistart=2).parameters["inertia"]
    known = loaded(
        added_mass_uncertainty=0.002,
        added_mass_distance_uncertainty=0.001,
        added_mass_gyration=0.06,
    )
    told = fit(known, multistart=2).parameters["inertia"]
    assert told.standard_error < plain.standard_error / 3
    assert abs(told.value - LEG["inertia"]) < WITHIN * told.standard_error


def one_by_one(recording, sessions):
    """The same, a file of a segment each."""
    subject = recording.subject
    return [
        (
            f"{number}.csv",
            replace(
                recording,
                segments=(segment,),
                subject=replace(
                    subject,
                    session=session,
                    added_mass=subject.added_mass and subject.added_mass[number],
                    added_mass_distance=subject.added_mass_distance and 0.35,
                ),
            ),
        )
        for number, (segment, session) in enumerate(zip(recording.segments, sessions, strict=True))
    ]


def correlations(named):
    """Of everything that these recordings own."""
    movements = [movement(each, 0, name, at) for at, (name, each) in enumerate(named)]
    whitening = in_common(movements)
    return {name: np.linalg.inv(each.T @ each) for name, each in vars(whitening).items()}


@pytest.mark.parametrize(
    ("told", "others"),
    [
        ({"device": "0A1B"}, {"zero", "gyro_scale", "clock"}),
        ({"encoder_counts": 16384.0}, {"zero"}),
        ({"gyro_range": 500.0}, {"gyro_scale"}),
        ({"angle_noise": 2e-3}, set()),  # of the same encoder, filtered another way
    ],
)
def test_other_sensors_in_a_session_share_neither_zero_nor_scale_nor_clock(told, others):
    sensors = replace(NOISE, device="0A1A", encoder_counts=4096.0, gyro_range=2000.0)
    named = one_by_one(drops(sensors=sensors), [None] * 5)[:2]
    name, second = named[1]
    found = correlations([named[0], (name, replace(second, sensors=replace(sensors, **told)))])
    alone = {each for each, of in found.items() if len(of) == 2 and of[0, 1] == 0.0}
    owned = {"zero", "tilt", "gyro_scale", "gyro_bias", "clock"}
    assert alone & owned == others | {"gyro_bias"}  # which drifts
    assert found["tilt"][0, 1] == pytest.approx(ALIKE)  # of one seat


def test_a_recording_that_names_no_device_has_that_of_the_others_unless_they_have_several():
    named = one_by_one(drops(), [None] * 5)[:3]

    def zeros(*devices):
        return correlations(
            [
                (name, replace(each, sensors=replace(each.sensors, device=device)))
                for (name, each), device in zip(named, devices, strict=True)
            ]
        )["zero"]

    every = np.full((3, 3), ALIKE) + (1 - ALIKE) * np.eye(3)
    np.testing.assert_allclose(zeros(None, None, None), every)
    np.testing.assert_allclose(zeros("A", None, None), every)
    np.testing.assert_allclose(zeros("A", "B", None), np.eye(3), atol=1e-15)


def test_masses_that_were_weighed_on_one_scale_share_its_gain_alone():
    """Where each sits, and how far it extends, is its own; so is a weight of another session."""
    three = one_by_one(loaded(), [None] * 6)[3:]
    named = [
        (name, replace(each, subject=replace(each.subject, added_mass=mass)))
        for (name, each), mass in zip(three, (1.0, 2.0, 1.0), strict=True)
    ]
    found = correlations(named)
    np.testing.assert_allclose(found["log_added"][0], [1.0, ONE_SCALE, ALIKE])
    for name in ("log_distance", "extent"):
        np.testing.assert_allclose(found[name][0], [1.0, 0.0, ALIKE], atol=1e-15)
    name, second = named[1]
    anew = replace(second, subject=replace(second.subject, session="2"))
    assert correlations([named[0], (name, anew)])["log_added"][0, 1] == pytest.approx(0.0)


@pytest.mark.slow
def test_files_of_a_session_tell_no_more_of_its_weight_than_one_file_does():
    """Weighed anew for each, three independent weights are better known than one."""
    whole = loaded(added_mass_gyration=0.06)
    together = fit(whole, multistart=2).parameters["inertia"].standard_error
    same = fit(one_by_one(whole, [None] * 6), multistart=2).parameters["inertia"]
    assert same.standard_error == pytest.approx(together, rel=0.06)
    anew = fit(one_by_one(whole, map(str, range(6))), multistart=2).parameters["inertia"]
    assert anew.standard_error < 0.7 * together


@pytest.mark.slow
def test_a_seat_that_is_tilted_in_every_file_of_a_session_is_named():
    whole = drops(tilt=np.radians(3.0))
    result = fit(one_by_one(whole, [None] * 5), multistart=2)
    (said,) = (note for note in result.notes if "to be tilted by" in note)
    assert said.startswith("5 recordings (0.csv, 1.csv, ")
    assert max(map(abs, off(result).values())) < WITHIN, off(result)


def test_a_declared_zero_narrows_what_leans_on_it():
    plain = fit(drops(), multistart=2)
    exact = replace(QUARTZ, angle_zero_uncertainty=0.0)
    sure = fit(drops(sensors=exact), multistart=2)
    assert "zero" not in sure.mountings[0].known
    name = "stiffness_over_inertia"
    assert sure.ratios[name].standard_error < plain.ratios[name].standard_error
    assert plain.ratios[name].limited_by["zero"] > 0
    assert "zero" not in sure.ratios[name].limited_by


def test_nobody_is_told_to_weigh_what_is_weighed():
    """Nor to measure with a tape what the motion tells to a tenth of a millimetre."""
    known = loaded(added_mass_uncertainty=0.002, added_mass_gyration=0.06)
    result = fit(known, multistart=2)
    assert what_to_do("added_mass", result).startswith("± holds what the sidecar says")
    assert what_to_do("added_mass_distance", result) == ADVICE["added_mass_distance"]
    (owned,) = result.mountings
    sure = replace(owned.added_mass_distance, standard_error=1e-4)
    told = replace(result, mountings=[replace(owned, added_mass_distance=sure)])
    assert "to 0.1 mm, better than a tape" in what_to_do("added_mass_distance", told)
    assert what_to_do("zero", result) == ADVICE["zero"]


def test_notes_tell_what_limits_an_error_as_it_is_after_it_was_widened():
    """A systematic is most of the variance of m l g / J, until a rival cause is."""
    before = fit(drops(), multistart=2)
    name = "gravity_over_inertia"
    each = before.ratios[name]
    most = chief(each)
    assert most is not None
    old = limiting(before)
    assert any(f"{each.symbol} ({most[1]:.0%})" in note for note in old)
    wide = each.widened(2 * each.standard_error, cause="rival causes")
    assert wide.limited_by[most[0]] + wide.limited_by["rival causes"] <= 1
    after = limited_anew(replace(before, ratios=before.ratios | {name: wide}), before)
    assert chief(wide)[0] == "rival causes"
    told = [note for note in after.notes if "its part of the variance" in note]
    assert not any(each.symbol in note for note in told)
    others = [note for note in before.notes if note not in old]
    assert [note for note in after.notes if note not in told] == others
