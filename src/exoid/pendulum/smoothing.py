"""What the errors of measures do not hold: of an angle that was smoothed, of a sensor with play."""

from dataclasses import replace
from functools import lru_cache

import numpy as np

from exoid.recordings.landmarks.measure import Measure
from exoid.recordings.recording import Recording
from exoid.recordings.signal.both_sensors.clean import Cleaned
from exoid.recordings.signal.noise import Noise, of_hidden_noise
from exoid.recordings.signal.play_at_turns import play_at_turns


def as_smoothed(
    measures: dict[str, Measure], noise: Noise, recording: Recording
) -> tuple[dict[str, Measure], str | None]:
    """The measures, without errors where a filter has left a leg's angle no noise, and what to say
    of an angle that was smoothed; None of another one.
    """
    if noise.hidden and recording.subject.kind != "rig":
        bare = {name: replace(each, standard_error=None) for name, each in measures.items()}
        return bare, f"no ±: {of_hidden_noise(noise)}"
    if not noise.alike_over:
        return measures, None
    return measures, (
        f"the angle's errors are alike over {noise.alike_over:.2g} s, as of one that was smoothed: "
        "± holds the noise it had before, and not what a filter takes from peaks and releases"
    )


@lru_cache(maxsize=8)  # every segment of a recording asks for it
def of_play(cleaned: Cleaned) -> str | None:
    """How much there is between the leg and its sensor; None where none is seen."""
    if cleaned.velocity is not None:  # the gyro tells it, and it is taken out
        return None
    signals = [(each.time, each.best_angle) for each in cleaned.recording.segments]
    found = play_at_turns(signals, cleaned.angle.level)
    if found is None:
        return None
    return (
        f"the angle stands where the leg turns back, as behind {np.degrees(found):.1f} deg of play "
        "between leg and sensor: amplitudes are short by up to as much, and period and decrements "
        "farther off than ± tells. Tighten what couples the two"
    )
