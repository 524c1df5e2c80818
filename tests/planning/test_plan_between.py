"""Rivals told apart by a recording that a plan proposes, made and fitted with both."""

from dataclasses import replace

import jax
import jax.numpy as jnp
import numpy as np
import pytest

from exoid.fitting.estimate import fit
from exoid.physics.leg import LegModel
from exoid.physics.terms.device.coulomb_friction import CoulombFriction
from exoid.physics.terms.tissue.quadratic_drag import QuadraticDrag
from exoid.physics.torque import NoTorque
from exoid.planning.candidate_recordings import drops_of_rig, imagine
from exoid.planning.expected_odds import DECISIVE, RivalFit, probability, steps_to_limits
from exoid.planning.next_mountings import deviations_of_next
from exoid.planning.plan_between import check_let_go, plan_between
from exoid.planning.planned import Candidate
from exoid.planning.prior_knowledge import from_anatomy
from exoid.recordings.declared.subject import Subject
from exoid.twin.motion import Movement
from exoid.twin.protocols import record
from fit_cases import BODY, leg

RIVALS = (CoulombFriction, QuadraticDrag)
FRICTION = CoulombFriction(jnp.asarray(0.006))  # N m, too little for one short drop
SHORT = Candidate("a swing", Movement(np.radians(-60), 1.5))


def made(chosen: list[Candidate], seed: int):
    """The candidates of one seat, recorded of a leg with dry friction."""
    (tilt,) = {each.thigh_angle for each in chosen}
    model = LegModel(leg(), NoTorque(), np.asarray(tilt), (FRICTION,))
    return record(model, [each.motion for each in chosen], jax.random.key(seed), subject=BODY)


def advantage(*recordings) -> float:
    """By how much friction fits better than its rival, as log odds."""
    named = [(f"{number}", each) for number, each in enumerate(recordings)]
    right, wrong = (fit(named, terms=(term,), multistart=2) for term in RIVALS)
    return (wrong.loss - right.loss) / right.noise_scale**2


def following(misfit, room: np.ndarray, belief: np.ndarray) -> float:
    """Half of what is left of a misfit: least squares of everything at once."""
    rows = np.concatenate([room, np.linalg.cholesky(belief).T])
    left = np.concatenate([misfit, np.zeros(len(belief))])
    return 0.5 * float(np.sum((left - rows @ np.linalg.lstsq(rows, left)[0]) ** 2))


def test_log_odds_are_half_of_what_the_rival_cannot_follow():
    rival = from_anatomy(BODY)
    random, size, owned = np.random.default_rng(0), len(rival.information), len(rival.owned)
    rows = random.normal(size=(40, size + 1 + owned))
    rows[:, size] *= 0.1  # near enough that no limit is met
    option = Candidate("a drop", Movement(np.radians(-10), 6.0))
    found = RivalFit(rival, {option: rows.T @ rows})
    belief = np.zeros((size + owned, size + owned))
    belief[:size, :size] = found.start[:size, :size]
    deviations = list(deviations_of_next(rival, [option]).values())
    belief[size:, size:] = np.diag(np.power(deviations, -2.0))
    room = np.delete(rows, size, axis=1)
    expected = following(rows[:, size], room, belief)
    assert found.log_odds([option]) == pytest.approx(expected, rel=1e-6)
    tight = RivalFit(rival, {option: rows.T @ rows})
    tight.__dict__["room"] = np.zeros((2, size)) + np.array([[-1e-9], [1e-9]])
    # A rival that may not bend follows worse.
    assert tight.log_odds([option]) > found.log_odds([option])


def test_the_probability_is_that_of_odds_drawn_at_random():
    drawn = np.random.default_rng(0).normal(size=200_000)
    for mean in (0.5, 3.0, 8.0):
        reached = np.mean(mean + np.sqrt(2 * mean) * drawn > DECISIVE)
        assert probability(mean) == pytest.approx(reached, abs=0.005)  # of 200 000 draws: 4 sigma
    assert probability(0.0) == 0.0


@pytest.mark.proof
def test_the_proposed_recording_tells_the_rivals_apart():
    first = made([SHORT], seed=0)
    fits = [fit(first, terms=(term,), multistart=2) for term in RIVALS]
    found = plan_between(fits, BODY)
    before = -min(found.at_hand)
    assert before < DECISIVE  # one short swing does not tell
    assert found.probability > 0.5
    brought = advantage(first, made(found.proposed, seed=5)) - before
    assert brought > 0.5 * found.log_odds
    assert brought == pytest.approx(found.if_right[0], rel=0.5)  # made by another level
    last = [found.options[-1].candidate]
    assert brought > advantage(first, made(last, seed=5)) - before
    assert not any("does not follow" in each for each in found.sentences)
    lost = replace(fits[1], astray="it runs away")
    assert any("quadratic_drag the simulation does not" in each
               for each in plan_between([fits[0], lost], BODY).sentences)  # fmt: skip
    assert [each.log_odds for each in found.options] == sorted(
        (each.log_odds for each in found.options), reverse=True
    )


def test_what_cannot_be_told_apart_is_refused():
    with pytest.raises(ValueError, match="two or more models"):
        plan_between([], BODY)


def test_a_rig_that_has_no_limits_may_be_anything():
    lower, upper = steps_to_limits(from_anatomy(Subject(kind="rig")))
    assert (lower < 0).all()
    assert (upper > 0).all()


def test_a_rig_turns_where_no_knee_does():
    option = Candidate("let go at -250 deg", Movement(np.radians(-250), 2.0))
    made = imagine([option], 0.0, from_anatomy(Subject(kind="rig")))
    assert made.segments[0].raw_angle.min() < np.radians(-240)


def test_of_a_rig_that_a_motor_drives_no_drop_is_planned():
    rig = Subject(kind="rig")
    with pytest.raises(ValueError, match="coulomb_friction shows in constant speeds"):
        check_let_go(rig, ["measured", "measured"], RIVALS)
    check_let_go(rig, ["measured", "passive"], RIVALS)
    check_let_go(BODY, ["measured"], RIVALS)  # a leg can be let go


def test_a_rig_is_let_go_where_it_has_been():
    each = [one.motion for one in drops_of_rig(np.radians(-150), np.radians(-60))]
    assert np.degrees([each[0].start_angle, each[-1].start_angle]) == pytest.approx([-150, -60])
    assert len(each) > 3
    assert not any(one.added_mass for one in each)
