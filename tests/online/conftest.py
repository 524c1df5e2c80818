"""Sessions of simulated legs, by the world of the benchmark, which shares nothing with exoid."""

import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import exoid
from exoid import online

sys.path.append(str(Path(__file__).parents[2]))

from benchmarks.online import world


@pytest.fixture(scope="session")
def start():
    """What is believed of an adult before anything moved."""
    return online.init(exoid.expected_leg(77.0, 1.80))


@pytest.fixture(scope="session")
def sure():
    """A model of a node whose seat and clock are declared: errors hold nothing but the drops."""
    return online.Model(node=online.Node(slant=0.0, clock_declared=True))


@pytest.fixture(scope="session")
def play():
    """Samples of drops of legs, one each, and the first of the legs on its seat."""

    def played(seed: int, count: int = 1, legs=None, **options):
        rng = np.random.default_rng(seed)
        sensors = world.draw_sensors(rng)
        leg = replace(world.draw_leg(rng, **options), tilt=sensors.tilt)
        drops = [leg] * count if legs is None else legs(leg)
        motion, free = world.session(rng, drops)
        return online.Sample(*world.measured(rng, motion, sensors)), leg, free

    return played


@pytest.fixture(scope="session")
def three(play, start):
    """Three drops of a leg, and what was said of them."""
    samples, leg, free = play(3, 3)
    belief, said = online.replay(start, samples)
    return samples, leg, free, belief, said


def part(samples: online.Sample, chosen) -> online.Sample:
    """Some of the samples."""
    return online.Sample(
        samples.time[chosen], samples.angle[chosen], samples.angular_velocity[chosen]
    )
