"""Cases for reports: one made up, one of a leg with dry friction, one of the bundled example."""

from dataclasses import replace
from pathlib import Path

import jax
import jax.numpy as jnp
import numpy as np
import pytest
from test_fit_json import fitted

from exoid.fitting.estimate import fit
from exoid.mismatch import prepare
from exoid.mismatch.missing_physics import diagnose
from exoid.physics.leg import LegModel
from exoid.physics.terms.device.coulomb_friction import CoulombFriction
from exoid.physics.torque import NoTorque
from exoid.planning.plan import plan
from exoid.recordings.can.quality import FrameCounts, LogQuality
from exoid.recordings.declared.protocol import Protocol
from exoid.recordings.declared.sensors import Sensors
from exoid.recordings.declared.subject import Subject
from exoid.recordings.loading.load import load
from exoid.recordings.measured.segment import Segment
from exoid.recordings.recording import Recording
from exoid.report.parts.case import Case, Source
from exoid.report.parts.origin import Origin
from exoid.trust.identify import identify
from exoid.twin.motion import Movement
from exoid.twin.protocols import record
from fit_cases import BODY, leg
from small_library import SMALL

EXAMPLE = Path(prepare.__file__).parents[1] / "example" / "session.blf"
DROPS = [Movement(float(np.radians(angle)), 2.4) for angle in (-10, -30, -45)]
ORIGIN = Origin(
    command="exoid report leg.csv",
    made="2024-05-01 12:00:00 +0200",
    settings={"seed": "0"},
    versions={"exoid": "0.1.0"},
    files={"leg.csv": "00ff"},
)
QUALITY = LogQuality("leg.blf", FrameCounts(read=9, used=7, duplicate=2), "host", samples=402)


def made_up(notes: str | None = None, name: str = "leg.csv") -> Case:
    """A drop and a cycle of which nothing was computed, as `exoid fit --report` would have it."""
    result = fitted()
    segments = tuple(
        Segment(each.time, raw_angle=each.angle, raw_angular_velocity=each.angular_velocity)
        for each in result.segments
    )
    recording = Recording(
        segments,
        Subject(kind="leg", body_mass=74.0, height=1.78, notes=notes),
        Protocol(kind=("passive", "active")),
        Sensors(gyro_range=2000.0),
    )
    return Case((Source(name, recording, ("no sidecar",), QUALITY),), result, ORIGIN)


def of_friction() -> Case:
    """A leg with dry friction, diagnosed with a small library."""
    return diagnosed("rubbing.csv", CoulombFriction(jnp.asarray(0.08)))


def of_nothing() -> Case:
    """A leg that lacks nothing, diagnosed with the same library."""
    return diagnosed("sound.csv")


def diagnosed(name: str, *terms) -> Case:
    """A leg with these terms."""
    model = LegModel(leg(), NoTorque(), terms=terms)
    recording = record(model, DROPS, jax.random.key(0), subject=BODY)
    with pytest.MonkeyPatch.context() as patched:
        patched.setattr(prepare, "library", lambda: SMALL)
        found = diagnose([(name, recording)])
    told, next_one = identify(found.fit), plan(found.fit, recording.subject, "inertia")
    return Case((Source(name, recording),), found.fit, ORIGIN, told, found, next_one)


def of_example() -> Case:
    """The bundled session, fitted from a few starts."""
    loaded = load(EXAMPLE)
    result = fit([(EXAMPLE.name, loaded.recording)], multistart=8)
    source = Source(EXAMPLE.name, loaded.recording, loaded.notes, loaded.quality)
    return Case((source,), result, ORIGIN, identify(result))


def of_length(case: Case, samples: int, segments: int) -> Case:
    """The same with so many long segments."""
    each = case.fit.segments[0]
    time = np.linspace(0.0, 60.0, samples)
    stretched = {
        name: np.interp(time / 30, each.time, getattr(each, name))
        for name in ("angle", "angular_velocity", "simulated_angle", "simulated_velocity")
    }
    long = [replace(each, name=str(k), time=time, **stretched) for k in range(segments)]
    one = Segment(time, raw_angle=stretched["angle"])
    recording = Recording((one,) * segments, case.sources[0].recording.subject)
    source = replace(case.sources[0], recording=recording)
    return replace(case, sources=(source,), fit=replace(case.fit, segments=long))
