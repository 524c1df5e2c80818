"""Signs and zero of the sensors as a user tells them: exoid's convention is made of them here.

exoid's angle is 0 with the knee extended and the shank level, -pi/2 hanging, extension positive.
"""

from dataclasses import replace

import numpy as np

from exoid.files.text_file import Notes
from exoid.recordings.conventions.balance import balance
from exoid.recordings.conventions.counting import ANGLES, FLIPPED, RATES, counting
from exoid.recordings.landmarks.find_landmarks import find_landmarks
from exoid.recordings.landmarks.measure import NotAllowed
from exoid.recordings.landmarks.track import track_of
from exoid.recordings.measured.segment import Segment
from exoid.recordings.recording import Recording
from exoid.recordings.signal.both_sensors.clean import clean
from exoid.recordings.signal.condition import classify

RESTS = -1.33  # rad; where a relaxed leg hangs: its own stiffness holds it short of the plumb line
REST_SPREAD = 0.2  # rad, one standard deviation over people, from slack to spastic
SURE = 0.15  # rad, the error of a balance up to which it stands in for a rest


def turned(recording: Recording) -> tuple[Recording, Notes]:
    """The recording with the signs and the zero that its sensors are told to have.

    phi = s (reading - zero), s the sign. What is mended is no longer told; a zero that is
    `unknown` is left to `settled`, which needs the drops.
    """
    told = recording.sensors
    if told.angle_zero is not None and told.zero not in (None, "extended"):
        raise ValueError(
            f'zero = "{told.zero}" and angle_zero_rad are two answers to one question. Keep one.'
        )
    if told.flip is None and told.zero in (None, "extended") and told.angle_zero is None:
        return recording, ()
    turned = FLIPPED.get(told.flip or "", ())
    sign, shift = counting(told)
    if told.angle_zero is not None and recording.subject.kind != "rig":
        shift -= whole_turns(recording, sign, shift)
    segments = tuple(mended(each, turned, shift) for each in recording.segments)
    zero = None if told.zero == "hanging" else told.zero
    sensors = replace(told, flip=None, zero=zero, angle_zero=None)
    notes = [f"the sign of {named(turned)} is changed, as told."] if turned else []
    notes += [f"the angle is shifted by {np.degrees(shift):+.4g} deg, as told."] if shift else []
    return replace(recording, segments=segments, sensors=sensors), tuple(notes)


def whole_turns(recording: Recording, sign: float, shift: float) -> float:
    """By how many turns [rad] a leg is off, for its encoder's 0 and 360 deg are the same."""
    angles = np.concatenate([each.best_angle for each in recording.segments])
    return 2 * np.pi * round(float(np.nanmedian(sign * angles + shift)) / (2 * np.pi))


def named(fields: tuple[str, ...]) -> str:
    """The channels, in words."""
    words = {ANGLES: "the angle", RATES: "the angular velocity"}
    return words.get(fields, "angle, angular velocity and torque")


def settled(recording: Recording, drops: Recording) -> tuple[Recording, Notes]:
    """The recording with an unknown zero taken from where the leg hangs in its `drops`.

    A relaxed leg hangs at -76 deg, give or take 11 deg: its stiffness holds it short of the plumb
    line by an angle that nobody knows. That is the zero's uncertainty, with the drops' own
    scatter, unless a smaller one is declared.
    """
    if recording.sensors.zero != "unknown":
        return recording, ()
    rest, error = hanging(drops)
    shift = RESTS - rest
    spread = float(np.hypot(REST_SPREAD, error))
    declared = recording.sensors.angle_zero_uncertainty
    kept = spread if declared is None else declared
    sensors = replace(recording.sensors, zero=None, angle_zero_uncertainty=kept)
    segments = tuple(mended(each, (), shift) for each in recording.segments)
    note = (
        f"the zero of the angle is unknown: the leg hangs at {np.degrees(rest):.4g} deg, taken for "
        f"{np.degrees(RESTS):.3g} +- {np.degrees(kept):.2g} deg. Measure it to know more."
    )
    return replace(recording, segments=segments, sensors=sensors), (note,)


def hanging(drops: Recording) -> tuple[float, float]:
    """Where the leg hangs [rad, as the file counts], and the scatter of that over the drops."""
    each = [
        found
        for number, segment in enumerate(drops.segments)
        if (drops.kind(number) or classify(segment)) == "passive"
        and (found := rest_of(drops, segment)) is not None
    ]
    if not each:
        raise ValueError(
            "the zero is said to be unknown, and no drop shows where the leg hangs. Record one "
            "until the leg hangs still, or say angle_zero_deg in [sensors]."
        )
    return float(np.median(each)), float(np.std(each))


def rest_of(drops: Recording, segment: Segment) -> float | None:
    """Where one drop comes to rest, else what it swings about; None where neither is told."""
    try:
        found = find_landmarks(track_of(segment, clean(drops).angle.level))
        return found.rest.angle.value
    except NotAllowed:
        swung = balance(segment)
    return swung.angle if swung is not None and swung.angle_error < SURE else None


def mended(segment: Segment, turned: tuple[str, ...], shift: float) -> Segment:
    """The segment with some signs changed, then `shift` [rad] added to its angles."""
    channels = {n: -each if n in turned else each for n, each in segment.channels().items()}
    shifts = {n: channels[n] + shift for n in ANGLES if n in channels and shift}
    return replace(segment, **channels | shifts)
