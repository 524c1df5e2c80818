"""What has another size in every segment is said to, and is no physics without a name."""

import re

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import exoid
from exoid.mismatch.conclude.verdict.segments.other_sizes import of_other_sizes
from exoid.mismatch.evidence.measure import yardstick
from exoid.mismatch.prepare import prepare
from exoid.mismatch.screen.optimise import settle_free
from exoid.mismatch.search.found import Found
from exoid.physics.terms.device.coulomb_friction import CoulombFriction

GRAVITY, STIFFNESS = 26.5, 5.0  # over J [1/s^2]
NOISE = np.radians([0.05, 0.15])  # rad, rad/s


def swinging(start: float, damping: float, friction: float, seed: int) -> exoid.Segment:
    """A drop from `start` [rad], by d / J [1/s] and F_c / J [1/s^2]."""

    def pull(_, state):
        angle, rate = state
        rubbing = friction * np.tanh(rate / 5e-3)
        return [rate, -GRAVITY * np.cos(angle) - STIFFNESS * angle - damping * rate - rubbing]

    time = np.arange(0.0, 4.0, 0.01)
    leg = solve_ivp(pull, (0.0, 4.0), [start, 0.0], "LSODA", time, rtol=1e-9, max_step=0.01)
    angle, rate = leg.y + NOISE[:, None] * np.random.default_rng(seed).normal(size=leg.y.shape)
    return exoid.Segment(time, raw_angle=angle, raw_angular_velocity=rate)


def searched(*drops: tuple[float, float, float]) -> Found:
    """What a search knows that tried dry friction alone."""
    segments = tuple(swinging(*drop, seed=seed) for seed, drop in enumerate(drops))
    named = [("drops", exoid.Recording(segments))]
    prepared, base = prepare(exoid.fit(named, multistart=2), named, ())
    rubbed = base.candidate.with_term(CoulombFriction, np.array([0.1]))
    singles = [settle_free(prepared, rubbed)]
    measure = yardstick(prepared, min(singles[0], base, key=lambda one: one.square))
    return Found(prepared, base, base.candidate, singles, [], [], [], measure)


@pytest.mark.parametrize(
    ("drops", "called", "sizes"),
    [
        ([(-0.3, 0.6, 0.0), (-0.5, 0.9, 0.0), (-0.2, 0.7, 0.0)], "d / J", (0.6, 0.9, 0.7)),
        (
            [(-0.3, 0.2, 0.5), (-0.5, 0.2, 0.3), (-0.2, 0.2, 0.4)],
            "coulomb friction: level / J",
            (0.5, 0.3, 0.4),
        ),
    ],
)
def test_what_differs_between_segments_is_told_in_each(drops, called, sizes):
    found = searched(*drops)
    (said,), (then,) = of_other_sizes(found, found.base)
    one = re.search(rf"{re.escape(called)} ([0-9., ]+) 1/s", said)
    assert one is not None, said
    told = [float(value) for value in one[1].split(",")]
    assert told == pytest.approx(sizes, rel=0.03)  # noise of four seconds each
    assert "m l g / J" not in said  # which is the same in all
    assert then.startswith("Every segment by itself")


def test_what_is_alike_in_all_is_none():
    found = searched((-0.3, 0.2, 0.4), (-0.5, 0.2, 0.4), (-0.2, 0.2, 0.4))
    assert of_other_sizes(found, found.base) == ([], [])
    assert of_other_sizes(found, found.singles[0]) == ([], [])
