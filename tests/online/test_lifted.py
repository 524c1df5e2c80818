"""A hand that lifts a swinging leg and lets it go again: what its last drop told stays told."""

import numpy as np
import pytest
from benchmarks.online import world

from exoid import online

LEG = world.Leg(26.0, 3.0, 0.85)
RUBBING = world.Leg(26.0, 3.0, 0.4, friction=1.5)
TICK = 0.01  # s
SHORT = 0.3  # s in which a leg that is held is not known to be at rest
STARTS = (-0.25, -0.35, -0.2)  # rad


def session(leg, holds, *, free=7.0):
    """Lifts from one drop to the next, the leg held for so long [s] before each and free behind it:
    samples, and when it was let go.
    """
    rng, parts, clock, released = np.random.default_rng(8), [held(-1.4, 1.5)], 1.5, []
    for start, hold in zip(STARTS, holds, strict=True):
        lifted = world.lift(parts[-1][0, -1], start, 1.2, TICK)
        before = [lifted, held(start, hold)]
        released.append(clock + TICK * sum(each.shape[1] for each in before))
        swing = world.swing(leg, start, np.arange(round(free / TICK)) * TICK, 0.02)
        parts += [*before, swing]
        clock = released[-1] + free
    time, angle, rate = world.measured(
        rng, np.concatenate(parts, axis=1), world.Sensors(0.0, 0.01, 0.0, 0.0)
    )
    return online.Sample(time, angle, rate), released


def held(angle, seconds):
    return np.stack([np.full(round(seconds / TICK), angle), *np.zeros((2, round(seconds / TICK)))])


@pytest.mark.parametrize("free", [2.5, 7.0])
def test_a_drop_stays_told_where_the_leg_is_lifted_and_soon_let_go_again(start, free):
    """Out of a large swing it was lifted beyond where it turned; a small one tells nothing new."""
    samples, _ = session(LEG, (1.0, SHORT, 1.0), free=free)
    _, said = online.replay(start, samples)
    assert online.Trust.UNEXPLAINED not in said.trust
    assert (np.diff(said.drops) >= 0).all()
    truth = np.array([LEG.gravity, LEG.stiffness, LEG.damping])
    assert (np.abs(said.ratios[-1] - truth) < 4 * said.errors[-1]).all()


@pytest.mark.parametrize("hold", [SHORT, 1.0])
def test_a_lift_from_rest_is_no_drop(start, hold):
    """How stiff a knee is nobody knows before, and a stiff one would lift the shank from there."""
    samples, released = session(LEG, (hold, 1.0, 1.0))
    _, said = online.replay(start, samples)
    assert online.Phase.MOVING not in said.phase[samples.time < released[0] - 0.05]
    assert online.Trust.UNEXPLAINED not in said.trust


@pytest.mark.parametrize("hold", [SHORT, 1.0])
def test_a_leg_that_rubs_is_told_whatever_lifts_it(start, hold):
    samples, _ = session(RUBBING, (1.0, hold, hold))
    _, said = online.replay(start, samples)
    assert said.trust[-1] == online.Trust.UNEXPLAINED
