"""How good answers are, by the rules of the concealed set.

- Recordings that lack nothing, or nothing that can be seen: "mismatch" is a false alarm, and "none"
  is right.
- One effect of the library: detected where the verdict is "mismatch". It is named at rank k where
  one of the first k names is its own or one that is as right. To call it novel is a miss.
- Two effects or three: the first name must be one of them, and all must be among the first three.
  Whether it is called novel as well does not matter.
- Novel effects: right where the verdict is "mismatch" and it is called novel.
- Leniently, a rival that leaves hardly more than the true effect is right as well.
- No answer is a wrong answer.
"""

from collections import Counter
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from typing import Any

from .answer import Answer

Truth = Mapping[str, Any]
Answers = Mapping[str, Answer]

CONSTANT = frozenset({"torque_bias", "stiffness_rest_angle"})  # the same motion, exactly
SOUND = ("null", "unobservable")  # categories without anything to find
SETS = ("combo", "triple")  # of several effects at once


@dataclass(frozen=True)
class Mark:
    """What an answer is worth."""

    detected: bool = False
    first: bool = False
    three: bool = False


@dataclass(frozen=True)
class Tally:
    """Marks of several cases."""

    count: int
    detected: int
    first: int
    three: int


@dataclass(frozen=True)
class Score:
    """What all answers together are worth."""

    all: Tally
    lenient: Tally
    groups: dict[str, Tally]  # by category, strength and protocol
    false_alarms: dict[str, tuple[list[str], int]]  # by category: the cases, of how many
    called_novel: list[str]  # library effects that were said to be outside of it
    confusion: dict[str, Counter[str]]  # truth, then first answers


def score(truths: list[Truth], answers: Answers) -> Score:
    """The score of answers to cases whose truth is known."""
    detectable = [truth for truth in truths if truth["detectable"]]
    groups: dict[str, Tally] = {}
    for key in ("category", "strength", "protocol"):
        for value in sorted({str(truth[key]) for truth in detectable}):
            chosen = [truth for truth in detectable if str(truth[key]) == value]
            groups[f"{key} {value}"] = tally(chosen, answers)
    confusion: dict[str, Counter[str]] = {}
    for truth in truths:
        given = first_answer(answers.get(truth["id"]))
        confusion.setdefault(truth["effect"], Counter())[given] += 1
    return Score(
        all=tally(detectable, answers),
        lenient=tally(detectable, answers, lenient=True),
        groups=groups,
        false_alarms={kind: alarms(truths, answers, kind) for kind in SOUND},
        called_novel=[
            truth["id"]
            for truth in detectable
            if truth["category"] != "novel" and is_called_novel(answers.get(truth["id"]))
        ],
        confusion=confusion,
    )


def tally(truths: Iterable[Truth], answers: Answers, *, lenient: bool = False) -> Tally:
    marks = [mark(truth, answers.get(truth["id"]), lenient=lenient) for truth in truths]

    def how_many(is_so: Callable[[Mark], bool]) -> int:
        return sum(map(is_so, marks))

    return Tally(
        len(marks),
        how_many(lambda each: each.detected),
        how_many(lambda each: each.first),
        how_many(lambda each: each.three),
    )


def mark(truth: Truth, answer: Answer | None, *, lenient: bool = False) -> Mark:
    """What the answer to a case with something to find is worth."""
    if answer is None or answer.verdict != "mismatch":
        return Mark()
    names, effects = answer.ranking, set(truth["effects"])
    right = effects | set(truth["also_acceptable"])
    right |= set(truth.get("near_equivalent", ())) if lenient else set()
    first, three = names[:1], set(names[:3])
    if truth["category"] == "novel" and answer.novel:
        return Mark(True, True, True)
    if truth["category"] == "single" and answer.novel:
        return Mark(True)
    if truth["category"] in SETS:
        both = all(three & (CONSTANT if each in CONSTANT else {each}) for each in effects)
        return Mark(True, bool(right.intersection(first)), both)
    return Mark(True, bool(right.intersection(first)), bool(right & three))


def verdict_of(truth: Truth, answer: Answer) -> str:
    """Is it right, in a word?"""
    if truth["category"] in SOUND:
        return "yes" if answer.verdict == "none" else "no"
    given = mark(truth, answer)
    if truth["category"] in SETS:
        return "yes" if given.first and given.three else "one" if given.first else "no"
    return "yes" if given.first else "top 3" if given.three else "no"


def alarms(truths: Iterable[Truth], answers: Answers, category: str) -> tuple[list[str], int]:
    """The sound cases of a category in which something was found, and how many there are."""
    sound = [truth["id"] for truth in truths if truth["category"] == category]
    found = [name for name in sound if name in answers and answers[name].verdict == "mismatch"]
    return found, len(sound)


def is_called_novel(answer: Answer | None) -> bool:
    return answer is not None and answer.verdict == "mismatch" and answer.novel


def first_answer(answer: Answer | None) -> str:
    """The name that comes first, or what was said instead of one."""
    if answer is None:
        return "failed"
    if answer.verdict != "mismatch":
        return answer.verdict.replace("_", " ")
    return "novel" if answer.novel else next(iter(answer.ranking), "unnamed")
