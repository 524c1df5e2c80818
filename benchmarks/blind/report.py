"""The answers and their score as text, for a terminal and for a page in Markdown."""

import numpy as np

from .answer import Answer, in_degrees
from .score import SOUND, Answers, Score, Tally, verdict_of
from .sets import Blind

HEAD = ("case", "truth", "answer", "correct", "before/deg", "after/deg", "seconds")
CORRECT = HEAD.index("correct")
LONGEST = 60  # letters of an answer
ENOUGH = 0.9  # share of a hidden torque's variance
MOST = 60  # cases, beyond which only those are listed whose answer is wrong


def rows(cases: list[Blind], answers: Answers) -> list[tuple[str, ...]]:
    """One row a case; of very many cases those that went wrong."""
    every = [row(case, answers[case.name]) for case in cases if case.name in answers]
    return every if len(every) <= MOST else [each for each in every if each[CORRECT] != "yes"]


def row(case: Blind, answer: Answer) -> tuple[str, ...]:
    correct = verdict_of(case.truth, answer) if case.truth else "-"
    before, after = (number(in_degrees(each)) for each in (answer.before, answer.after))
    said = answer.words if len(answer.words) <= LONGEST else answer.words[: LONGEST - 3] + "..."
    return case.name, case.concealed, said, correct, before, after, f"{answer.seconds:.1f}"


def number(value: float | None) -> str:
    return "-" if value is None else f"{value:.3f}"


def aligned(table: list[tuple[str, ...]]) -> str:
    """Columns under each other."""
    widths = [max(map(len, column)) for column in zip(*table, strict=True)]
    return "\n".join(
        "  ".join(cell.ljust(width) for cell, width in zip(line, widths, strict=True)).rstrip()
        for line in table
    )


def summary(score: Score, answers: Answers) -> list[tuple[str, str]]:
    """What was counted, and the counts."""
    lines = [("effects, all", counts(score.all)), ("effects, leniently", counts(score.lenient))]
    lines += [(f"effects, {name}", counts(each)) for name, each in score.groups.items()]
    for category in SOUND:
        found, count = score.false_alarms[category]
        lines.append((f"false alarms, {category}", f"{len(found)} of {count} {listed(found)}"))
    novel = score.called_novel
    lines.append(("library effects called novel", f"{len(novel)} {listed(novel)}"))
    told = sorted(each.explained for each in answers.values() if each.explained is not None)
    if told:
        most = f"median {np.median(told):.0%}, least {told[0]:.0%}"
        ninety = sum(each >= ENOUGH for each in told)
        lines.append(
            ("hidden torque explained by a formula", f"{most}; 90 % in {ninety} of {len(told)}")
        )
    failed = [name for name, answer in answers.items() if answer.verdict == "failed"]
    lines.append(("failed", f"{len(failed)} {listed(failed)}"))
    lines.append(("held-out after / before", improvement(answers)))
    seconds = sorted(answer.seconds for answer in answers.values())
    lines.append(("seconds a case", f"median {np.median(seconds):.1f}, most {seconds[-1]:.1f}"))
    return [(name, value.strip()) for name, value in lines]


def counts(each: Tally) -> str:
    if not each.count:
        return "none to find"
    of = f"of {each.count}"
    return f"detected {each.detected}, top-1 {each.first}, top-3 {each.three} {of}"


def listed(names: list[str]) -> str:
    return f"({', '.join(names)})" if names else ""


def improvement(answers: Answers) -> str:
    """Of all answers that claim a mismatch."""
    gains = [
        each.after / each.before
        for each in answers.values()
        if each.verdict == "mismatch" and each.before and each.after is not None
    ]
    if not gains:
        return "no mismatch was claimed"
    worse = sum(gain > 1 for gain in gains)
    return (
        f"median {np.median(gains):.2f}, worst {max(gains):.2f}, worse in {worse} of {len(gains)}"
    )


def confusions(score: Score) -> list[tuple[str, str]]:
    """Every truth but pairs with its first answers, most frequent first."""
    return [
        (truth, ", ".join(f"{name} {count}" for name, count in given.most_common()))
        for truth, given in sorted(score.confusion.items())
        if "+" not in truth
    ]


def terminal(cases: list[Blind], answers: Answers, score: Score) -> str:
    parts = [[HEAD, *rows(cases, answers)], summary(score, answers), confusions(score)]
    return "\n\n".join(aligned(part) for part in parts if part)


def page(cases: list[Blind], answers: Answers, score: Score, *, command: str, image: str) -> str:
    """The same in Markdown."""
    return f"""\
# Blind cases

Made by `{command}`. Every recording holds the baseline model and what is named under *truth*, which
`diagnose` was not told; *correct* goes by its first name (of two effects: both, among the first
three). *before* and *after* are rms errors of the angle on data held out, without and with what was
found. Of more than {MOST} cases, only those are listed whose answer is wrong.

{markdown(("what", "count"), summary(score, answers))}

![Truth against first answers; held-out errors before and after]({image})

{markdown(HEAD, rows(cases, answers))}

## First answers

{markdown(("truth", "first answers"), confusions(score))}
"""


def markdown(head: tuple[str, ...], body: list) -> str:
    lines = [head, ("---",) * len(head), *body]
    return "\n".join(f"| {' | '.join(cell.replace('|', '/') for cell in line)} |" for line in lines)
