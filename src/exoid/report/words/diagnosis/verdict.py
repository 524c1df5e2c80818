"""The verdict of a diagnosis in one line."""

from exoid.fitting.result.remarks.rig_words import of_rig
from exoid.mismatch.answer.diagnosis import Diagnosis
from exoid.physics.library import library
from exoid.physics.term import name_of
from exoid.report.words.diagnosis.asserted import only_sensors, only_usual, usual_errors
from exoid.report.words.diagnosis.cause import simple
from exoid.report.words.diagnosis.certainty import twins
from exoid.report.words.diagnosis.remainder import share_left

LITTLE = 0.03  # share of what was missing that is worth no word


def headline(found: Diagnosis) -> str:
    """The verdict in one line."""
    return of_rig(of_a_leg(found)) if found.location.rig else of_a_leg(found)


def of_a_leg(found: Diagnosis) -> str:
    if found.verdict == "none":
        return "Nothing is missing: simulation and recording agree within the noise."
    if found.but_ends and any(each.left_out for each in found.fit.segments):
        return "Nothing is missing but in the first swing: it is unlike the swings behind it."
    if found.but_ends:
        return "Nothing is missing but where movements begin or end."
    if found.verdict == "cannot_tell" and found.in_all and found.follows:
        known = {name_of(term): term.title for term in library()}
        said = " and ".join(known.get(name, name) for name in found.in_all)
        verb = "is" if len(found.in_all) == 1 else "are"
        return (
            f"{said[0].upper()}{said[1:]} {verb} in all that explains it; what acts besides, this "
            "recording cannot tell."
        )
    if found.verdict == "cannot_tell":
        return "Cannot tell from this recording."
    if found.novel:
        for term in simple(found):
            return f"Something is missing: {term.title}."
        return "Something is missing that the library does not know."
    if only_usual(found):
        return (
            f"Nothing of the leg is missing: gyro and encoder differ by {usual_errors(found)}, as "
            "they usually do, and it is counted."
        )
    if only_sensors(found):
        return "A sensor errs; of the leg's motion nothing is missing."
    if not found.explained and (share_left(found) or 0.0) > LITTLE:
        return "Something is missing, and a part of it has a name."
    return "Something is missing."


def verdict(found: Diagnosis) -> str:
    """What is missing by its name, where it has one; else the headline."""
    of_sensors = only_sensors(found) or only_usual(found)
    if found.verdict != "mismatch" or found.novel or of_sensors or not found.selected:
        return headline(found)
    return ", or ".join(["Missing: " + " and ".join(titles(found)), *twins(found).values()])


def titles(found: Diagnosis) -> list[str]:
    """What is missing, in a user's words."""
    return [each.title for each in found.findings]
