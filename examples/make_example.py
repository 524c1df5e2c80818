"""Makes the recording that comes with exoid: one session of a leg that does not exist.

    python examples/make_example.py [FOLDER]

The leg is simulated: three passive drops, one with a known mass at the ankle, six voluntary cycles
driven by Eq. 10 with f = 1/T, at two speeds. Its sensors feed the firmware on an emulated
microcontroller, and `exoid record` takes what that sends, for as long as the session lasts. The
same seed gives the same samples; the host's time stamps are those of the day. It needs what
firmware/README.md names.
"""

import os
import subprocess
import sys
import tempfile
from dataclasses import replace
from pathlib import Path

import can
import jax
import jax.numpy as jnp
import numpy as np

import exoid
from exoid.physics.leg import LegModel, LegParameters
from exoid.physics.torque import NoTorque
from exoid.recordings.declared.protocol import Protocol
from exoid.recordings.declared.subject import Subject
from exoid.recordings.recording import Recording
from exoid.recordings.sidecar import read_sidecar, write_sidecar
from exoid.twin.motion import Movement
from exoid.twin.protocols import session

sys.path.append(str(Path(__file__).parents[1] / "tests" / "firmware"))
from emulated_node import emulated_node, samples_of

SIDECAR = "session.toml"
SEED = 20

LEG = {"mass": 4.5, "inertia": 0.42, "com_distance": 0.26, "damping": 0.33, "stiffness": 2.6}
SUBJECT = Subject(
    kind="leg", body_mass=74.0, height=1.78, notes="Simulated; nobody wore the exoskeleton."
)

DROPS = [(-12.0, 10.4), (-35.0, 9.6), (-22.0, 10.0)]  # start [deg], duration [s]: to rest
LOADED_DROP = (-18.0, 12.4)
LOAD = {"added_mass": 1.0, "added_mass_distance": 0.40}  # kg, m: a cuff at the ankle
# Start [deg], amplitude [N m], period [s]. With f = 1/T this leg comes back to rest at T only for
# periods near 1.2 s (a full swing with little help) and 1.35 s (a shallow one, held against
# gravity); in between and beyond it arrives at speed.
CYCLES = [
    (-6.0, -4.0, 1.19),
    (-9.0, -3.6, 1.18),
    (-4.0, -4.4, 1.20),
    (-2.0, -9.8, 1.32),
    (0.0, -10.0, 1.34),
    (-3.0, -10.2, 1.33),
]


def movements() -> list[Movement]:
    """The session in order."""
    drops = [Movement(np.radians(start), duration) for start, duration in DROPS]
    loaded = Movement(np.radians(LOADED_DROP[0]), LOADED_DROP[1], **LOAD)
    cycles = [Movement(np.radians(start), period, tau) for start, tau, period in CYCLES]
    return [*drops, loaded, *cycles]


def make() -> Recording:
    """The continuous log."""
    model = LegModel(LegParameters(**{k: jnp.array(v) for k, v in LEG.items()}), NoTorque())
    log = session(model, movements(), jax.random.key(SEED), subject=SUBJECT)
    return replace(log, protocol=as_noted(log.protocol))


def as_noted(protocol: Protocol) -> Protocol:
    """The marks as a user notes them: full hundredths of a second, each end just before the
    catch."""
    starts, ends = protocol.segment_start or (), protocol.segment_end or ()
    periods = [np.nan] * (len(DROPS) + 1) + [period for *_, period in CYCLES]
    return replace(
        protocol,
        cycle_period=tuple(periods),
        segment_start=tuple(round(time, 2) for time in starts),
        segment_end=tuple(round(time - 0.03, 2) for time in ends),
    )


def write(recording: Recording, folder: Path) -> None:
    """session.blf and, where there is none that says the same, session.toml in `folder`."""
    folder.mkdir(parents=True, exist_ok=True)
    log = recording.segments[0]
    with tempfile.TemporaryDirectory() as scratch, emulated_node(samples_of(log)) as channel:
        path = Path(scratch, "session.blf")
        lasting = f"{log.time[-1]:.2f}"
        command = ["exoid", "record", "--channel", channel, "-o", path, "--duration", lasting]
        environment = os.environ | {"CAN_CONFIG": '{"sleep_after_open": 0}'}
        subprocess.run(command, check=True, env=environment, stdin=subprocess.DEVNULL)
        # Recorded live, it is compressed second by second; as a whole it is half as large.
        with can.BLFReader(path) as sent, can.BLFWriter(folder / "session.blf") as packed:
            for message in sent:
                packed.on_message_received(message)
    tables, sidecar = (recording.subject, recording.protocol, recording.sensors), folder / SIDECAR
    if not says(sidecar, tables):  # one that says the same has comments that must not be lost
        write_sidecar(*tables, sidecar)


def says(sidecar: Path, tables: tuple) -> bool:
    """Does a sidecar hold just this? By its text: nan is not equal to nan."""
    return sidecar.exists() and repr(read_sidecar(sidecar)[:3]) == repr(tables)


if __name__ == "__main__":
    jax.config.update("jax_enable_x64", True)
    beside = Path(exoid.__file__).parent / "example"
    write(make(), Path(sys.argv[1]) if len(sys.argv) > 1 else beside)
