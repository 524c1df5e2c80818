"""A diagnosis as JSON, for machines: the document's schema."""

from collections.abc import Mapping, Sequence
from typing import Any

from exoid.mismatch.answer.diagnosis import Diagnosis
from exoid.report.document.fit_json import model
from exoid.report.document.plain_json import plain, shown
from exoid.report.words.diagnosis.sentences import sentences
from exoid.report.words.diagnosis.verdict import headline


def diagnosis_document(
    found: Diagnosis,
    *,
    version: str,
    recordings: Sequence[Mapping[str, Any]],
    settings: Mapping[str, Any],
) -> dict[str, Any]:
    """The diagnosis in SI units and radians; null where nothing is known."""
    ran = [found.baseline, *found.singles, *found.pairs]
    return plain(
        {
            "exoid": version,
            "recordings": list(recordings),
            "settings": settings,
            "follows_recording": found.follows,
            "astray": None if found.follows else found.fit.astray,
            "verdict": found.verdict,
            "selected": found.selected,
            "ranking": found.ranking,
            "equivalent": found.equivalent,
            "in_all": found.in_all,
            "novel": found.novel,
            "novel_formula": None if found.formula is None else found.formula.words,
            "novel_explained": None if found.formula is None else found.formula.explained,
            "novel_once_s": None if found.formula is None else found.formula.once,
            "where": [
                shown(each, ["torque"], begin="from_s", end="to_s")
                for each in found.location.regions
            ],
            "pattern": found.location.pattern,
            "parameters": {each.name: shown(each, ["name"]) for each in found.parameters},
            "twins": {each.name: shown(each, ["name"]) for each in found.twins},
            "inertia_of_parameters": found.inertia,
            "inertia_of_where": found.location.inertia or found.inertia,
            "inertia_is_a_guess": found.fit.parameters["inertia"].value is None,
            "booked_before": {each.name: shown(each, ["name"]) for each in found.booked},
            "before": model(found.before, {}),
            "after": None if found.after is None else model(found.after, {}),
            "suspected": [
                {
                    "terms": each.terms,
                    "numbers": {one.name: shown(one, ["name"]) for one in each.numbers},
                    "parameters": {one.name: shown(one, ["name"]) for one in each.parameters},
                }
                for each in found.suspected
            ],
            "heldout_rmse_before": found.proof.before.total,
            "heldout_rmse_after": found.proof.after.total,
            "noise_floor": found.proof.noise_floor,
            "false_alarm_rate": found.false_alarm_rate,
            "power": found.power,
            "inclusion": found.inclusion,
            "weight": found.weight,
            "sensors": [{**shown(each), "clear": each.clear} for each in found.sensors],
            "candidates": [shown(one, ["chosen"]) for one in ran],
            "excluded": found.excluded,
            "reasons": found.reasons,
            "advice": found.advice,
            "summary": [headline(found), *(f"{k}: {v}" for k, v in sentences(found).items())],
        }
    )
