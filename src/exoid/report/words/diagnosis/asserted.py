"""What an answer asserts, and what it does not."""

from exoid.mismatch.answer.diagnosis import Diagnosis, Tested
from exoid.report.words.diagnosis.usual import only_usual


def only_sensors(found: Diagnosis) -> bool:
    """Is all that was found what encoder and gyro show of each other, and the fit estimates?"""
    return found.verdict == "mismatch" and not found.changed and not found.novel


def is_chosen(one: Tested, found: Diagnosis) -> bool:
    """Is it the cause that the answer names? Where the answer is that nobody can tell, none is."""
    return one.chosen and found.verdict == "mismatch"


def parted(found: Diagnosis) -> bool:
    """Is a torque missing, so that there are places where it is?"""
    return not (found.verdict == "none" or only_sensors(found) or only_usual(found))
