"""A fit with terms recovers them and the leg, as one without recovers the leg."""

from dataclasses import replace

import jax
import jax.numpy as jnp
import numpy as np
import pytest

from exoid.fitting.errors.posterior import sample
from exoid.fitting.errors.profile import profiles
from exoid.fitting.estimate import fit
from exoid.fitting.model.term_parameters import over_inertia, parameters_of, term_of
from exoid.fitting.multistart.beginning import join_terms
from exoid.fitting.solve.ask import advance
from exoid.physics.leg import LegModel
from exoid.physics.library import library
from exoid.physics.sensing.gyro_bias import GyroBias
from exoid.physics.sensing.gyro_scale import GyroScale
from exoid.physics.sensing.sensor_skew import SensorSkew
from exoid.physics.terms.device.coulomb_friction import CoulombFriction
from exoid.physics.terms.device.sticking_backlash import StickingBacklash
from exoid.physics.terms.tissue.maxwell_element import MaxwellElement
from exoid.physics.torque import NoTorque
from exoid.planning.plan import plan
from exoid.recordings.signal.condition import cut
from exoid.report.saved.saved_result import load_result, save_result
from exoid.trust.identify import identify
from exoid.twin.motion import Movement
from exoid.twin.protocols import record
from fit_cases import BODY, leg

DROPS = (Movement(-0.35, 3.0), Movement(-0.87, 3.0))  # rad, s
LOADED = replace(DROPS[0], added_mass=1.0, added_mass_distance=0.4)
FRICTION, BIAS = 0.25, 0.01  # N m, rad/s
LIKELY = 4.5  # standard errors within which the truth lies, but for one draw in 100 000
RATIOS = {
    "gravity_over_inertia": 4.5 * 0.26 * 9.81 / 0.42,
    "stiffness_over_inertia": 2.6 / 0.42,
    "damping_over_inertia": 0.33 / 0.42,
}


def worn(*terms, movements=DROPS):
    model = LegModel(leg(), NoTorque(), terms=terms)
    return record(model, movements, jax.random.key(0), subject=BODY)


def likely(each, truth):
    return abs(each.value - truth) < LIKELY * each.standard_error


@pytest.fixture(scope="module")
def rubbing():
    return worn(CoulombFriction(jnp.asarray(FRICTION)), GyroBias(jnp.asarray(BIAS)))


@pytest.fixture(scope="module")
def found(rubbing):
    return fit(rubbing, multistart=4, terms=(CoulombFriction, GyroBias))


def test_the_leg_and_the_terms_come_back_together(found):
    assert found.follows
    assert found.disturbance.cause is None
    for name, truth in RATIOS.items():
        assert likely(found.ratios[name], truth), name
    friction = found.terms["coulomb_friction"]
    assert likely(friction["level_over_inertia"], FRICTION / 0.42)
    assert friction["level_over_inertia"].determined_by == "data"
    assert likely(found.terms["gyro_bias"]["bias"], BIAS)


def test_torques_rest_on_the_inertia_as_far_as_nothing_tells_it(found):
    level, inertia = found.terms["coulomb_friction"]["level"], found.parameters["inertia"]
    assert level.determined_by == inertia.determined_by == "prior"
    relative = inertia.standard_error / inertia.value
    assert level.standard_error / level.value == pytest.approx(relative, rel=0.01)


def test_what_a_term_is_itself_is_no_unknown_of_the_mounting(found):
    assert "gyro_bias" not in found.mountings[0].known
    assert "gyro_bias" not in found.basis.problem.owned


@pytest.mark.proof
def test_a_known_mass_tells_the_torque_itself():
    recording = worn(CoulombFriction(jnp.asarray(FRICTION)), movements=(*DROPS, LOADED))
    each = fit(recording, multistart=4, terms=(CoulombFriction,))
    level = each.terms["coulomb_friction"]["level"]
    assert level.determined_by == "data"
    assert likely(level, FRICTION)
    assert level.standard_error < 0.02 * FRICTION


def test_a_term_that_does_not_act_moves_nothing(rubbing):
    clean = worn()
    with_it = fit(clean, multistart=2, terms=(CoulombFriction,))
    level = with_it.terms["coulomb_friction"]["level_over_inertia"]
    assert level.value < 5e-3  # 1/s^2; it cannot be negative, so its error may not be quoted
    for name, truth in RATIOS.items():
        assert likely(with_it.ratios[name], truth), name


@pytest.mark.proof
def test_a_value_that_is_fixed_stays_and_one_that_is_expected_draws(rubbing):
    terms = (CoulombFriction, GyroBias)
    fixed = fit(rubbing, multistart=2, terms=terms, fix={"coulomb_friction.level": 0.2})
    level = fixed.terms["coulomb_friction"]["level"]
    assert (level.value, level.standard_error, level.set_by) == (0.2, 0.0, "fixed by you")
    # Then the ratio, which the motion tells, tells the inertia.
    assert fixed.parameters["inertia"].value == pytest.approx(0.2 * 0.42 / FRICTION, rel=0.01)
    drawn = sample(fixed, draws=10, warmup=10, chains=2)
    assert drawn.samples["coulomb_friction.level"] == pytest.approx(0.2, rel=2e-3)


def test_what_is_expected_of_a_term_is_told_as_firmly_as_it_counts(rubbing):
    expect = {"coulomb_friction.level": (0.2, 0.1), "damping": (0.3, 0.1)}
    terms = (CoulombFriction, GyroBias)
    firm = fit(rubbing, multistart=1, terms=terms, expect=expect, weight=4.0)
    level, damping = firm.terms["coulomb_friction"]["level"], firm.parameters["damping"]
    assert (level.expected, level.expected_deviation) == (0.2, 0.05)  # lambda 4 halves it
    assert damping.expected_deviation == 0.05


def test_an_end_of_a_range_that_holds_is_said(rubbing):
    bounded = fit(
        rubbing,
        multistart=2,
        terms=(CoulombFriction, GyroBias),
        bound={"gyro_bias.bias": (0.0, 5e-3)},
    )
    bias = bounded.terms["gyro_bias"]["bias"]
    assert bias.value == 5e-3
    assert bias.standard_error is None
    assert bias.set_by == "your bound"


def test_a_gyro_of_another_scale_leaves_the_clock_in_doubt_as_a_term_too():
    """Encoder and gyro show one ratio: the clock may be what is off, and m l g / J goes by it."""
    off = worn(GyroScale(jnp.asarray(0.03)))
    owned, term = (fit(off, multistart=2, terms=terms) for terms in ((), (GyroScale,)))
    for name in RATIOS:
        error, own = (each.ratios[name].standard_error for each in (term, owned))
        assert error == pytest.approx(own, rel=0.1)
    assert term.terms["gyro_scale"]["scale"].standard_error > 0.004


def test_a_bound_that_moves_the_inertia_leaves_the_ratio_to_the_data(rubbing, found):
    told = found.terms["coulomb_friction"]["level_over_inertia"]
    bound = {"coulomb_friction.level": (1.3 * FRICTION, 1.0)}
    pushed = fit(rubbing, multistart=2, terms=(CoulombFriction, GyroBias), bound=bound)
    ratio = pushed.terms["coulomb_friction"]["level_over_inertia"]
    assert ratio.set_by == "data"
    assert ratio.standard_error == pytest.approx(told.standard_error, rel=0.1)


@pytest.mark.parametrize(
    ("options", "said"),
    [
        ({"terms": (CoulombFriction, CoulombFriction)}, "given twice"),
        ({"fix": {"coulomb_friction.level": 0.2}}, "it has no terms.*term, coulomb_friction"),
        (
            {"terms": (CoulombFriction,), "fix": {"coulomb_friction.levle": 0.2}},
            "it has coulomb_friction.level",
        ),
        (
            {"terms": (CoulombFriction,), "fix": {"coulomb_friction.level": -0.2}},
            "it is 0 to 50 N m",
        ),
        (
            {"terms": (CoulombFriction,), "bound": {"coulomb_friction.level": (60.0, 70.0)}},
            "nothing is left of 0 to 50 N m",
        ),
    ],
)
def test_what_no_model_can_have_is_refused(rubbing, options, said):
    with pytest.raises(ValueError, match=said):
        fit(rubbing, multistart=1, **options)


def test_on_its_way_to_the_terms_a_leg_leaves_recordings_as_declared(rubbing, monkeypatch):
    """An encoder's zero half a turn off is a leg that gravity pushes up: far from the terms that
    may leave less.
    """
    moved = []

    def watched(problem, starts, *asked):
        ended = advance(problem, starts, *asked)
        before, after = starts.mounting.zero, ended.coordinates.mounting.zero
        moved.append(float(np.abs(after - before).max()))
        return ended

    monkeypatch.setattr(join_terms, "advance", watched)
    fit(rubbing, multistart=4, terms=(CoulombFriction,))
    assert moved[0] == 0 < max(moved)


@pytest.mark.proof
def test_a_late_gyro_comes_back_to_a_tenth_of_a_millisecond():
    each = fit(worn(SensorSkew(jnp.asarray(0.008))), multistart=2, terms=(SensorSkew,))
    assert each.terms["sensor_skew"]["skew"].value == pytest.approx(0.008, abs=1e-4)
    for name, truth in RATIOS.items():
        assert likely(each.ratios[name], truth), name


@pytest.mark.proof
def test_a_term_that_remembers_says_what_its_errors_leave_out(found):
    assert not any("remember" in each for each in found.notes)
    whole = worn()
    relaxing = fit(whole, multistart=2, terms=(MaxwellElement,))
    assert any("maxwell_element may remember for seconds" in each for each in relaxing.notes)
    begun = replace(whole, segments=tuple(cut(each, slice(140, None)) for each in whole.segments))
    playing = fit(begun, multistart=2, terms=(StickingBacklash,))
    assert any(
        "what sticking_backlash remembers of before is unknown" in each for each in playing.notes
    )


@pytest.mark.proof
def test_profiles_directions_and_plans_know_the_terms(found):
    profile = profiles(found)["coulomb_friction.level_over_inertia"]
    estimate = found.terms["coulomb_friction"]["level_over_inertia"]
    assert profile.lower < estimate.value < profile.upper
    half = (profile.upper - profile.lower) / 2
    assert half == pytest.approx(1.96 * estimate.standard_error, rel=0.1)
    told = identify(found)
    assert any("F_c" in each.words for each in told.null_directions)  # goes with J
    narrowed = plan(found, BODY, "coulomb_friction.level")
    assert narrowed.after < narrowed.before
    assert any(each.motion.added_mass for each in narrowed.proposed)  # only a mass tells J


def test_a_saved_model_simulates_the_recording_again(found, tmp_path):
    save_result(found, tmp_path / "worn.nc")
    back = load_result(tmp_path / "worn.nc").result.model
    assert [type(term) for term in back.terms] == [CoulombFriction, GyroBias]
    again = record(back, DROPS, jax.random.key(1), subject=BODY, exact=True)
    truth = worn_exactly()
    for one, other in zip(again.segments, truth.segments, strict=True):
        assert np.abs(one.raw_angle - other.raw_angle).max() < 2e-3  # rad, two of noise


def worn_exactly():
    terms = CoulombFriction(jnp.asarray(FRICTION)), GyroBias(jnp.asarray(BIAS))
    model = LegModel(leg(), NoTorque(), terms=terms)
    return record(model, DROPS, jax.random.key(1), subject=BODY, exact=True)


@pytest.mark.proof
def test_slsqp_ends_where_least_squares_do(rubbing, found):
    reference = fit(rubbing, multistart=1, terms=(CoulombFriction, GyroBias), method="slsqp")
    for name, each in found.of_terms.items():
        other = reference.of_terms[name]
        # Finite differences across the kinks of dry friction end within a part of the error.
        assert abs(other.value - each.value) < 0.5 * each.standard_error, name


@pytest.mark.parametrize("term", library(), ids=lambda term: term.__name__)
def test_over_the_inertia_and_back_is_the_term(term):
    values = term_of(term, lambda _, declared: (declared.lower + declared.upper) / 2)
    back = over_inertia(over_inertia(values, 0.4), 1 / 0.4)
    for one, other in zip(jax.tree.leaves(values), jax.tree.leaves(back), strict=True):
        assert one == pytest.approx(other, rel=1e-14)
    assert [name.partition(".")[0] for name, _ in parameters_of((term,))]
