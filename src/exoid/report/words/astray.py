"""That a simulation does not follow its recording, in words."""

from exoid.fitting.result.fit_result import FitResult
from exoid.fitting.result.remarks.remarks import ASK_DIAGNOSE
from exoid.report.words.text import capital

WARNING = "This fit does not follow its recording: do not use its numbers."


def astray(result: FitResult, diagnosed: bool = False) -> str:
    """Why, and what to do; where it was `diagnosed`, without the advice to do that."""
    note = capital(result.notes[0])
    return note.replace(ASK_DIAGNOSE, "") if diagnosed else note
