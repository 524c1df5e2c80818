"""What the samples tell of play and of times, without any model."""

from exoid.fitting.result.remarks.noise_remarks import of_play, times_off
from exoid.mismatch.answer.diagnosis import Diagnosis


def of_plays(found: Diagnosis) -> str:
    """The play between leg and encoder, of every recording that has some."""
    movements = found.before.basis.problem.movements if found.before.basis else []
    plays = dict.fromkeys(each.noise.play for each in movements if each.noise.play is not None)
    return " ".join(f"{said[0].upper()}{said[1:]}" for said in map(of_play, plays))


def of_times(found: Diagnosis) -> str:
    """How far times are off, each by its own; nothing where noise does not grow with speed."""
    movements = found.before.basis.problem.movements if found.before.basis else []
    off = next(filter(None, map(times_off, movements)), "")
    return (
        f"Times are off by {off} (one standard deviation): faster samples count less."
        if off
        else ""
    )
