"""That a tone moves the leg: no cause of the library is one, and beside it none is sought."""

from exoid.fitting.result.fit_result import FitResult
from exoid.fitting.result.remarks.noise_remarks import of_leg_tone, tone_of

WITHOUT_TONE = (
    "The same drops without the tone: a leg that is relaxed and warm, motors off, the frame on a "
    "firm floor. EMG tells a tremor or clonus from a motor or a frame."
)


def moved_by_tone(result: FitResult) -> list[str]:
    """Which tone moves the leg of a fit, and what that leaves unknown, in sentences; none where
    none does.
    """
    tone = tone_of(result.segments)
    if tone is None:
        return []
    said = of_leg_tone(tone, result.ratios, result.parameters["inertia"].value)
    return [said, "what else is missing beside it was not sought"]
