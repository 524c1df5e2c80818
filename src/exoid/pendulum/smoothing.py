"""What the errors of measures do not hold, where somebody has smoothed the angle."""

from dataclasses import replace

from exoid.recordings.landmarks.measure import Measure
from exoid.recordings.recording import Recording
from exoid.recordings.signal.noise import Noise, of_hidden_noise


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
