"""What `diagnose` says of a recording, as the score and a file of answers want it."""

import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from exoid.mismatch.answer.diagnosis import Diagnosis
from exoid.recordings.recording import Recording

from .hidden import explained


@dataclass(frozen=True)
class Answer:
    """One answer; `verdict` is "failed" where there is none."""

    verdict: str
    ranking: tuple[str, ...] = ()
    selected: tuple[str, ...] = ()
    equivalent: tuple[str, ...] = ()
    novel: bool = False
    weight: float | None = None  # of all explanations, that those with what is named hold
    formula: str | None = None
    before: float | None = None  # rad, rms of the angle on data held out, by the baseline
    after: float | None = None  # rad, the same with what was found
    floor: float | None = None  # rad, of the sensor's noise
    explained: float | None = None  # share of the hidden torque, by the formula
    seconds: float = 0.0
    fault: str | None = None

    @property
    def words(self) -> str:
        """For a table."""
        if self.verdict == "mismatch" and self.novel:
            return f"novel: {self.formula}"
        if self.verdict == "mismatch":
            return " + ".join(self.selected or self.ranking[:1])
        said = self.verdict.replace("_", " ")
        return f"{said}: {self.fault}" if self.fault else said

    def as_json(self) -> dict[str, Any]:
        """As a scorer reads it, in degrees."""
        return {
            "verdict": self.verdict,
            "ranking": list(self.ranking),
            "selected": list(self.selected),
            "equivalent": list(self.equivalent),
            "weight": self.weight,
            "novel": self.novel,
            "heldout_rmse_before": in_degrees(self.before),
            "heldout_rmse_after": in_degrees(self.after),
            "formula_explains": self.explained,
            "seconds": round(self.seconds, 1),
        }


def ask(
    name: str, load: Callable[[], Recording], truth: Mapping[str, Any] | None, seed: int
) -> Answer:
    """Diagnose one recording; whatever goes wrong is the answer.

    The truth only judges a formula.
    """
    started = time.perf_counter()
    try:
        found = diagnosed(name, load(), seed)
        seconds = time.perf_counter() - started
        answer = given(document(found, seed), seconds)
        if found.formula is None or truth is None or truth["category"] != "novel":
            return answer
        return replace(answer, explained=explained(found, truth))
    except Exception as fault:  # the other cases must run
        words = " ".join(f"{type(fault).__name__}: {fault}".split())
        return Answer("failed", seconds=time.perf_counter() - started, fault=words[:200])


def diagnosed(name: str, recording: Recording, seed: int) -> Diagnosis:
    from exoid.mismatch.missing_physics import diagnose

    return diagnose([(name, recording)], seed=seed)


def document(found: Diagnosis, seed: int) -> Mapping[str, Any]:
    import exoid
    from exoid.report.document.diagnosis_json import diagnosis_document

    version = getattr(exoid, "__version__", "unknown")
    return diagnosis_document(found, version=version, recordings=[], settings={"seed": seed})


def given(document: Mapping[str, Any], seconds: float) -> Answer:
    """The answer in a document; what was selected is ranked even where the ranking lacks it."""
    selected, ranking = tuple(document["selected"] or ()), tuple(document["ranking"] or ())
    ranked = (*(name for name in selected if name not in ranking), *ranking)
    return Answer(
        verdict=document["verdict"],
        ranking=ranked,
        selected=selected,
        equivalent=tuple(document["equivalent"] or ()),
        novel=bool(document["novel"]),
        weight=document["weight"],
        formula=document["novel_formula"],
        before=document["heldout_rmse_before"],
        after=document["heldout_rmse_after"],
        floor=document["noise_floor"],
        seconds=seconds,
    )


def in_degrees(angle: float | None) -> float | None:
    return None if angle is None else round(float(np.degrees(angle)), 5)
