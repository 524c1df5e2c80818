"""The blind cases are what their truth says."""

import json
from itertools import chain

import numpy as np
import pytest
from benchmarks.blind.cases import LEAST, MOST, draw_case
from benchmarks.blind.deck import ALIKE, Card, deal
from benchmarks.blind.effects import RECIPES, TERMS, Effect, of_legs
from benchmarks.blind.score import SETS
from scipy.integrate import cumulative_trapezoid, odeint
from scipy.optimize import least_squares

from exoid.physics.library import library
from exoid.physics.parameter import declarations
from exoid.physics.term import name_of

DECK = 59  # cards
COUNT = 2 * np.pi / 4096  # rad, of the encoder
FRICTION = Card("single", active=False, effects=("coulomb_friction",))
GYRO = Card("single", active=True, effects=("gyro_scale",))
NOTHING = Card("null", active=False)


@pytest.fixture(scope="module")
def friction():
    return draw_case(FRICTION, seed=3, number=0)


@pytest.fixture(scope="module")
def gyro():
    return draw_case(GYRO, seed=3, number=1)


@pytest.fixture(scope="module")
def nothing():
    return draw_case(NOTHING, seed=3, number=2)


def drop(time, start, gravity, stiffness, damping):
    """Eq. 9 of a drop, by another integrator."""

    def rate(state, _):
        pull = gravity * np.cos(state[0]) + stiffness * state[0] + damping * state[1]
        return [state[1], -pull]

    return odeint(rate, start, time, rtol=1e-10, atol=1e-10)[:, 0]


def best_baseline(case):
    """What the best baseline leaves of the encoder's readings, over the noise floor."""
    segments, leg = case.recording.segments, case.truth["baseline"]
    floor = case.truth["noise"]["floor_angle_rad"]
    ratios = np.array([leg["m"] * leg["l"] * 9.81, leg["c"], leg["d"]]) / leg["J"]

    def residual(unknowns):
        each = zip(segments, unknowns[3:].reshape(-1, 2), strict=True)
        left = [one.raw_angle - drop(one.time, start, *unknowns[:3]) for one, start in each]
        return np.concatenate(left) / floor

    starts = np.ravel([(one["phi0"], 0.0) for one in case.truth["segments"]])
    found = least_squares(residual, [*ratios, *starts], x_scale="jac", diff_step=1e-5)
    return np.sqrt(np.mean(found.fun**2))


@pytest.mark.parametrize("name", sorted(TERMS))
def test_every_term_can_be_drawn_within_its_range(name):
    recipe, term = RECIPES[name], TERMS[name]
    known = dict(declarations(term))
    given = recipe.sized | recipe.shape
    for field, bounds in given.items():
        sizes = (recipe.smallest, recipe.largest) if field in recipe.sized else (1.0,)
        signs = (-1.0, 1.0) if recipe.signed and field in recipe.sized else (1.0,)
        for size, end, sign in ((s, e, g) for s in sizes for e in bounds for g in signs):
            assert known[field].lower <= sign * size * end <= known[field].upper, field
    stops = {"extension_angle", "flexion_angle"} if name == "hard_stop" else set()
    assert set(given) | stops == set(known)


def test_a_size_scales_what_is_sized_and_nothing_else():
    effect = Effect(
        TERMS["stribeck_friction"], 0.1, 1.0, {"level": 1.0, "excess": 2.0}, {"speed": 0.3}
    )
    term = effect.at(0.4)
    assert (float(term.level), float(term.excess), float(term.speed)) == (0.4, 0.8, 0.3)


def test_a_deck_holds_every_term_of_a_leg_once():
    cards = list(deal(DECK, seed=1))
    singles = sorted(card.effects[0] for card in cards if card.category == "single")
    assert singles == sorted(name_of(term) for term in of_legs())


def test_what_muscles_do_is_concealed_in_voluntary_movements_only():
    voluntary = {name_of(term) for term in library() if term.voluntary}
    for card in chain(deal(DECK, seed=1), deal(DECK, seed=2)):
        assert card.active or not voluntary & set(card.effects)


def test_no_two_effects_of_a_set_are_alike():
    dealt = list(deal(4 * DECK, seed=1))
    sets = [set(card.effects) for card in dealt if card.category in SETS]
    assert len(sets) > DECK / 4
    assert {len(each) for each in sets} == {2, 3}
    assert not any(len(each & group) > 1 for each in sets for group in ALIKE)


def test_the_first_cards_of_a_seed_are_the_same_however_many_follow():
    assert list(deal(7, seed=5)) == list(deal(DECK + 3, seed=5))[:7]
    assert list(deal(7, seed=5)) != list(deal(7, seed=6))


def test_a_seed_gives_the_same_case_again(friction):
    again = draw_case(FRICTION, seed=3, number=0)
    assert again.truth == friction.truth
    for one, other in zip(again.recording.segments, friction.recording.segments, strict=True):
        np.testing.assert_array_equal(one.raw_angle, other.raw_angle)
        np.testing.assert_array_equal(one.raw_angular_velocity, other.raw_angular_velocity)


def test_as_much_is_left_of_an_effect_as_its_truth_says(friction):
    promised = friction.truth["residual_ratio"]
    assert LEAST <= promised <= MOST
    # 3 %: chance in the rms of 2000 noisy samples
    assert best_baseline(friction) == pytest.approx(promised, rel=0.03)


def test_nothing_is_left_where_nothing_is_concealed(nothing):
    truth = nothing.truth
    assert (truth["effects"], truth["params"], truth["detectable"]) == ([], {}, False)
    assert truth["residual_ratio"] == pytest.approx(1.0, abs=1e-4)
    assert best_baseline(nothing) == pytest.approx(1.0, rel=0.03)


def test_a_gyro_of_wrong_scale_shows_in_the_gyro_alone(gyro):
    scale = gyro.truth["params"]["gyro_scale"]["scale"]
    assert gyro.truth["residual_ratio"] == pytest.approx(1.0, abs=1e-4)
    for segment in gyro.recording.segments:
        turned = cumulative_trapezoid(segment.raw_angular_velocity, segment.time, initial=0.0)
        columns = [segment.raw_angle, segment.time, np.ones_like(segment.time)]  # with a bias
        found = np.linalg.lstsq(np.stack(columns, axis=1), turned)[0]
        # 0.005: noise of 1 mrad in a swing of 1 rad, and of the integral
        assert found[0] == pytest.approx(1 + scale, abs=0.005)


def test_a_segment_begins_with_the_release_and_is_read_by_12_bits_at_100_hz(friction):
    said = friction.truth["segments"]
    for segment, truth in zip(friction.recording.segments, said, strict=True):
        assert segment.time[0] == 0.0
        np.testing.assert_allclose(np.diff(segment.time), 0.01, atol=1e-9)
        assert segment.time[-1] == pytest.approx(truth["dur"], abs=1e-9)
        assert segment.raw_angle[0] == pytest.approx(truth["phi0"], abs=5e-3)
        counts = segment.raw_angle / COUNT
        np.testing.assert_allclose(counts, np.round(counts), atol=1e-6)


def test_a_cycle_lasts_its_own_period(gyro):
    periods = gyro.recording.protocol.cycle_period
    assert gyro.recording.protocol.torque_frequency in ("1/T", "2/T")
    for period, segment in zip(periods, gyro.recording.segments, strict=True):
        assert segment.time[-1] == pytest.approx(period, abs=1e-9)


def test_truth_has_the_form_of_the_concealed_set(friction, shared):
    truths = shared / "concealed" / "truth.json"
    if not truths.exists():
        pytest.skip(f"{truths} is absent")
    entry = json.loads(truths.read_text())[0]
    assert list(friction.truth) == list(entry)
    for name in ("baseline", "noise"):
        assert list(friction.truth[name]) == list(entry[name])
    assert list(friction.truth["segments"][0]) == list(entry["segments"][0])
    json.dumps(friction.truth)
