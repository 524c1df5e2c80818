"""A gyro that renews itself 8.5 times a sample: how old its samples are drifts, for seconds."""

import numpy as np
from benchmarks.online import changes, world

import exoid
from exoid import online

RESONANT = 538  # of this session: the age drifts alike in every drop, by 0.5 ms in 4 s


def test_errors_allow_for_an_age_that_drifts_alike_in_every_drop(start):
    rng, leg, sensors = changes.draw(RESONANT)
    motion, free = world.session(rng, [leg] * changes.DROPS)
    samples = online.Sample(*world.measured(rng, motion, sensors))
    _, said = online.replay(start, samples)
    off = (said.ratios - [leg.gravity, leg.stiffness, leg.damping]) / said.errors
    assert said.drops[-1] == len(free)
    assert not (said.trust == online.Trust.UNEXPLAINED).any()
    # The errors are of an age that walks; one that drifts alike forty times is worse than that.
    assert np.abs(off[said.drops > 0]).max() < 4.0


def test_an_age_that_does_not_drift_costs_little(start):
    """That it may drift widens what a common drop tells, by a tenth."""
    rng, leg, sensors = changes.draw(1)
    motion, _ = world.session(rng, [leg] * 3)
    samples = online.Sample(*world.measured(rng, motion, sensors))
    steady = online.Model(node=online.Node(delay_drift=0.0))
    begun = online.init(exoid.expected_leg(77.0, 1.80), steady)
    _, said = online.replay(start, samples)
    _, surer = online.replay(begun, samples, steady)
    assert said.drops[-1] == surer.drops[-1] == 3
    assert (said.errors[-1] > surer.errors[-1]).all()
    assert (said.errors[-1] < 1.15 * surer.errors[-1]).all()
