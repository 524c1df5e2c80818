"""The node learns of a few drops, sample by sample, what the batch fit finds in all of them."""

import jax
import numpy as np
import pytest
from learner_runs import Ticks, told_by_numpy
from simulated_legs import FINER, GYRO_STEP, TICK, Legs, caught, held, joined, moved

import exoid
from exoid.recordings.declared.protocol import Protocol
from exoid.recordings.declared.sensors import Sensors
from exoid.recordings.declared.subject import Subject
from exoid.recordings.measured.segment import Segment
from exoid.recordings.recording import Recording

LEGS = 3
STARTS = (-0.3, 0.0)  # rad
LASTING = 4.0  # s
OF_FIT = ("gravity_over_inertia", "stiffness_over_inertia", "damping_over_inertia")
LIKELY = 4.0  # standard errors of both, within which they agree but for one draw in 15 000


@pytest.fixture(scope="module")
def legs():
    """Of adults, without zero and torque, which a fit does not look for."""
    none = np.zeros(LEGS)
    return Legs(
        gravity=np.array([25.0, 27.0, 29.0]),
        stiffness=np.array([5.0, 8.0, 12.0]),
        damping=np.array([0.5, 0.8, 1.6]),
        torque=none,
        zero=none,
        bias=np.array([-0.05, 0.0, 0.05]),
        scale=none,
    )


@pytest.fixture(scope="module")
def seen(legs):
    """Counts of encoder and gyro, and which ticks are drops."""
    parts, drops, at = [], [], 0
    for start in STARTS:
        begin = np.full(LEGS, start)
        if parts:
            parts.append(moved(parts[-1][0][-1], begin, 1.5))
        parts.append(held(begin, 0.8))
        at = sum(len(part[0]) for part in parts)
        drop = legs.drop(begin, LASTING)
        drops.append(slice(at, at + len(drop[0])))
        parts += [drop, caught(drop, 1.0)]
    return *legs.sensed(joined(*parts), np.random.default_rng(5)), drops


def recording_of(count, gyro, drops) -> Recording:
    segments = [
        Segment(
            np.arange(len(count[drop]), dtype=float) * TICK,
            raw_angle=(count[drop] - 32768) / FINER * (2 * np.pi / 4096),
            raw_angular_velocity=gyro[drop] * GYRO_STEP,
        )
        for drop in drops
    ]
    return Recording(
        tuple(segments),
        Subject(kind="leg", body_mass=77.0, height=1.80),
        Protocol(kind="passive"),
        Sensors(encoder_counts=4096.0, gyro_range=2000.0, sample_rate=100.0),
    )


@pytest.mark.slow
@pytest.mark.parametrize("leg", range(LEGS))
def test_node_and_fit_agree_about_the_same_samples(legs, seen, leg):
    count, gyro, drops = (seen[0][:, leg], seen[1][:, leg], seen[2])
    told = told_by_numpy(Ticks.sound(count[:, None], gyro[:, None]))[-1, 0]
    assert told["drops"] == len(STARTS)
    with jax.enable_x64(True):
        fitted = exoid.fit(recording_of(count, gyro, drops), multistart=8).ratios
    for k, name in enumerate(OF_FIT):
        value, error = fitted[name].value, fitted[name].standard_error
        assert error is not None
        print(f"{name}: {told['ratio'][k]:.4f} ± {told['error'][k]:.4f}, {value:.4f} ± {error:.4f}")
        assert abs(told["ratio"][k] - value) < LIKELY * np.hypot(told["error"][k], error)
        assert abs(value - legs.ratios[k, leg]) < LIKELY * error
