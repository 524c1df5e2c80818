"""Plans against what comes of them: the proposed recording, made, fitted and looked at."""

from dataclasses import replace
from io import StringIO

import jax
import numpy as np
import pytest
from rich.console import Console

from exoid.fitting.estimate import fit
from exoid.fitting.model.coordinates import TYPICAL, quantity_names
from exoid.fitting.model.systematics import OF_THE_LOAD, OF_THE_MASS, in_common
from exoid.physics.leg import LegModel
from exoid.physics.torque import NoTorque
from exoid.planning.candidate_recordings import moving
from exoid.planning.expected_information import Design, informations
from exoid.planning.next_mountings import beliefs, next_of
from exoid.planning.plan import plan
from exoid.planning.planned import AtHand, Candidate
from exoid.planning.prior_knowledge import eliminated, from_result
from exoid.recordings.declared.subject import Subject
from exoid.report.tables.plan import as_good, in_one_row, print_plan
from exoid.twin.motion import Movement
from exoid.twin.protocols import record
from fit_cases import BODY, DROP, LOADED, leg, recorded

KEPT = 0.25  # relative, within which a promise counts as kept
SWING = "gravity_over_inertia"
LONG = Movement(np.radians(-12), 5.0)


def carried_out(proposed, seed):
    """The recordings that a plan asks for, one for each seat and load, of the true leg.

    The masses sit where the plan has them; nobody tells how far they reach.
    """
    each = []
    for seat in dict.fromkeys(option.seat for option in proposed):
        model = LegModel(leg(), NoTorque(), np.asarray(seat[0]))
        motions = [option.motion for option in proposed if option.seat == seat]
        made = record(model, motions, jax.random.key(seed), subject=BODY)
        subject = made.subject
        if subject.added_mass is not None:
            subject = replace(subject, added_mass_gyration=None)
        each.append((f"new {seat}", replace(made, subject=subject)))
    return each


@pytest.fixture(scope="module")
def bare():
    recording = recorded(LONG)
    return recording, fit(recording, multistart=2)


@pytest.mark.proof
@pytest.mark.parametrize("goal", ["inertia", "damping", "stiffness"])
def test_the_proposed_recording_reaches_the_promised_error(bare, goal):
    recording, result = bare
    found = plan(result, BODY, goal)
    assert found.proposed
    assert len({option.thigh_angle for option in found.proposed}) == 1
    joint = fit([("first", recording), *carried_out(found.proposed, 7)], multistart=2)
    reached = {**joint.parameters, **joint.ratios}[goal].standard_error
    assert reached == pytest.approx(found.after, rel=KEPT)
    before = {**result.parameters, **result.ratios}[goal].standard_error
    assert found.before == pytest.approx(before, rel=0.01)  # the same information
    assert found.after < found.before


@pytest.mark.proof
def test_a_first_session_reaches_what_is_promised_of_it():
    found = plan(None, BODY, "inertia")
    assert any(option.motion.added_mass for option in found.proposed)
    assert any(not option.motion.added_mass for option in found.proposed)
    result = fit(carried_out(found.proposed, 3), multistart=2)
    each = result.parameters["inertia"]
    # Promised for the leg that anatomy expects, made of another one.
    assert each.standard_error / each.value == pytest.approx(found.after / found.value, rel=KEPT)


@pytest.mark.proof
def test_mass_and_distance_are_refused_with_the_reason(bare):
    for goal in ("mass", "com_distance"):
        found = plan(bare[1], BODY, goal)
        assert found.after > 0.5 * found.before
        assert any("only the product m l" in sentence for sentence in found.sentences)


@pytest.mark.proof
def test_what_is_known_well_enough_needs_nothing_more():
    result = fit(
        recorded(LONG, replace(LONG, added_mass=1.0, added_mass_distance=0.4)), multistart=2
    )
    found = plan(result, BODY, "damping_over_inertia")
    assert found.proposed == []
    assert found.after == found.before
    assert any("already" in sentence for sentence in found.sentences)


def test_a_loaded_drop_is_first_where_only_bare_ones_were_recorded(bare):
    found = plan(bare[1], BODY, "inertia")
    assert found.options[0].candidate.motion.added_mass == 2.0
    errors = [option.error for option in found.options]
    assert errors == sorted(errors)
    assert found.after <= found.options[0].error * 1.3  # the simplest of the nearly best


def test_of_masses_that_tell_as_much_the_lightest_is_proposed(bare):
    """A mass is known in proportion, so that a lighter one tells J to nearly the same."""
    found = plan(bare[1], BODY, "inertia")
    loaded = [each.motion.added_mass for each in found.proposed if each.motion.added_mass]
    assert loaded[0] == 0.5
    assert found.after <= found.options[0].error * 1.05


def test_a_first_plan_lists_what_it_proposes_and_has_nothing_to_be_fitted_with():
    found = plan(None, BODY, "inertia")
    console = Console(width=80, file=StringIO())
    print_plan(found, console, first=True)
    steps, _, options = " ".join(console.file.getvalue().split()).partition("One segment more")
    assert all(each.words in options for each in found.proposed)
    assert "OLD" not in steps


def test_segments_that_are_as_good_to_two_digits_are_one_row_of_what_is_proposed_or_simplest():
    bare, loaded = (replace(DROP, added_mass=mass) for mass in (0.0, 1.0))
    tilted, simple = Candidate("tilted", bare, 0.3), Candidate("bare", bare)
    heavy, other = Candidate("heavy", loaded), Candidate("light", loaded)
    each = [(tilted, "0.042"), (heavy, "0.042"), (simple, "0.042"), (other, "0.043")]
    first, last = as_good(each).values()
    assert in_one_row(first) == "bare, or 2 others as good"
    assert in_one_row(first, [heavy]) == "heavy, or 2 others as good"
    assert in_one_row(first, [heavy, tilted]) == "tilted or heavy, or 1 other as good"
    assert in_one_row(last) == "light"


def test_what_the_next_recording_has_in_common_with_the_first_is_believed_of_both(bare):
    """As a fit of both believes it: W'W of all, less that of what is at hand."""
    _, result = bare
    known, drop = from_result(result), Candidate("again", LONG)
    rows = beliefs(known, [drop], [drop], [drop.seat])
    second = replace(known.movements[0], recording=1)
    both = in_common([*known.movements, second], known.owned)
    for number, name in enumerate(known.owned):
        if name in (*OF_THE_MASS, *OF_THE_LOAD):
            continue  # there is none
        (sd,) = known.mountings[name] / getattr(TYPICAL.mounting, name)
        row = rows[number, [number, len(known.owned) + number]] * sd
        np.testing.assert_allclose(row, getattr(both, name)[1], rtol=1e-12)
    shared = {name for number, name in enumerate(known.owned) if rows[number, number] < 0}
    assert shared == {"zero", "tilt", "gyro_scale", "clock"}  # a bias drifts; no mass was on it


def test_what_was_off_once_is_off_again(bare):
    """A next recording of another session tells more than one that shares its seat and sensors."""
    known = from_result(bare[1])
    apart = replace(known, movements=tuple(replace(e, session="x") for e in known.movements))
    drop = Candidate("again", replace(LONG, start_angle=np.radians(-40)))
    told = informations(known, moving([drop], known))
    elsewhere = [replace(each, session="y") for each in next_of(apart, [drop], [drop.seat])]
    goal = "gravity_over_inertia"
    together = Design(known, goal, told, AtHand(1.0)).error([drop])
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("exoid.planning.next_mountings.next_of", lambda *_: elsewhere)
        anew = Design(apart, goal, told, AtHand(1.0)).error([drop])
    assert anew < 0.9 * together


def test_a_plan_begins_with_the_error_that_the_fit_states_and_promises_no_less_than_stays(bare):
    """What a tilted seat may do to a ratio is in the fit's ±, and no drop on that seat tells it."""
    _, result = bare
    own, tilt = result.ratios[SWING], 2.0  # 1/s^2
    wide = replace(result, ratios=result.ratios | {SWING: own.widened(tilt, cause="tilt")})
    found = plan(wide, BODY, SWING)
    assert found.before == pytest.approx(wide.ratios[SWING].standard_error, rel=1e-9)
    assert found.stays == pytest.approx(tilt, rel=0.01)
    assert min(each.error for each in found.options) >= found.stays
    said = " ".join(found.sentences)
    assert "nothing more is needed" not in said
    assert "± 2 1/s^2 of its error is what no motion of this leg tells" in said
    assert "the seat's tilt" in said


def test_what_a_slack_spring_leaves_open_is_never_enough(bare):
    _, result = bare
    sure = replace(result.ratios[SWING], standard_error=0.01, if_slack=3.0)
    found = plan(replace(result, ratios=result.ratios | {SWING: sure}), BODY, SWING)
    assert found.if_slack == 3.0
    assert not any("nothing more is needed" in each for each in found.sentences)
    console = Console(width=80, file=StringIO())
    print_plan(found, console)
    assert "(± 3 more if slack)" in console.file.getvalue()


def test_a_number_that_the_fit_does_not_give_is_none_of_its_plan(bare):
    _, result = bare
    none = replace(result.parameters["inertia"], value=None, standard_error=None, reason="so")
    found = plan(replace(result, parameters=result.parameters | {"inertia": none}), BODY)
    assert found.before == np.inf
    assert found.after < np.inf
    assert "nothing tells J yet: so." in found.sentences


def test_nothing_is_planned_after_a_fit_that_does_not_follow(bare):
    lost = replace(bare[1], astray="it is elsewhere", notes=["It does not follow."])
    found = plan(lost, BODY)
    assert (found.proposed, found.options, found.before) == ([], [], np.inf)
    assert found.sentences == ["It does not follow."]
    console = Console(width=80, file=StringIO())
    print_plan(found, console)
    assert "J is not determined" in console.file.getvalue()


@pytest.mark.proof
def test_a_bare_drop_is_proposed_where_only_a_loaded_one_was_recorded():
    found = plan(fit(recorded(LOADED), multistart=2), BODY, "inertia")
    assert any(option.motion.added_mass == 0 for option in found.proposed)


@pytest.mark.proof
def test_voluntary_cycles_are_compared_but_never_proposed():
    cycle = Movement(np.radians(-6), 1.19, amplitude=-4.0)
    result = fit(recorded(DROP, cycle), multistart=2)
    for goal in quantity_names(0):
        found = plan(result, BODY, goal)
        assert any(option.candidate.voluntary for option in found.options)
        assert not any(option.voluntary for option in found.proposed)


@pytest.mark.proof
def test_nobody_in_particular_gets_a_plan_and_is_told_so():
    found = plan(None, Subject(kind="leg"), "damping")
    assert found.before == np.inf
    assert np.isfinite(found.after)
    assert any("--body-mass" in sentence for sentence in found.sentences)


def test_what_cannot_be_planned_is_refused():
    with pytest.raises(ValueError, match="it can be mass, inertia"):
        plan(None, BODY, "beauty")
    with pytest.raises(ValueError, match="rig"):
        plan(None, Subject(kind="rig"), "inertia")


def test_elimination_is_the_inverse_of_the_kept_covariance():
    factor = np.random.default_rng(0).normal(size=(9, 6))
    information = factor.T @ factor
    kept = np.linalg.inv(np.linalg.inv(information)[:2, :2])
    np.testing.assert_allclose(eliminated(information, 2), kept, rtol=1e-9)


@pytest.mark.proof
def test_one_short_drop_is_never_enough():
    """However well its sensors are known: six unknowns bend to what one movement shows."""
    short = recorded(Movement(np.radians(-70), 1.2), stiffness=1.4)
    sure = replace(
        short.sensors,
        angle_zero_uncertainty=0.0,
        gyro_scale_uncertainty=0.0,
        clock_uncertainty=0.0,
    )
    level = replace(short.protocol, thigh_angle_uncertainty=0.0)
    result = fit(replace(short, sensors=sure, protocol=level), multistart=2)
    goals = ("gravity_over_inertia", "stiffness_over_inertia", "damping_over_inertia")
    found = [plan(result, BODY, goal) for goal in goals]
    assert any(each.before < 2e-3 * each.value for each in found)  # and yet
    for each in found:
        assert each.proposed
        assert not any("nothing more" in sentence for sentence in each.sentences)
