"""A node whose clock is off tells of the same leg as one whose clock is right."""

from dataclasses import replace

import can
import jax
import jax.numpy as jnp
import numpy as np
import pytest

import exoid
from exoid.physics.leg import LegModel, LegParameters
from exoid.physics.torque import NoTorque
from exoid.recordings.filter import kalman
from exoid.recordings.recording import Segment
from exoid.twin import protocols
from exoid.twin.motion import Movement
from node_frames import frames

LEG = {"mass": 4.5, "inertia": 0.42, "com_distance": 0.26, "damping": 0.33, "stiffness": 2.6}
RATIOS = {"gravity_over_inertia": 4.5 * 0.26 * 9.81 / 0.42, "damping_over_inertia": 0.33 / 0.42}
SLOW = 1.02  # true seconds in one of the node's
LIKELY = 4.0  # standard errors


@pytest.fixture
def log(monkeypatch) -> Segment:
    """A drop in true time, sampled when the slow node's 10 ms are over, filtered as it filters."""
    monkeypatch.setattr(protocols, "TICK", 0.01 * SLOW)
    leg = LegModel(LegParameters(**{k: jnp.asarray(v) for k, v in LEG.items()}), NoTorque())
    drops = [Movement(float(np.radians(-12)), 4.0)]
    seen = protocols.session(leg, drops, jax.random.key(3)).segments[0]
    steps = np.full(seen.time.size - 1, 0.01)
    state = kalman.filter(steps, seen.raw_angle, seen.raw_angular_velocity).state
    angle, velocity, acceleration = np.asarray(state, float).T
    return replace(seen, angle=angle, angular_velocity=velocity, angular_acceleration=acceleration)


@pytest.mark.parametrize("left_out", [None, 0x102])
def test_a_leg_has_its_true_ratios_by_raw_and_by_filtered_channels(tmp_path, log, left_out):
    """m l g / J goes by the square of the clock: uncorrected it would be 4 % off."""
    path = tmp_path / "leg.blf"
    with can.BLFWriter(path) as writer:
        sent = frames(log, np.random.default_rng(0), epoch=1e9, jitter=1e-3, config_crc=0)
        for time, identifier, data in sent:
            if identifier != left_out:
                given = dict(arbitration_id=identifier, is_extended_id=False, data=data)
                writer.on_message_received(can.Message(timestamp=time, **given))
    loaded = exoid.load(path)
    assert loaded.quality is not None
    assert loaded.quality.skew_ppm == pytest.approx(1e6 / SLOW - 1e6, abs=1000)
    found = exoid.fit(loaded).ratios
    for name, true in RATIOS.items():
        assert abs(found[name].value - true) < LIKELY * found[name].standard_error, name
    error = found["gravity_over_inertia"].standard_error
    assert error < 0.01 * RATIOS["gravity_over_inertia"]  # 4 % off would be seen
