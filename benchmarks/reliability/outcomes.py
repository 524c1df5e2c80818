"""What was answered, how sure, and whether it is true."""

import json
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from benchmarks.others.score import EQUAL, present

REAL_BIAS = frozenset({"gyro_bias"})  # every gyro of ours has one


@dataclass(frozen=True)
class Outcome:
    """Of one recording."""

    name: str
    world: str
    kind: str  # what there was to find
    asserted: bool
    right: bool | None  # are all causes that it names there; None where it names none
    whole: bool  # and are all that are there among them
    weight: float | None


def of_blind(folder: Path) -> Iterator[Outcome]:
    """Of cases of our own: `NAME-answers.json` beside `NAME-truth.json`."""
    for path in sorted(folder.glob("*answers.json")):
        told = path.with_name(path.name.replace("answers", "truth"))
        if told.exists():
            answers = read(path)
            for truth in read(told):
                effects = [{each, *near(truth, each)} for each in truth["effects"]]
                yield outcome(truth["id"], "own", truth["category"], effects, REAL_BIAS,
                              answers[truth["id"]])  # fmt: skip


def near(truth: dict[str, Any], effect: str) -> set[str]:
    """Names as right for an effect of our own: of two that no drop tells apart either one."""
    named = {*truth["also_acceptable"], *truth["near_equivalent"]}
    twins = {each for each, same in EQUAL.items() if effect in same}
    return named & (EQUAL.get(effect, set()) | twins)


def of_others(folder: Path) -> Iterator[Outcome]:
    """Of cases as others make them."""
    for told in sorted(folder.glob("*.truth.json")):
        name = told.name.removesuffix(".truth.json")
        path = folder / "answers" / f"{name}.diagnose.json"
        if path.exists():
            truth = read(told)
            causes = [] if truth["effect"] == "none" else truth["effect"].split("+")
            effects = [{each, *EQUAL.get(each, set())} for each in causes]
            kind = ("null", "single", "combo", "triple")[len(causes)]
            yield outcome(name, "others", kind, effects, present(truth), read(path))


def read(path: Path) -> Any:
    return json.loads(path.read_text(encoding="utf-8"))


def outcome(
    name: str,
    world: str,
    kind: str,
    effects: list[set[str]],
    there: frozenset[str],
    answer: dict[str, Any],
) -> Outcome:
    """`effects` each with the names that are as right, `there` what may be named besides."""
    asserted, novel = answer["verdict"] == "mismatch", bool(answer["novel"])
    best = answer["equivalent"][0].split(" + ") if answer["equivalent"] else []
    named = set(answer["selected"] if asserted else best)
    if asserted and novel:
        right = kind == "novel"
        return Outcome(name, world, kind, asserted, right, right, None)
    allowed = set(there).union(*effects)
    right = named <= allowed if named else None
    whole = bool(effects) and all(named & each for each in effects)
    return Outcome(name, world, kind, asserted, right, whole, answer["weight"])
