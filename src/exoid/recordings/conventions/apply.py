"""A recording as exoid counts: mended as its user tells, refused where something is wrong in it.

What a user got wrong is looked for here and nowhere else, so that every command says the same.
"""

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from exoid.files.text_file import Notes
from exoid.recordings.conventions.angle_convention import wrong_convention
from exoid.recordings.conventions.batched_times import unbatched
from exoid.recordings.conventions.file_clock import (
    from_first_sample,
    measured,
    unlike_rate,
    wrong_clock,
)
from exoid.recordings.conventions.gyro_agreement import dead_gyro, wrong_sign, wrong_unit
from exoid.recordings.conventions.left_out.angle_limit import without_clipped
from exoid.recordings.conventions.left_out.gyro_limit import without_saturated
from exoid.recordings.conventions.left_out.held_values import without_held
from exoid.recordings.conventions.left_out.interpolated import without_interpolated
from exoid.recordings.conventions.left_out.lost_samples import without_lost_samples
from exoid.recordings.conventions.left_out.lost_time import without_lost_time
from exoid.recordings.conventions.lowered import told_lowered, without_lowered
from exoid.recordings.conventions.mounting import settled, turned
from exoid.recordings.conventions.other_leg import another_leg
from exoid.recordings.conventions.thin import thinned
from exoid.recordings.declared.sensors import Sensors
from exoid.recordings.recording import Recording
from exoid.recordings.splitting.split import Split

TINY = np.pi * np.pi / 180  # rad, what an angle of pi becomes where radians were called degrees


def understand(
    recording: Recording,
    cut: Callable[[Recording], Split],
    *,
    whole: bool = False,
    flip: str | None = None,
    zero: str | None = None,
) -> tuple[Recording, Notes]:
    """The recording by exoid's convention, `cut` into its movements unless it stays `whole`.

    `cut` gives the movements, and what it noticed.

    `flip` and `zero` replace what the sidecar says. **Raises** `ValueError` with the likely cause
    and what mends it.
    """
    refuse(wrong_clock(recording))
    recording = from_first_sample(recording)
    recording, held = (recording, ()) if whole else without_held(recording)
    recording, drawn = (recording, ()) if whole else without_interpolated(recording)
    recording, batched = (recording, ()) if whole else unbatched(recording)
    recording = told(recording, flip, zero)
    sensors = recording.sensors
    recording, notes = turned(recording)
    refuse(tiny(recording) or dead_gyro(recording) or wrong_unit(recording))
    notes = (*unlike_rate(recording), *held, *drawn, *batched, *notes)
    if not whole:
        recording, clipped = without_clipped(recording)
        recording, lost = without_lost_samples(recording)
        recording, saturated = without_saturated(recording)
        recording, averaged = thinned(recording)
        notes = (*notes, *clipped, *lost, *saturated, *averaged)
    found = cut_up(recording, sensors, cut, whole=whole)
    if len(recording.segments) == 1 and recording.protocol.segment_start is None:
        found = without_lowered(found)
    movements = found.recording
    refuse(wrong_convention(movements, sensors, cut=movements is not recording or not whole))
    refuse(wrong_sign(recording, sensors.flip))
    movements, broken = (movements, ()) if whole else without_lost_time(movements)
    noticed = (
        () if whole else (*found.notes, *broken, *told_lowered(movements), *another_leg(movements))
    )
    recording, more = settled(recording if whole else movements, movements)
    return recording, (*notes, *more, *noticed)


def cut_up(
    recording: Recording, sensors: Sensors, cut: Callable[[Recording], Split], *, whole: bool
) -> Split:
    """Its movements. Where there are none, the angle may count so that none is seen, as it was
    turned by what `sensors` tell.
    """
    try:
        return cut(recording)
    except ValueError:
        refuse(wrong_convention(recording, sensors, cut=False))
        if whole:
            return Split(recording, ())
        raise


def told(recording: Recording, flip: str | None, zero: str | None) -> Recording:
    """With the signs and the zero of an option in place of the sidecar's."""
    sensors = recording.sensors
    if flip is not None:
        sensors = replace(sensors, flip=flip)
    if zero is not None:
        sensors = replace(sensors, zero=zero, angle_zero=None)
    return recording if sensors is recording.sensors else replace(recording, sensors=sensors)


def refuse(fault: str | None) -> None:
    if fault is not None:
        raise ValueError(fault)


def tiny(recording: Recording) -> str | None:
    """An angle of a leg that nowhere leaves 3 deg: radians that were called degrees."""
    if recording.subject.kind == "rig":
        return None
    angles = np.concatenate([measured(each)[1] for each in recording.segments])
    if np.abs(angles).max() > TINY or np.ptp(angles) < TINY / 20:
        return None
    high, low = np.degrees([angles.max(), angles.min()])
    return (
        f"the angle goes from {high:.2f} to {low:.2f} deg: no leg falls so little. Is it in "
        "radians? Then name its column _rad in place of _deg. Is it no angle, but volts? Then turn "
        "it to degrees by its calibration first."
    )
