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
from exoid.recordings.can.node.config_crc import EARLIER, config_crc
from exoid.recordings.filter import kalman
from exoid.recordings.filter.constants import DESIGNS, UNTOLD, Design
from exoid.recordings.measured.segment import Segment
from exoid.twin import protocols
from exoid.twin.motion import Movement
from exoid.twin.sensors import AS_BUILT
from node_frames import frames

LEG = {"mass": 4.5, "inertia": 0.42, "com_distance": 0.26, "damping": 0.33, "stiffness": 2.6}
RATIOS = {"gravity_over_inertia": 4.5 * 0.26 * 9.81 / 0.42, "damping_over_inertia": 0.33 / 0.42}
SLOW = 1.02  # true seconds in one of the node's
LIKELY = 4.0  # standard errors
RAW = 0x102  # EXO_RAW


@pytest.fixture
def seen(monkeypatch) -> Segment:
    """A drop in true time, sampled when the slow node's 10 ms are over, by sensors as they are."""
    monkeypatch.setattr(protocols, "TICK", 0.01 * SLOW)
    leg = LegModel(LegParameters(**{k: jnp.asarray(v) for k, v in LEG.items()}), NoTorque())
    drops = [Movement(float(np.radians(-12)), 4.0)]
    return protocols.session(leg, drops, jax.random.key(3), kit=AS_BUILT).segments[0]


def filtered(seen: Segment, design: Design) -> Segment:
    """What the node's filter makes of its readings, by its own clock."""
    assert seen.raw_angle is not None
    assert seen.raw_angular_velocity is not None
    steps = np.full(seen.time.size - 1, 0.01)
    state = kalman.filter(steps, seen.raw_angle, seen.raw_angular_velocity, design).state
    angle, velocity, acceleration = np.asarray(state, float).T
    return replace(seen, angle=angle, angular_velocity=velocity, angular_acceleration=acceleration)


@pytest.mark.parametrize(
    ("left_out", "told", "filter"),
    [
        (None, config_crc(), "4 states"),
        (RAW, config_crc(), "4 states"),
        (RAW, min(EARLIER), "3 states"),
        (RAW, 0, None),  # taken for the one of three states, and said
    ],
)
def test_a_leg_has_its_true_ratios_by_raw_and_by_filtered_channels(
    tmp_path, seen, left_out, told, filter
):
    """m l g / J goes by the square of the clock: uncorrected it would be 4 % off."""
    log, path = filtered(seen, DESIGNS[filter or UNTOLD]), tmp_path / "leg.blf"
    with can.BLFWriter(path) as writer:
        sent = frames(log, np.random.default_rng(0), epoch=1e9, jitter=1e-3, config_crc=told)
        for time, identifier, data in sent:
            if identifier != left_out:
                given = dict(arbitration_id=identifier, is_extended_id=False, data=data)
                writer.on_message_received(can.Message(timestamp=time, **given))
    loaded = exoid.load(path)
    assert loaded.quality is not None
    assert loaded.quality.skew_ppm == pytest.approx(1e6 / SLOW - 1e6, abs=1000)
    assert loaded.recording.sensors.filter == filter
    found = exoid.fit(loaded)
    assert any("which filter" in note for note in found.notes) == (filter is None)
    for name, true in RATIOS.items():
        ratio = found.ratios[name]
        assert abs(ratio.value - true) < LIKELY * ratio.standard_error, name
    error = found.ratios["gravity_over_inertia"].standard_error
    assert error < 0.01 * RATIOS["gravity_over_inertia"]  # 4 % off would be seen
