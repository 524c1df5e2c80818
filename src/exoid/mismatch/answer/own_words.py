"""A diagnosis in the words of what was diagnosed: a rig is called a rig."""

from dataclasses import replace

from exoid.fitting.result.remarks.rig_words import of_rig
from exoid.mismatch.answer.diagnosis import Diagnosis


def in_own_words(found: Diagnosis) -> Diagnosis:
    """The same, of a rig in its own words."""
    if not found.location.rig:
        return found
    named = [replace(one, explanation=of_rig(one.explanation)) for one in found.findings]
    reasons, advice = (list(map(of_rig, each)) for each in (found.reasons, found.advice))
    return replace(found, findings=named, reasons=reasons, advice=advice)
