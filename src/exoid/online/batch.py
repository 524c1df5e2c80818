"""Finished drops by the batch fit."""

from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from exoid.online.belief import DEFAULT
from exoid.online.model.model import Model
from exoid.online.model.sample import Sample
from exoid.online.outlook import Outlook
from exoid.physics.sensing.sensor_skew import SensorSkew
from exoid.recordings.declared.protocol import Protocol
from exoid.recordings.declared.sensors import Sensors
from exoid.recordings.declared.subject import Subject
from exoid.recordings.measured.segment import Segment
from exoid.recordings.recording import Recording

if TYPE_CHECKING:
    from exoid.fitting.result.fit_result import FitResult

REST = 1.0  # s before a release that belong to its segment
STARTS = 8  # of a fit of drops that were understood already: most end at the same minimum


def drops_of(samples: Sample, outlooks: Outlook) -> tuple[Segment, ...]:
    """The free movements that counted, each with the rest before it, of samples and what was said
    after each of them.
    """
    ends = np.flatnonzero(np.diff(np.asarray(outlooks.drops)) == 1) + 1
    return tuple(segment_of(samples, outlooks.begun[at], outlooks.ended[at]) for at in ends)


def segment_of(samples: Sample, begun: float, ended: float) -> Segment:
    """The samples from the rest before `begun` to `ended` [s]; no rates where no gyro sent any."""
    time = np.asarray(samples.time)
    fresh = np.diff(time, prepend=-np.inf) > 0
    inside = fresh & (time >= begun - REST) & (time <= ended)
    rate = np.broadcast_to(samples.angular_velocity, time.shape)[inside]
    return Segment(
        time[inside] - time[inside][0],
        raw_angle=np.asarray(samples.angle)[inside],
        raw_angular_velocity=rate if np.isfinite(rate).any() else None,
        begins=float(time[inside][0]),
    )


def refine(
    drops: Sequence[Segment], subject: Subject, model: Model = DEFAULT, *, multistart: int = STARTS
) -> "FitResult":
    """The batch fit of finished drops, with the terms and sensors of the model, the gyro's delay
    among them.

    Takes seconds, and pickles both ways: run it in a process of its own beside the stream.
    """
    from exoid.fitting.estimate import fit  # which a live stream has no need of

    node = model.node
    recording = Recording(
        tuple(drops),
        subject,
        Protocol(kind="passive", thigh_angle=model.unknowns.thigh_angle or None),
        Sensors(
            angle_noise=node.angle_noise,
            velocity_noise=node.velocity_noise,
            angle_zero_uncertainty=node.zero,
            gyro_scale_uncertainty=node.scale,
            clock_uncertainty=node.clock if node.clock_declared else None,
        ),
    )
    turning = any(each.raw_angular_velocity is not None for each in drops)
    late = (SensorSkew,) if turning and node.delay_error > 0 else ()
    found = fit(recording, terms=(*model.unknowns.terms, *late), multistart=multistart)
    return replace(found, basis=None)
