"""What the errors of measures in seconds hold, where encoder and gyro disagree in scale.

A gyro shows (1 + s) times the angle's slope where its scale is off by s, or the encoder's gain, or
where all times are told a factor 1 + s too long. The rule is that of `fit`.
"""

from dataclasses import replace
from math import hypot

from exoid.recordings.landmarks.measure import Measure
from exoid.recordings.recording import Recording
from exoid.recordings.signal.both_sensors.disagreement import disagreement
from exoid.recordings.signal.both_sensors.sensor_scales import SCALED, suspected

POWERS = {"s": 1, "rad/s": -1, "rad/s^2": -2}  # of a second, by unit


def with_doubted_clock(
    measures: dict[str, Measure], recording: Recording
) -> tuple[dict[str, Measure], str | None]:
    """The measures, with errors that hold what of a disagreement may be the clock's, and what to
    say of it; None where the two agree, and where the sidecar says how well the clock is known.
    """
    if recording.sensors.clock_uncertainty is not None:
        return measures, None
    scale = disagreement(recording)
    if scale is None or not scale.sure:
        return measures, None
    clock = suspected(scale.value)
    held = {name: by_clock(each, clock) for name, each in measures.items()}
    if abs(scale.value) < SCALED:
        return held, None
    return held, (
        f"gyro and encoder disagree by {100 * scale.value:+.2g} % in scale: it is the gyro's, or "
        "the encoder's gain, or the rate of the clock, and no motion tells which. Nothing here is "
        "read off the gyro; ± of times, velocities and accelerations allows for the clock: compare "
        "it with a true one and give clock_uncertainty"
    )


def by_clock(each: Measure, clock: float) -> Measure:
    """A measure whose error holds a clock that is off by a share of this standard deviation."""
    power = POWERS.get(each.unit)
    if power is None or each.value is None or each.standard_error is None:
        return each
    return replace(each, standard_error=hypot(each.standard_error, power * clock * each.value))
