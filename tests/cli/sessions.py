"""Sessions on the virtual exoskeleton, and their CAN logs. All drops share one compiled program."""

from pathlib import Path

import can
import jax
import jax.numpy as jnp
import numpy as np

from exoid.physics.leg import LegModel, LegParameters
from exoid.physics.torque import NoTorque
from exoid.recordings.declared.subject import Subject
from exoid.recordings.recording import Recording
from exoid.recordings.sidecar import write_sidecar
from exoid.twin.motion import Movement
from exoid.twin.protocols import session as perform
from node_frames import frames

LEG = {"mass": 4.5, "inertia": 0.42, "com_distance": 0.26, "damping": 0.33, "stiffness": 2.6}
SUBJECT = Subject(kind="leg", body_mass=74.0, height=1.78)
RATIOS = {
    "gravity_over_inertia": 4.5 * 0.26 * 9.81 / 0.42,
    "stiffness_over_inertia": 2.6 / 0.42,
    "damping_over_inertia": 0.33 / 0.42,
}
EPOCH = 1_750_000_000.0  # s, of the host's clock
DROP = Movement(float(np.radians(-12)), 2.0)
TWO_DROPS = (DROP, Movement(float(np.radians(-30)), 2.0))


def session(*movements: Movement) -> Recording:
    """The continuous log with its marks."""
    model = LegModel(LegParameters(**{k: jnp.asarray(v) for k, v in LEG.items()}), NoTorque())
    return perform(model, movements, jax.random.key(3), subject=SUBJECT)


def write_log(recording: Recording, path: Path) -> Path:
    """The log in the format of the suffix, by python-can, and its sidecar."""
    sent = frames(
        recording.segments[0], np.random.default_rng(3), epoch=EPOCH, jitter=3e-4, config_crc=0
    )
    return write_frames(sent, recording, path)


def write_frames(sent, recording: Recording, path: Path) -> Path:
    """These frames (time, identifier, data) as a log, and the recording's sidecar."""
    log = can.Logger(path)
    for time, identifier, data in sent:
        log(
            can.Message(
                timestamp=float(time), arbitration_id=identifier, is_extended_id=False, data=data
            )
        )
    log.stop()
    tables = (recording.subject, recording.protocol, recording.sensors)
    write_sidecar(*tables, path.with_suffix(".toml"))
    return path
