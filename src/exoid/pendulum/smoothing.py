"""What a measure's error does not hold, where somebody has smoothed the angle."""

from dataclasses import replace

import numpy as np

from exoid.recordings.landmarks.measure import Measure
from exoid.recordings.recording import Recording
from exoid.recordings.signal.noise import Noise


def hides_noise(noise: Noise, recording: Recording) -> bool:
    """Has a filter left an angle of a leg without noise?"""
    return recording.subject.kind != "rig" and noise.hidden


def without_errors(measures: dict[str, Measure]) -> dict[str, Measure]:
    """The same, no error told."""
    return {name: replace(each, standard_error=None) for name, each in measures.items()}


def of_smoothing(noise: Noise, recording: Recording) -> str | None:
    """What to say of an angle that was smoothed; None of another one."""
    if hides_noise(noise, recording):
        return (
            f"no ±: the angle scatters by {np.degrees(noise.level):.1g} deg only, less than a "
            "sensor on a leg does. A filter hides noise, and takes from peaks and releases what it "
            "smooths: export the angle without one, or give angle_noise_rad in [sensors]"
        )
    if noise.alike_over:
        return (
            f"the angle's errors are alike over {noise.alike_over:.2g} s, as of one that was "
            "smoothed: ± holds the noise it had before, and not what a filter takes from peaks and "
            "releases"
        )
    return None
