"""The process behind a residual, against processes that were put there and textbook matrices."""

from dataclasses import replace

import jax
import numpy as np
import pytest

from exoid.fitting.data.observation import Clock, Observation
from exoid.fitting.misfit.condensed import Sensed
from exoid.fitting.misfit.disturbance import explain as explaining
from exoid.fitting.misfit.disturbance.explain import explain
from exoid.fitting.misfit.disturbance.likelihood import Likelihood, restricted
from exoid.fitting.misfit.gram import CAUSES, UNIT, Cause, Grams
from exoid.fitting.misfit.gram_matrices import gram, hats, matern, nodes_of, pushes, triangles
from exoid.fitting.misfit.information import common, spoiled
from exoid.fitting.misfit.missed import Missed
from exoid.fitting.result.remarks.residual_remarks import of_missed
from exoid.physics.motion.step import Drive

SAMPLES, DURATION, NODES = 600, 6.0, 48
TIME = np.linspace(0.0, DURATION, SAMPLES)
TIMES = np.linspace(0.0, DURATION, NODES)  # of the nodes
WEIGHT = np.full((1, SAMPLES), 100.0)  # 1/rad
PLACE = np.arange(3)
NO_TORQUE = Drive(*[np.zeros((1, SAMPLES - 1))] * 3)
ONE = np.zeros(1)
SEEN = Observation(
    time=TIME[None],
    angle=0 * WEIGHT,
    angular_velocity=0 * WEIGHT,
    angle_weight=WEIGHT,
    velocity_weight=0 * WEIGHT,
    guide_angle=0 * WEIGHT,
    guide_velocity=0 * WEIGHT,
    cycle=NO_TORQUE,
    torque=NO_TORQUE,
    torque_reach=0 * ONE,
    added_mass=ONE,
    added_mass_distance=ONE,
    thigh_angle=ONE,
    added_mass_moves=ONE,
    added_mass_extent=0 * ONE,
    apart=0 * ONE,
    heavier=0 * ONE,
    damped=ONE,
    stiffened=ONE,
    owner=np.array([0]),
    clock=Clock(ONE, 0 * ONE, 0 * ONE, 0 * ONE),
)


def linear(residual, columns):
    """One segment with these sensitivities; a torque acts through an oscillator of 0.9 Hz."""
    effect = np.stack([swung(each) for each in hats(TIME, TIMES)])
    return Sensed(*(alone(each)[None] for each in (residual, columns, effect)))


def grammed(sensed, cause: Cause = "torque", *, seen=SEEN):
    one, of_one = (jax.tree.map(lambda leaf: leaf[0], each) for each in (sensed, seen))
    made = jax.tree.map(lambda leaf: leaf[None], triangles(one, of_one, TIMES))
    return gram(made, 0, cause, PLACE, TIMES)


def alone(angle):
    """With a velocity channel that was not measured."""
    return np.stack([angle, np.zeros_like(angle)], axis=-1)


def swung(torque):
    """The response of a lightly damped oscillator, in units of the noise."""
    rate, damping = 2 * np.pi * 0.9, 0.4
    response = np.exp(-damping * TIME) * np.sin(rate * TIME) / rate
    return 100 * np.convolve(torque, response)[:SAMPLES] * TIME[1]


def columns():
    """Slow oscillations, as the sensitivities of a leg are."""
    return 5 * np.stack([np.sin(5.6 * TIME), np.cos(5.6 * TIME), TIME * np.sin(5.6 * TIME)])


def process(rng, correlated, count=NODES):
    root = np.linalg.cholesky(
        matern(np.linspace(0, DURATION, count), correlated) + 1e-9 * np.eye(count)
    )
    return root @ rng.normal(size=count)


def explained(residual, a=None):
    sensed = linear(residual, columns() if a is None else a)
    each: Grams = {cause: grammed(sensed, cause) for cause in CAUSES}
    missed = explain([each], {"torque": 10.0, "encoder": 1.0}, SAMPLES, 3)
    return left(missed, [each[missed.cause or "torque"]])


def left(missed, each):
    """What it leaves of the information."""
    return spoiled(common(missed, ["passive"]), each, ["passive"] * len(each), 3)


def test_white_noise_is_called_white_and_widens_nothing():
    """The gain that is asked for keeps false calls below one in a hundred: none in forty here."""
    rng = np.random.default_rng(0)
    found = [explained(rng.normal(size=SAMPLES)) for _ in range(40)]
    assert [each.cause for each in found] == [None] * 40
    # 600 samples know their own size within 3 %; below 1 the sensors are taken at their word.
    assert all(1.0 <= each.noise < 1.1 for each in found)
    plain = columns() @ columns().T
    np.testing.assert_allclose(found[0].information * found[0].noise ** 2, plain, rtol=1e-9)


def test_a_process_that_hides_a_direction_but_for_rounding_is_never_the_likeliest():
    """What it leaves of two parameters is singular: nothing breaks, and other sizes win."""
    left = np.diag([1.0, 1.0, 4.0]), np.diag([1.0, 0.0, 4.0])  # of a small process and a large one

    class Beside:
        def beside_noise(self, ratios):
            return np.zeros((1, 2)), np.stack(left)[None]

    found = object.__new__(Likelihood)
    found.outside, found.processes, found.freedom = np.zeros((3, 3)), Beside(), 10
    small, large = found(np.array([1.0, 1e4]))
    assert np.isfinite(small)
    assert large == -np.inf


def test_white_noise_above_the_declared_widens_by_its_size():
    found = explained(2.5 * np.random.default_rng(1).normal(size=SAMPLES))
    assert found.cause is None
    assert found.noise == pytest.approx(2.5, rel=0.09)  # three sd of 600 samples
    np.testing.assert_allclose(found.widening, found.noise)


@pytest.mark.parametrize("correlated", [0.1, 0.4])
def test_a_missing_torque_is_found_with_its_size_and_its_correlation_time(correlated):
    """Over twenty draws: one says little of its size, and one in ten may look like the encoder."""
    rng, size = np.random.default_rng(2), 0.3
    shapes = hats(TIME, TIMES)
    found = [
        explained(rng.normal(size=SAMPLES) + swung(size * process(rng, correlated) @ shapes))
        for _ in range(20)
    ]
    assert [each.cause for each in found].count("torque") >= 17
    assert np.median([each.kinds["passive"].deviation for each in found]) == pytest.approx(
        size, rel=0.25
    )
    assert np.median([each.kinds["passive"].correlation_time for each in found]) == correlated


@pytest.mark.parametrize("size", [0.01, 0.03, 0.1])
def test_a_look_at_every_decade_misses_no_process_that_a_closer_one_finds(size, monkeypatch):
    """Of sizes about the least that is found: of some draws something, of others nothing."""
    rng, shapes = np.random.default_rng(9), hats(TIME, TIMES)
    residuals = [
        rng.normal(size=SAMPLES) + swung(size * process(rng, correlated) @ shapes)
        for correlated in (0.025, 0.1, 0.4, 0.8)
    ]
    found = [explained(each).kinds["passive"] for each in residuals]
    monkeypatch.setattr(explaining, "PROMISING", -np.inf)
    assert [explained(each).kinds["passive"] for each in residuals] == found


def test_a_slow_error_of_the_encoder_is_told_from_a_torque():
    """White errors of the nodes have no inertia: no torque leaves those."""
    rng = np.random.default_rng(3)
    shapes = hats(TIME, TIMES)
    found = [
        explained(rng.normal(size=SAMPLES) + 3.0 * rng.normal(size=NODES) @ shapes)
        for _ in range(20)
    ]
    assert [each.cause for each in found].count("encoder") >= 18
    # Three times the noise of 0.01 rad, between nodes that are linear.
    assert np.median([each.kinds["passive"].deviation for each in found]) == pytest.approx(
        0.03, rel=0.25
    )


def test_the_information_left_is_the_sandwich():
    """Of the same least squares under the same covariance, computed without any reduction."""
    rng = np.random.default_rng(4)
    shapes = hats(TIME, TIMES)
    found = explained(rng.normal(size=SAMPLES) + swung(0.3 * process(rng, 0.2) @ shapes))
    assert found.cause == "torque"
    missed = found.kinds["passive"]
    effect = np.stack([swung(each) for each in shapes])
    inside = matern(np.linspace(0, DURATION, NODES), missed.correlation_time)
    covariance = found.noise**2 * np.eye(SAMPLES) + missed.deviation**2 * effect.T @ inside @ effect
    a = columns().T
    inverse = np.linalg.inv(a.T @ a)
    scatter = inverse @ a.T @ covariance @ a @ inverse
    np.testing.assert_allclose(np.linalg.inv(found.information), scatter, rtol=1e-4)


def test_what_is_left_to_another_segment_is_the_sandwich_under_the_same_process():
    rng = np.random.default_rng(5)
    shapes = hats(TIME, TIMES)
    found = explained(rng.normal(size=SAMPLES) + swung(0.3 * process(rng, 0.2) @ shapes))
    other = linear(np.zeros(SAMPLES), 2 * columns())
    again = left(found.kinds["passive"], [grammed(other)])
    np.testing.assert_allclose(again.information, 4 * found.information, rtol=1e-6)
    np.testing.assert_allclose(again.widening, found.widening, rtol=1e-6)


def test_what_rounding_leaves_of_nothing_is_never_the_best():
    with np.errstate(all="raise"):
        sound, empty, broken = restricted(np.zeros(3), np.array([25.0, 0.0, -25.0]), 100)
    assert np.isfinite(sound)
    assert empty == broken == -np.inf


def hidden(order):
    """Sensitivities that torques make to one part in a million, and one that is their sum."""
    rng = np.random.default_rng(7)
    shapes = hats(TIME, TIMES)
    slow = np.stack([swung(process(rng, 0.4) @ shapes) for _ in range(2)])
    slow += 1e-6 * np.abs(slow).max() * rng.normal(size=slow.shape)
    sensed = linear(rng.normal(size=SAMPLES) + 100 * slow[0], np.stack([*slow, slow.sum(axis=0)]))
    return Sensed(*(each[:, ..., order, :] for each in jax.tree.leaves(sensed)))


def test_a_likelihood_is_that_of_the_textbook_where_the_process_hides_nearly_all():
    """log |V| + log |A'V^-1 A| + (n - 2) log r'Pr of the two that are independent, by the Cholesky
    factor of V. Its condition of 1e13 leaves three digits, and the differences are hundreds.
    """
    shapes = hats(TIME, TIMES)
    sensed = hidden(np.arange(SAMPLES))
    found = Likelihood([grammed(sensed)], 0.4, SAMPLES, 3)
    ratios = np.logspace(-3, 3, 4)
    expected = [textbook(sensed, shapes, ratio) for ratio in ratios]
    np.testing.assert_allclose(np.diff(found(ratios)), np.diff(expected), rtol=1e-3)


def textbook(sensed, shapes, ratio):
    effect = np.stack([swung(each) for each in shapes]).T
    inside = matern(np.linspace(0, DURATION, NODES), 0.4) + 1e-8 * np.eye(NODES)
    lower = np.linalg.cholesky(np.eye(SAMPLES) + ratio * effect @ inside @ effect.T)
    a, r = sensed.columns[0, :2, :, 0].T, sensed.residual[0, :, 0]
    rows = np.linalg.solve(lower, np.column_stack([a, r]))
    diagonal = np.abs(np.diag(np.linalg.qr(rows, mode="r")))
    return -(
        np.log(np.diag(lower)).sum()
        + np.log(diagonal[:2]).sum()
        + (SAMPLES - 2) * np.log(diagonal[2])
    )


def test_the_order_of_the_samples_does_not_move_a_likelihood():
    """Rounding is all that it changes, also where a process hides nearly all that is told."""
    rng = np.random.default_rng(8)
    ratios = np.logspace(-3, 6, 10)

    def likelihood(order):
        seen = replace(SEEN, time=TIME[None, order])
        return Likelihood([grammed(hidden(order), seen=seen)], 0.4, SAMPLES, 3)(ratios)

    plain = likelihood(np.arange(SAMPLES))
    for _ in range(5):
        np.testing.assert_allclose(likelihood(rng.permutation(SAMPLES)), plain, atol=1e-3)


def test_a_process_of_any_size_has_a_likelihood():
    """Also where white noise is less than its rounding, and it moves the leg in one way only."""
    gram = grammed(hidden(np.arange(SAMPLES)))
    one_way = replace(gram, effect=np.outer(gram.effect[0], gram.effect[0]))
    found = Likelihood([one_way], 0.4, SAMPLES, 3)
    assert np.isfinite(found(np.logspace(3, 24, 8))).all()


def test_a_direction_without_information_stays_without():
    a = columns()
    a[2] = 0.0
    found = explained(np.random.default_rng(6).normal(size=SAMPLES), a)
    assert np.all(found.information[2] == 0)
    assert found.widening.size == 2


def test_hats_add_up_to_one_and_pushes_are_their_stage_values():
    assert np.allclose(hats(TIME, TIMES).sum(axis=0), 1.0)
    (nodes,) = nodes_of([DURATION])
    drive, count = pushes(TIME, nodes), nodes.size
    assert drive.begin.shape == (count, SAMPLES - 1)
    assert np.array_equal(drive.end, hats(TIME[1:], nodes))
    assert np.allclose(drive.middle, (drive.begin + drive.end) / 2, atol=0.5 * TIME[1] * count / 6)


def test_the_matern_covariance_is_a_covariance_of_unit_variance():
    inside = matern(np.linspace(0, 3, 40), 0.3)
    assert np.allclose(np.diag(inside), 1.0)
    assert np.linalg.eigvalsh(inside).min() > -1e-12
    assert matern(np.array([0.0, 0.3]), 0.3)[0, 1] == pytest.approx(
        (1 + 5**0.5 + 5 / 3) * np.exp(-(5**0.5))
    )


@pytest.mark.parametrize(("part", "incomplete"), [(2e-4, False), (5e-3, True)])
def test_a_torque_that_matters_to_nobody_makes_no_error_bar_incomplete(part, incomplete):
    """Two ten-thousandths of m l g are 2 mN m of an adult, and five thousandths 0.05 N m."""
    found = Missed("torque", 0.1, (part * 27.0 / UNIT["torque"]) ** 2, 1.0, 0.0)
    (said,) = of_missed(found, "the residual", 27.0, 0.4, 1.0)
    assert ("no error bar of a model that misses something" in said) == incomplete
    assert "Errors are widened for it" in said
