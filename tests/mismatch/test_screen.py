"""Candidates pinned to the data, and running free."""

from dataclasses import replace

import jax
import jax.numpy as jnp
import numpy as np
import pytest
from diagnosis_cases import FRICTION, Detent, session

from exoid.fitting.estimate import fit
from exoid.mismatch import prepare as preparing
from exoid.mismatch.conclude.false_alarm import above, gains, gumbel, turned_over
from exoid.mismatch.prepare import prepare
from exoid.mismatch.screen import many_pinned
from exoid.mismatch.screen.along_motion import linear, nothing
from exoid.mismatch.screen.hypothesis import Hypothesis
from exoid.mismatch.screen.many_pinned import with_columns, with_errors
from exoid.mismatch.screen.optimise import polished, promising, settle, settle_free
from exoid.mismatch.search.variants import applies
from exoid.physics.leg import LegModel
from exoid.physics.motion.simulate import simulate
from exoid.physics.sensing.encoder_eccentricity import EncoderEccentricity
from exoid.physics.sensing.encoder_second_harmonic import EncoderSecondHarmonic
from exoid.physics.term import name_of
from exoid.physics.terms.device.coulomb_friction import CoulombFriction
from exoid.physics.terms.device.sticking_backlash import StickingBacklash
from exoid.physics.terms.tissue.maxwell_element import MaxwellElement
from exoid.physics.torque import NoTorque
from exoid.recordings.declared.protocol import Protocol
from exoid.recordings.measured.segment import Segment
from exoid.recordings.recording import Recording
from fit_cases import BODY, NOISE, leg, state
from small_library import SMALL


@pytest.fixture(scope="module")
def ready():
    """A prepared with a small library, on drops with dry friction."""
    patch = pytest.MonkeyPatch()
    patch.setattr(preparing, "library", lambda: SMALL)
    recordings = [("drops", session(FRICTION))]
    yield prepare(fit(recordings), recordings, (Detent,))
    patch.undo()


def candidates(prepared, base):
    point = base.candidate.point
    return [
        Hypothesis((term,), (value,), point)
        for term in prepared.library
        for value in prepared.starts(term)
    ]


def at_measured(prepared, *tried):
    """The products of candidates along what the sensors show."""
    motion = prepared.measured_motion
    return [each for each, _ in many_pinned.evaluate(prepared, [(one, motion) for one in tried])]


def test_the_true_term_reaches_the_noise_pinned_and_free(ready):
    prepared, base = ready
    samples = prepared.samples
    start = [each for each in candidates(prepared, base) if each.terms == (CoulombFriction,)]
    for found in (settle(prepared, start)[0], settle_free(prepared, start[0])):
        # The sum of squares of noise is its number within four deviations.
        assert abs(found.square - samples) < 4 * np.sqrt(2 * samples)
        # J is the prior's, and the friction goes with it.
        inertia = np.exp(prepared.coordinates(found.candidate).shared.log_inertia)
        assert found.candidate.values[0][0] / inertia == pytest.approx(0.08 / 0.42, rel=0.02)


def test_a_program_that_takes_fewer_candidates_finds_the_same(ready, monkeypatch):
    """What long segments make it take, so that its derivatives fit into memory."""
    prepared, base = ready
    tried = candidates(prepared, base)
    together = at_measured(prepared, *tried)
    lanes = many_pinned.at_once(prepared, many_pinned.FEW)
    monkeypatch.setattr(many_pinned, "PROGRAM", 1)
    assert many_pinned.at_once(prepared, many_pinned.FEW) == 1 < lanes
    for one, other in zip(together, at_measured(prepared, *tried), strict=True):
        # Sums of hundreds of squares, in another order.
        np.testing.assert_allclose(one.total, other.total, rtol=1e-9, atol=1e-9 * one.total.max())


def test_no_other_term_reaches_the_noise(ready):
    prepared, base = ready
    for found in settle(prepared, candidates(prepared, base)):
        if found.candidate.terms != (CoulombFriction,):
            assert found.square > 1.5 * prepared.samples, name_of(found.candidate.terms[0])


def test_pinned_and_free_agree_where_the_model_is_right(ready):
    prepared, base = ready
    start = [each for each in candidates(prepared, base) if each.terms == (CoulombFriction,)]
    free = settle_free(prepared, start[0])
    pinned = at_measured(prepared, free.candidate)[0]
    # Second order in the noise, but that a reversal is smeared over its step.
    assert pinned.square == pytest.approx(free.square, rel=0.3)
    # Of leg and friction; friction swallows a start's small velocity, whose derivative then is 0.
    told = [1, 2, 3, -2]
    assert np.diag(pinned.total)[told] == pytest.approx(np.diag(free.products.total)[told], rel=0.1)


def test_a_first_term_taken_as_linear_counts_like_itself(ready):
    prepared, base = ready
    by_name = {name_of(each.terms[0]): each for each in candidates(prepared, base)}
    first, second = by_name["coulomb_friction"], by_name["detent"]
    both = Hypothesis((*first.terms, *second.terms), (*first.values, *second.values), first.point)
    eased = linear(prepared, [(first, prepared.measured_motion)])[0]
    eased = Hypothesis(both.terms, both.values, both.point, both.zero, eased)
    one, other = (at_measured(prepared, each)[0] for each in (both, eased))
    assert other.each == pytest.approx(one.each, rel=1e-9, abs=1e-6)


def test_terms_taken_together_as_linear_count_like_themselves(ready):
    prepared, base = ready
    by_name = {name_of(each.terms[0]): each for each in candidates(prepared, base)}
    three = [by_name[name] for name in ("coulomb_friction", "detent", "maxwell_element")]
    terms, values = (sum((getattr(one, name) for one in three), ()) for name in ("terms", "values"))
    whole = Hypothesis(terms, values, base.candidate.point)
    two = Hypothesis(terms[:2], values[:2], base.candidate.point)
    eased = linear(prepared, [(two, prepared.measured_motion)])[0]
    eased = two.with_term(terms[2], values[2], eased)
    one, other = (at_measured(prepared, each)[0] for each in (whole, eased))
    assert other.each == pytest.approx(one.each, rel=1e-9, abs=1e-6)


def test_more_requests_than_fit_at_once_are_all_answered(ready):
    prepared, base = ready
    many = [each for each in candidates(prepared, base) if each.terms == (MaxwellElement,)] * 5
    squares = [products.square for products in at_measured(prepared, *many)]
    assert squares[:3] * 5 == pytest.approx(squares, rel=1e-12)


def test_what_falls_too_slowly_to_come_near_a_rival_is_given_up():
    rounds = np.arange(14)
    creeping, falling = ([1000.0 * share**k for k in rounds] for share in (0.99, 0.8))
    assert promising(creeping, rival=np.inf)
    assert promising(creeping, rival=900.0)  # it is near
    assert not promising(creeping, rival=1.0)
    assert promising(falling, rival=1.0)


def test_what_could_not_reach_a_rival_in_many_more_steps_rests_and_ends_no_lower_than_it(ready):
    prepared, base = ready
    start = base.candidate.at(1.05 * base.candidate.unknowns)
    whole = settle_free(prepared, start)
    for rival, sooner in ((np.inf, False), (whole.square, False), (0.1 * whole.square, True)):
        found = settle_free(prepared, start, rival=rival)
        assert whole.square <= found.square <= whole.square + max(0.0, whole.square - rival)
        assert (found.square > whole.square + 1e-3) is sooner


def test_a_step_into_a_bound_stays_on_it(ready):
    prepared, base = ready
    point = base.candidate.point
    found = settle(prepared, [Hypothesis((CoulombFriction,), (np.array([49.0]),), point)])[0]
    lower, upper = prepared.bounds(found.candidate)
    assert (found.candidate.unknowns >= lower).all()
    assert (found.candidate.unknowns <= upper).all()


def test_the_measured_motion_is_what_the_sensors_show(ready):
    prepared, _ = ready
    used = np.asarray(prepared.seen.angle_weight) > 0
    left = (prepared.measured_motion.angle - prepared.seen.angle)[
        used
    ] * prepared.seen.angle_weight[used]
    assert 0.5 < np.mean(np.square(left)) < 1.2
    assert jax.tree.leaves(prepared.measured_motion)[0].shape == prepared.seen.time.shape


def test_angles_that_no_data_hold_are_not_in_the_range(ready):
    prepared, _ = ready
    low, high = prepared.range
    first = prepared.sensors.references[0]
    beyond = first.angle.copy()
    beyond[:9] = low - 0.5 * np.arange(9, 0, -1)
    weights = [
        np.array(each) for each in (prepared.seen.angle_weight, prepared.seen.velocity_weight)
    ]
    for each in weights:
        each[0, :9] = 0.0
    seen = replace(prepared.seen, angle_weight=weights[0], velocity_weight=weights[1])
    references = [replace(first, angle=beyond), *prepared.sensors.references[1:]]
    late = replace(
        prepared,
        problem=replace(prepared.problem, observation=seen),
        sensors=replace(prepared.sensors, references=references),
    )
    assert late.range[0] == low
    assert late.range[1] <= high


def played(angle: float, seed: int) -> Segment:
    """A drop from its release on, as sensors with a play of 0.01 rad show it."""
    model = LegModel(leg(), NoTorque(), terms=(StickingBacklash(np.asarray(0.005)),))
    time = 0.01 * np.arange(600)
    seen = simulate(model, state(angle), jnp.asarray(time))
    rng = np.random.default_rng(seed)
    noise = rng.normal(size=(2, time.size)) * [[NOISE.angle_noise], [NOISE.velocity_noise]]
    return Segment(
        time,
        raw_angle=np.asarray(seen.shown_angle) + noise[0],
        raw_angular_velocity=np.asarray(seen.shown_velocity) + noise[1],
    )


@pytest.mark.proof
def test_the_encoder_leads_past_the_jumps_of_the_gyro():
    # A sample on the wrong side of a jump costs as much as the noise of hundreds.
    segments = tuple(played(angle, seed) for seed, angle in enumerate((-0.2, -0.5, -0.8)))
    recordings = [("drops", Recording(segments, BODY, Protocol(kind="passive"), NOISE))]
    prepared, base = prepare(fit(recordings), recordings, ())
    start = Hypothesis((StickingBacklash,), (np.array([0.002]),), base.candidate.point)
    walled = settle_free(prepared, start)
    found = polished(prepared, walled.candidate)
    assert found.candidate.values[0][0] == pytest.approx(0.005, rel=0.02)
    samples = prepared.samples
    assert abs(found.square - samples) < 4 * np.sqrt(2 * samples)
    assert walled.square > found.square + 100  # no noise makes such a difference


def test_chance_gains_as_many_squares_as_a_cause_has_parameters(ready):
    prepared, base = ready
    free = settle_free(prepared, Hypothesis((), (), base.candidate.point))
    each = [one for one in candidates(prepared, base) if one.terms == (CoulombFriction,)][:1]
    noise = np.random.default_rng(0).normal(size=(400, *free.motion.shape))
    for channel, name in enumerate(("angle_weight", "velocity_weight")):
        weight = np.asarray(getattr(prepared.seen, name))
        noise[..., channel] *= np.where(weight > 0, 1 / np.where(weight > 0, weight, 1.0), 0.0)
    motion = prepared.measured_motion
    (table,) = with_errors(prepared, [(each[0], motion)], noise)
    # Chi square with one degree of freedom: a mean of 1, its deviation the root of 2 over 400.
    assert np.mean(gains(prepared, each[0], table)) == pytest.approx(1.0, abs=4 * np.sqrt(2 / 400))


def test_what_the_sensors_may_show_beside_a_candidate_is_worth_what_its_program_says(ready):
    prepared, base = ready
    each = next(one for one in candidates(prepared, base) if one.terms == (CoulombFriction,))
    tried = each, prepared.measured_motion
    errors = np.random.default_rng(0).normal(size=(5, *prepared.seen.time.shape, 2))
    beside = replace(nothing(prepared, len(errors)), shown=errors)
    whole, size = with_columns(prepared, tried, beside), each.unknowns.size
    (table,) = with_errors(prepared, [tried], errors)
    expected = whole[:size, : size + len(errors)]
    np.testing.assert_allclose(table, expected, rtol=1e-9, atol=1e-12 * np.abs(expected).max())


def test_what_chance_may_do_is_that_of_the_largest_of_many():
    largest = np.random.default_rng(1).gumbel(-10.0, 2.0, size=20_000)
    law = gumbel(largest)
    assert above(0.0, *law) == pytest.approx(np.mean(largest > 0), abs=2e-3)
    assert above(100.0, *law) < 1e-20
    assert above(0.0, *gumbel(np.full(8, -1.0))) == 0.0


def test_blocks_are_turned_over_whole_and_nothing_else_is_changed(ready):
    prepared, base = ready
    drawn = turned_over(prepared, base, np.random.default_rng(0))
    data = np.stack([prepared.seen.angle, prepared.seen.angular_velocity], axis=-1)
    known = np.stack([prepared.seen.angle_weight, prepared.seen.velocity_weight], axis=-1) > 0
    left = np.where(known, data - base.motion, 0.0)
    np.testing.assert_allclose(np.abs(drawn), np.broadcast_to(np.abs(left), drawn.shape))
    signs = np.sign(drawn[:, 0][:, left[0, :, 0] != 0, 0] * left[0, left[0, :, 0] != 0, 0])
    assert (np.abs(np.diff(signs, axis=1)).sum(axis=1) < 2 * 8).all()  # few changes of sign
    assert len(np.unique(signs, axis=0)) > 4


@pytest.mark.parametrize(
    ("travel", "sought"),
    [
        (0.25, []),  # rad, of a linear axis: the second harmonic's period has 12 of them
        (0.40, [EncoderSecondHarmonic]),
        (0.70, [EncoderSecondHarmonic, EncoderEccentricity]),
    ],
)
def test_what_errs_once_or_twice_a_turn_is_sought_where_its_shape_shows(
    ready, monkeypatch, travel, sought
):
    monkeypatch.setitem(vars(ready[0]), "range", (0.1, 0.1 + travel))
    harmonics = [EncoderSecondHarmonic, EncoderEccentricity]
    assert [term for term in harmonics if applies(ready[0], term)] == sought
    assert applies(ready[0], CoulombFriction)
