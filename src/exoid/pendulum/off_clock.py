"""What the errors of measures hold, where encoder and gyro disagree in scale.

A gyro shows (1 + s) times the angle's slope where its scale is off by s, or where the encoder's
gain makes angles 1 + s times too small, or all times are told a factor 1 + s too long: one of the
three. The rule is that of `fit`.
"""

from dataclasses import replace
from math import hypot

from exoid.recordings.landmarks.measure import Measure
from exoid.recordings.recording import Recording
from exoid.recordings.signal.both_sensors.disagreement import disagreement
from exoid.recordings.signal.both_sensors.sensor_scales import SCALED, suspected

POWERS = {"s": 1, "rad/s": -1, "rad/s^2": -2}  # of a second, by unit
OF_ANGLE = ("rad", "rad/s", "rad/s^2")  # units that go with the encoder's gain


def with_doubted_scales(
    measures: dict[str, Measure], recording: Recording
) -> tuple[dict[str, Measure], str | None]:
    """The measures, with errors that hold what of a disagreement may be the encoder's and, where
    the sidecar does not say how well it is known, the clock's, and what to say of it; None where
    the two agree.
    """
    scale = disagreement(recording)
    if scale is None or not scale.sure:
        return measures, None
    off = suspected(scale.value)
    loose = recording.sensors.clock_uncertainty is None
    held = {name: by_gain(each, off) for name, each in measures.items()}
    if loose:
        held = {name: by_clock(each, off) for name, each in held.items()}
    return held, of_scales(scale.value, loose=loose) if abs(scale.value) >= SCALED else None


def of_scales(apart: float, *, loose: bool) -> str:
    """By how much the two are apart, and whose it may be."""
    clock = ", or the rate of the clock" if loose else ""
    mend = ", and the clock with a true one and give clock_uncertainty" if loose else ""
    return (
        f"gyro and encoder disagree by {100 * apart:+.2g} % in scale: it is the gyro's, or the "
        f"encoder's gain{clock}, and no motion tells which. Nothing here is read off the gyro; ± "
        f"allows for the others: compare the encoder with a known angle{mend}"
    )


def by_gain(each: Measure, gain: float) -> Measure:
    """A measure whose error holds an encoder's gain that is off by a share of this standard
    deviation.
    """
    if each.unit not in OF_ANGLE or each.value is None or each.standard_error is None:
        return each
    return replace(each, standard_error=hypot(each.standard_error, gain * each.value))


def by_clock(each: Measure, clock: float) -> Measure:
    """A measure whose error holds a clock that is off by a share of this standard deviation."""
    power = POWERS.get(each.unit)
    if power is None or each.value is None or each.standard_error is None:
        return each
    return replace(each, standard_error=hypot(each.standard_error, power * clock * each.value))
