"""What a fit says where a recording contradicts its body, its zero or its added mass."""

from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from exoid.fitting.errors.profile import profiles
from exoid.fitting.estimate import fit
from exoid.fitting.misfit.uncertainty import Shares
from exoid.fitting.model.prior_and_limits import believe
from exoid.fitting.model.systematics import Systematics
from exoid.fitting.movements import movements_of
from exoid.fitting.result.estimates.estimate import Estimate
from exoid.fitting.result.remarks.added_mass_remarks import acting
from exoid.fitting.result.remarks.anatomy_remarks import RARE, at_rate, of_anatomy
from exoid.fitting.result.remarks.scale_remarks import POUND, away, of_scale
from exoid.fitting.result.remarks.zero.leaning import LEANING, Leaning
from exoid.fitting.unlike_tables import strange
from exoid.physics.anatomy.added_mass import same_swing
from exoid.physics.anatomy.likeness import pendulum_length
from exoid.physics.leg import GRAVITY
from exoid.recordings.declared.protocol import Protocol
from exoid.recordings.declared.sensors import Sensors
from exoid.recordings.measured.segment import Segment
from exoid.recordings.recording import Recording
from fit_cases import BODY, DROP, LOADED, recorded
from legs import drop, recording

BY_DATA, BY_PRIOR = Shares(1.0, 0.0, 0.0), Shares(0.0, 1.0, 0.0)
INERTIA = Estimate("J", "inertia", "kg m^2", 0.38, 0.005, 0.38, 0.045, shares=BY_DATA)
MASS = Estimate("m", "mass", "kg", 4.3, 0.3, 4.3, 0.32, shares=BY_PRIOR)
LOAD = SimpleNamespace(kind="passive", added_mass=3.3)
BARE = SimpleNamespace(kind="passive", added_mass=0.0)
DRIVEN = SimpleNamespace(kind="measured", added_mass=0.0)


def said(inertia=INERTIA, *segments, mass=MASS) -> str:
    return " ".join(of_scale({"mass": mass, "inertia": inertia}, segments or (BARE, LOAD)))


def times(factor: float, of: Estimate = INERTIA) -> Estimate:
    assert of.value is not None
    return replace(of, value=factor * of.value)


def test_tables_are_not_blamed_for_what_no_leg_follows(monkeypatch):
    """No table touches the free fits: what these miss, too, is not bent by one."""
    monkeypatch.setattr("exoid.fitting.unlike_tables.too_short", lambda result, error: True)
    found = fit(recording(drop()), multistart=4)
    bent = replace(found, astray="it misses the angle")
    assert strange(found)
    assert strange(bent)
    free = found.basis.ended.free
    elsewhere = replace(free, angle=free.angle + 0.3 * np.sin(np.arange(free.angle.shape[-1])))
    ended = replace(found.basis.ended, free=elsewhere)
    assert not strange(replace(bent, basis=replace(found.basis, ended=ended)))


@pytest.mark.parametrize(
    ("factor", "strange"), [(0.6, True), (0.8, False), (1.4, False), (2.2, True)]
)
def test_an_inertia_that_hardly_any_leg_of_this_body_has_is_told(factor, strange):
    """Legs of one body scatter by 12 % in J, as a logarithm: a factor of 1.48 at one in 1000."""
    assert bool(said(times(factor))) == strange


def test_it_says_how_far_and_what_sets_it():
    words = said(times(2.2))
    expected = np.log(2.2) / np.hypot(0.045 / 0.38, 0.005 / (2.2 * 0.38))
    assert f"which is {expected:.2g} standard deviations of its logarithm" in words
    assert "Check the added mass (3.3 kg) and its distance, body mass and height" in words
    assert "unit and gain of the measured torque, body mass" in said(times(2.2), DRIVEN)


def test_pounds_are_asked_for_only_where_they_bring_the_leg_back():
    words = said(times(2.2))
    assert "Is 3.3 kg in pounds? 1.5 kg would give J = 0.379 kg m^2." in words
    assert "pounds" not in said(times(1.6))  # 0.73 of what is expected then
    assert "pounds" not in said(times(0.45))
    assert "pounds" not in said(times(2.2), DRIVEN)
    assert "pounds" not in said(times(2.2), LOAD, replace_mass(LOAD, 2.0))


def replace_mass(each: SimpleNamespace, mass: float) -> SimpleNamespace:
    return SimpleNamespace(**{**vars(each), "added_mass": mass})


def test_what_the_recording_alone_does_not_tell_is_not_compared():
    far = times(2.2)
    assert said(replace(far, shares=BY_PRIOR)) == said(replace(far, by_hand="fix")) == ""
    assert said(replace(far, expected=None, expected_deviation=None)) == ""
    vague = replace(far, standard_error=2.2 * 0.38 / 2)
    assert away(vague) == pytest.approx(np.log(2.2) / np.hypot(0.045 / 0.38, 0.5))
    assert said(vague) == ""
    assert "m = 8.6 kg, 2 times" in said(mass=replace(times(2.0, MASS), shares=BY_DATA))


def heavier(recording: Recording, times: float) -> Recording:
    """With other added masses in its sidecar than were on the leg."""
    declared: Any = recording.subject.added_mass
    masses = tuple(times * each for each in declared)
    return replace(recording, subject=replace(recording.subject, added_mass=masses))


def test_a_mass_in_pounds_is_asked_for():
    right = recorded(DROP, LOADED)
    wrong = fit(heavier(right, 1 / POUND), multistart=2)
    (told,) = (note for note in wrong.notes if note.startswith("by this recording J"))
    assert "Is 2.2 kg in pounds? 1 kg would give J = 0.4" in told
    assert not any("by this recording J" in note for note in fit(right, multistart=2).notes)


@pytest.mark.parametrize("factor", [0.8, 1.0, 1.2])
def test_the_rate_that_would_explain_a_leg_that_is_none_goes_by_the_root(factor):
    """Times that are `factor` too long make m l g / J smaller by its square."""
    belief = believe(BODY)
    assert belief.expected is not None
    gravity = GRAVITY / pendulum_length(belief.expected).value / factor**2
    assert f"a sampling rate {factor:.2f} ± " in at_rate(belief, gravity)


@pytest.mark.parametrize(("lower", "bent"), [(0.0, False), (0.3, False), (1.2, True)])
@pytest.mark.parametrize("shorter", [True, False])
def test_a_spring_slack_in_a_bent_position_is_asked_for_first_where_it_would_do(
    lower, bent, shorter
):
    """`lower` is the part that 60 deg make up of what m l g / J is too high. They make none less:
    of a leg that swings too slowly it is never said.
    """
    belief = believe(BODY)
    assert belief.expected is not None
    usual = pendulum_length(belief.expected)
    assert usual.standard_deviation is not None
    length = usual.value
    times = np.exp((5 if shorter else -5) * usual.standard_deviation / length)
    gravity = GRAVITY / length * times
    off = -lower * GRAVITY / length * abs(times - 1) / 2
    slack = Leaning({"gravity_over_inertia": off}, 1.0, 0.0, np.inf, softer=0.0, shown=False)
    (said,) = of_anatomy(belief, gravity, slack)
    first = said.partition("body mass, height and age")[0]
    assert ("slack in a bent position" in first) == (bent and shorter)
    assert ("fewer than one leg in a thousand" in first) != (bent and shorter)
    assert said.endswith("holds as well as 'if slack' beside ± says, if times and zero are right.")
    (sure,) = of_anatomy(belief, gravity, None)
    assert sure.endswith("the ratios to J, holds, if times and zero are right.")
    (vouched,) = of_anatomy(belief, gravity, None, "vouched")
    assert "sampling rate" not in vouched
    assert vouched.endswith("the ratios to J, holds, if the zero is right.")


SEATED = (26.5, 13.2, 1.6)  # m l g / J and c / J [1/s^2], d / J [1/s]


def test_a_leg_whose_spring_is_slack_in_a_bent_position_is_no_strange_one():
    """By Eq. 9 its J / (m l) is 0.06 m less than that of its body."""
    made = [drop(SEATED, at, slack=-0.6, noise=(1.7e-3, 0.0), gyro=False) for at in (-0.2, -0.3)]
    found = fit(recording(*made, sensors=Sensors(angle_noise=1.7e-3)), multistart=2)
    assert "slack in a bent position" in str(found.parameters["inertia"].reason)
    assert not any("fewer than one leg in a thousand" in each for each in found.notes)
    for name, true in zip(LEANING, SEATED, strict=False):
        each = found.ratios[name]
        assert each.if_slack is not None
        assert abs(each.value - true) < 2 * np.hypot(each.standard_error, each.if_slack)


def test_times_of_another_rate_are_among_what_may_be_wrong():
    """J / (m l) of this leg is 2 % less than is expected, and 1 % of the rate."""
    right = recorded(DROP)
    slow = tuple(
        replace(each, time=1.15 * each.time, raw_angular_velocity=None) for each in right.segments
    )
    found = fit(replace(right, segments=slow), multistart=2)
    (told,) = (note for note in found.notes if "J / (m l) =" in note)
    rate = float(told.partition("the times (a sampling rate ")[2].partition(" ")[0])
    assert rate == pytest.approx(0.99 * 1.15, abs=0.02)


RELAXED = (26.8, 2.7, 0.8)  # m l g / J and c / J [1/s^2], d / J [1/s]
BY_TIMES = ("gravity_over_inertia", "stiffness_over_inertia", "damping_over_inertia")


def by_angle(factor: float, leg=RELAXED, **declared) -> Recording:
    """A drop by an angle alone, of which the times are told a `factor` too long."""
    made = drop(leg, -0.35, gyro=False)
    sensors = Sensors(angle_noise=8e-4, **declared)
    return recording(replace(made, time=factor * made.time), sensors=sensors)


@pytest.mark.parametrize("factor", [1.2, 0.8])
def test_of_a_leg_that_none_of_its_body_is_errors_hold_that_its_times_may_be_wrong(factor):
    """120 samples a second, told as 100, or 80."""
    found = fit(by_angle(factor), multistart=2)
    assert {each.value for each in found.of_leg.values()} == {None}
    for name, true in zip(BY_TIMES, RELAXED, strict=True):
        each = found.ratios[name]
        assert abs(each.value - true) > 0.15 * true
        assert abs(each.value - true) < 2.5 * each.standard_error
        assert each.limited_by["clock"] > 0.9
    (said,) = (note for note in found.notes if RARE in note)
    assert "± says, which allows for such times" in said
    assert ("The tables count for nothing here" in said) == (factor < 1)
    assert not any("times to 0.01 %" in note for note in found.notes)


@pytest.mark.parametrize(
    "made",
    [
        by_angle(1.2, clock_uncertainty=1e-4),
        by_angle(1.0, (24.5, 1.2, 0.8)),  # of a body of which one in a hundred has as slow a leg
        by_angle(1.0, (75.0, 10.0, 2.0)),  # a stump
    ],
)
def test_of_times_that_somebody_vouches_for_or_that_may_be_right_they_hold_nothing_more(made):
    each = fit(made, multistart=2).ratios["gravity_over_inertia"]
    assert each.standard_error < 0.02 * each.value


def test_of_times_that_a_gyro_shows_right_nothing_is_said_nor_held():
    """A leg with a mass at its ankle that nobody declared."""
    slow = drop((21.0, 2.0, 0.6), -0.35)
    found = fit(recording(slow), multistart=2)
    (said,) = (note for note in found.notes if RARE in note)
    assert "sampling rate" not in said
    each = found.ratios["gravity_over_inertia"]
    assert abs(each.value - 21.0) < 4 * each.standard_error
    assert each.standard_error < 0.02 * each.value


def test_a_zero_that_is_far_from_what_was_assumed_is_told():
    right, tilt = recorded(DROP), np.radians(7.0)
    turned = tuple(replace(each, raw_angle=each.raw_angle + tilt) for each in right.segments)
    found = fit(replace(right, segments=turned), multistart=2)
    (told,) = (note for note in found.notes if "by this fit the encoder shows" in note)
    assert "by this fit the encoder shows 6.9" in told  # what is usual pulls it
    assert "± 1.2 deg that is assumed" in told
    assert "angle_zero_deg" in told
    usual = fit(right, multistart=2).notes
    assert not any("by this fit the encoder shows" in note for note in usual)


def test_a_mass_elsewhere_swings_as_the_pendulum_that_motion_shows():
    """r + k^2 / r is the same, whichever k is taken for granted."""
    assert same_swing(0.25, 0.15 * 0.25, 0.0) == pytest.approx(0.4)
    at = same_swing(0.25, 0.036, 0.05**2)
    assert at + 0.05**2 / at == pytest.approx(0.25 + 0.036 / 0.25)
    assert same_swing(0.3, 0.05**2, 0.05**2) == pytest.approx(0.3)


@pytest.mark.parametrize("gyration", [0.0, None])
def test_a_mass_at_another_distance_is_told_by_its_distance(gyration):
    """Where nobody says how far it extends, that would have to be what nobody has."""
    right = recorded(DROP, LOADED)  # 1 kg at 0.40 m
    declared: Any = right.subject.added_mass_distance
    at = tuple(0.2 if each else each for each in declared)
    subject = replace(right.subject, added_mass_distance=at, added_mass_gyration=gyration)
    found = fit(replace(right, subject=subject), multistart=2)
    assert found.astray is None
    (told,) = (note for note in found.notes if "does not agree with how the leg moves" in note)
    assert "where 0.2 m is declared" in told
    assert ("if its radius of gyration is the usual 0.05 m" in told) == (gyration is None)
    acts = float(told.partition("acts as one at ")[2].partition(" m")[0])
    assert acts == pytest.approx(0.4, abs=0.02)  # the tape's 5 mm pull it
    assert {each.value for each in found.parameters.values()} == {None}
    assert all(each.value is not None for each in found.ratios.values())


def swings(inertia: float, weight: float, knee: float = 1.0) -> tuple[np.ndarray, np.ndarray]:
    """A leg let go at -20 deg that weighs m l g about its knee, by SciPy: time and angle."""
    time = np.arange(0.0, 4.0, 0.01)

    def slope(_: float, state: np.ndarray) -> list[float]:
        angle, velocity = state
        torque = -weight * np.cos(angle) - knee * (1.6 * angle + 0.25 * velocity)
        return [velocity, torque / inertia]

    start = [np.radians(-20.0), 0.0]
    solved = solve_ivp(slope, (0.0, 4.0), start, t_eval=time, rtol=1e-9, atol=1e-10)
    return time, solved.y[0]


def with_mass(at: float, gyration: float, declared: float) -> Recording:
    """One drop without, one with 1 kg that hangs `at` a distance, and another that is declared."""
    rng = np.random.default_rng(3)
    bare = swings(0.41, 11.0)
    heavy = swings(0.41 + at**2 + gyration**2, 11.0 + GRAVITY * at)
    segments = [
        Segment(time, raw_angle=angle + rng.normal(0.0, 1.7e-3, time.size))
        for time, angle in (bare, heavy)
    ]
    subject = replace(BODY, added_mass=(0.0, 1.0), added_mass_distance=declared)
    return Recording(tuple(segments), subject, Protocol(kind="passive"))


def test_a_distance_that_does_not_agree_with_the_motion_leaves_nothing_but_ratios():
    """8 cm short, as from a wrong mark: no cuff extends so far that it would swing like that."""
    found = fit(with_mass(at=0.38, gyration=0.0, declared=0.30), multistart=4)
    (told,) = (note for note in found.notes if "does not agree with how the leg moves" in note)
    acts = float(told.partition("acts as one at ")[2].partition(" m")[0])
    assert acts == pytest.approx(0.38, abs=0.015)  # the usual extent, 5 cm, is 7 mm of it
    assert {each.value for each in found.parameters.values()} == {None}
    ratio = found.ratios["gravity_over_inertia"]
    assert ratio.value is not None
    assert ratio.standard_error is not None
    assert abs(ratio.value - 11.0 / 0.41) < 3 * ratio.standard_error


def test_a_mass_that_hangs_four_centimetres_elsewhere_is_told_and_held_by_the_errors():
    """Of an extent a little beyond what is believed it would move alike: by that alone J was told
    6 errors off, without a word.
    """
    found = fit(with_mass(at=0.395, gyration=0.0, declared=0.36), multistart=4)
    (told,) = (note for note in found.notes if "hardly agrees with how the leg moves" in note)
    assert "± of J, and of what goes with it, holds" in told
    inertia, moment = found.parameters["inertia"], found.gravity_moment
    assert moment is not None
    for each, true in ((inertia, 0.41), (moment, 11.0)):
        assert each.value is not None
        assert each.standard_error is not None
        assert abs(each.value - true) > 0.05 * true
        assert abs(each.value - true) < 3 * each.standard_error
    assert inertia.limited_by["added_mass_distance"] > 0.8
    assert any("the weight of the added mass to 0.5 %" in note for note in found.notes)


@pytest.mark.parametrize("distance", [0.296, 0.292])
def test_a_mass_that_acts_elsewhere_is_said_to_be_where_it_is_not_declared(distance):
    """Its distance and its extent may go together so that it swings just as declared."""
    (each,) = movements_of([("a", with_mass(0.3, 0.0127, declared=0.3))])[1:]
    known = frozenset({"extent"})
    each = replace(each, systematics=Systematics(expected_extent=0.0127**2, declared=known))
    square = distance * (0.3 + 0.0127**2 / 0.3 - distance)
    moved = {"log_distance": np.log(distance / 0.3), "extent": square - 0.0127**2}
    said = acting(each, lambda name: moved[name])
    assert said.startswith(f"{distance:.3g} m from the knee")
    assert "where 0.3 m is declared" in said


def test_a_mass_that_swings_as_declared_and_weighs_otherwise_is_told_by_both():
    """A millimetre is none: it is its extent that differs."""
    (each,) = movements_of([("a", with_mass(0.41, 0.05, declared=0.41))])[1:]
    moved = {"log_distance": np.log(0.397 / 0.41), "extent": 0.086**2 - 0.05**2}
    said = acting(each, lambda name: moved[name])
    assert said.startswith("0.397 m from the knee with a radius of gyration of 0.086 m")
    assert "0.41 m is declared" in said


@pytest.mark.parametrize(("gyration", "off"), [(0.0, 0.005), (0.05, -0.005), (0.1, 0.0)])
def test_a_mass_where_it_is_said_to_hang_is_believed(gyration, off):
    """By a tape that is 5 mm off, of any extent that is believed."""
    found = fit(with_mass(0.38, gyration, declared=0.38 + off), multistart=4)
    assert not any("does not agree with how the leg moves" in note for note in found.notes)
    inertia = found.parameters["inertia"]
    assert inertia.value is not None
    assert inertia.standard_error is not None
    assert abs(inertia.value - 0.41) < 3.3 * inertia.standard_error


STUMP = 0.017, 1.285  # kg m^2, N m: below the knee of an amputee who weighs as BODY does
SHORTER = 0.004, 0.47  # beyond what limits of any leg of that body hold


def stump(load: float, size: tuple[float, float] = STUMP) -> Recording:
    """A drop of it without and, where there is any, one with a `load` [kg] 0.1 m below the knee."""
    rng, loads = np.random.default_rng(5), (0.0, load) if load else (0.0,)
    segments = []
    for each in loads:
        inertia = size[0] + each * (0.1**2 + 0.02**2)
        time, angle = swings(inertia, size[1] + each * GRAVITY * 0.1, knee=size[0] / 0.17)
        noisy = angle + rng.normal(0.0, 1.7e-3, time.size)
        segments.append(Segment(time, raw_angle=noisy))
    subject = replace(BODY, added_mass=loads, added_mass_distance=0.1, added_mass_gyration=0.02)
    return Recording(tuple(segments), subject, Protocol(kind="passive"))


@pytest.mark.parametrize("size", [STUMP, SHORTER])
def test_of_a_leg_that_anatomy_does_not_know_motion_tells_the_ratios_and_no_table_the_rest(size):
    found = fit(stump(0.0, size), multistart=4)
    assert found.follows
    assert {each.value for each in found.of_leg.values()} == {None}
    reason = str(found.parameters["inertia"].reason)
    assert "no leg of this body, as the tables of anatomy have it" in reason
    ratio = found.ratios["gravity_over_inertia"]
    assert abs(ratio.value - size[1] / size[0]) < 3 * ratio.standard_error
    assert profiles(found) == {}  # they would hold the tables' leg against this one


def test_what_the_body_is_said_to_be_pulls_no_ratio_of_a_leg_that_is_none_of_it():
    known = stump(0.0, SHORTER)
    unknown = replace(known, subject=replace(BODY, body_mass=None, height=None))
    told, untold = (fit(each, multistart=4).ratios for each in (known, unknown))
    for name, each in told.items():
        assert each.value == pytest.approx(untold[name].value, abs=0.1 * each.standard_error)


def test_what_a_known_mass_tells_of_it_stays():
    bound = {"inertia": (0.0, 1.0), "com_distance": (0.02, 0.5), "mass": (0.1, 10.0)}
    found = fit(stump(0.5), multistart=4, prior="none", bounds="paper", bound=bound)
    inertia = found.parameters["inertia"]
    assert abs(inertia.value - STUMP[0]) < 3 * inertia.standard_error
