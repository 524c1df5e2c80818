"""Segments made ready for the fit: channels chosen and cleaned, the extent found."""

import numpy as np

from exoid.fitting.data.fitted_samples import Clip, portion
from exoid.fitting.data.movement import Movement, weightless
from exoid.fitting.data.time_jitter import jitter_beside
from exoid.fitting.model.systematics import systematics
from exoid.recordings.filter.constants import UNTOLD
from exoid.recordings.measured.samples import Samples
from exoid.recordings.measured.segment import Segment
from exoid.recordings.recording import Recording
from exoid.recordings.signal.both_sensors.clean import clean
from exoid.recordings.signal.condition import SMOOTHING, classify, cut
from exoid.recordings.signal.local_line import local_line
from exoid.recordings.signal.turns import turns
from exoid.recordings.tables.sheet import listed

WHOLE = 0.5  # of its travel: by how much a whole cycle turns back
MOST_RETURNS = 3  # of a cycle, with what rings behind it
NAMED = 8  # times of cycles in a sentence
REVERSED = -0.5  # of the angle's own slope: below it a gyro turns the other way


def movement(
    recording: Recording, number: int, name: str, belongs: int = 0, *, clip: Clip = "free"
) -> Movement:
    """Condition one segment: choose its channels, clean them, find its extent and its clock.

    `belongs` counts the recordings that are fitted together. What a hand does while it lets go is
    NaN in `angle` and `angular_velocity`: it weighs nothing.

    **Raises** `Motionless` where nothing moves or too few samples are left, `ValueError` where a
    torque is missing, or where a voluntary movement is of many cycles.
    """
    cleaned = clean(recording)
    recording = cleaned.recording
    segment, said = recording.segments[number], recording.kind(number)
    kind = said or classify(segment) or "passive"
    if kind == "measured" and segment.applied_torque is None:
        raise ValueError(
            f"segment {name} is said to be measured, but has no torque_nm column. Name it, if it "
            'is called otherwise: columns={"torque_nm": NAME}.'
        )
    part = portion(recording, number, kind, clip, name)
    clipped = cut(segment, slice(part.start, part.stop))
    raw = clipped.raw_angle is not None
    angle = clipped.raw_angle if raw else clipped.angle
    velocity = clipped.raw_angular_velocity if raw else clipped.angular_velocity
    mass, distance = recording.added_mass(number), recording.added_mass_distance(number)
    assert angle is not None  # a Segment has one or the other
    check_sense(clipped, angle, velocity, name)
    if kind == "active":
        check_one_cycle(clipped, angle, name)
    noises = (cleaned.angle, cleaned.velocity) if raw else (None, None)
    whole = Movement(
        name=name,
        kind=kind,
        kind_said=said is not None,
        segment=clipped,
        angle=angle,
        angular_velocity=velocity,
        filtered=not raw,
        noise=cleaned.angle,
        gyro_noise=cleaned.velocity,
        onset=part.onset - float(segment.time[part.start]),
        period=part.period,
        added_mass=mass,
        added_mass_distance=np.nan if mass > 0 and distance is None else distance or 0.0,
        thigh_angle=recording.thigh_angle(number),
        recording=belongs,
        session=recording.subject.session,
        sensors=recording.sensors,
        extent=part.extent,
        systematics=systematics(recording, number),
        absent=recording.absent,
        gain_known=recording.protocol.torque_known is not False,
        filter=recording.sensors.filter or UNTOLD,
        filter_told=recording.sensors.filter is not None,
        filter_step=recording.sensors.filter_step,
        angle_jitter=jitter_beside(noises[0], recording, "raw_angle"),
        gyro_jitter=jitter_beside(noises[1], recording, "raw_angular_velocity"),
        rounds_alike=raw and recording.subject.kind != "rig",
    )
    return weightless(whole, np.arange(angle.size) < part.free - part.start)


def check_sense(segment: Segment, angle: Samples, velocity: Samples | None, name: str) -> None:
    """Refuse a gyro that turns the other way than the encoder."""
    if velocity is None:
        return
    slope, seen = local_line(segment.time, angle, SMOOTHING)[1], ~np.isnan(velocity)
    if np.sum(slope[seen] * velocity[seen]) < REVERSED * np.sum(slope[seen] ** 2):
        raise ValueError(
            f"segment {name}: the angular velocity is the angle's with the other sign. Extension "
            "is positive in both: change the sign of one of them."
        )


def check_one_cycle(segment: Segment, angle: Samples, name: str) -> None:
    """Refuse voluntary cycles behind one another as one: Eq. 10 is the torque of one of them."""
    known = ~np.isnan(angle)
    places = turns(angle[known], WHOLE)
    times = places.size // 2
    if times > MOST_RETURNS:
        back = segment.begins + segment.time[known][places[2::2]]
        raise ValueError(
            f"segment {name} goes to and fro {times} times: Eq. 10 is the torque of one cycle, "
            "which begins and ends at rest. Number the cycles in a column called segment. Times "
            f"[s] at which it is back: {listed([f'{each:.1f}' for each in back], NAMED)}. Where it "
            "does not rest there, record again with a pause behind each cycle, or mark each with a "
            'key. A leg that swings by itself is kind = "passive".'
        )
