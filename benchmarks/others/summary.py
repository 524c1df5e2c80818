"""What all marks come to: a line for each case, and a table by person, device, trouble, effect."""

from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np

from .score import FitMark, Mark

GROUPS = ("person", "device", "trouble", "effect")
NULL, EFFECT = (
    ("quiet", "sensor", "alarm"),
    ("named", "part", "unsure", "unseen", "missed", "wrong"),
)
HEAD = (
    "group", "cases", "fits", "right", "warned", "cover 99 %", "leg 95 %", "error/bound", "90 %",
    "nulls", "alarms", "effects", *EFFECT, "refused",
)  # fmt: skip

FAULTS = ("alarm", "missed", "wrong", "refused")
ABOUT = """# Recordings as others make them

What `python -m benchmarks.others` made of its cases; `benchmarks/README.md` says how they are made
and what the columns count.
"""


@dataclass(frozen=True)
class Marked:
    """A case with its marks; None where nobody asked, or where there is nothing to judge."""

    truth: dict[str, Any]
    fit: FitMark | None
    diagnosis: Mark | None


def value(truth: dict[str, Any], group: str) -> str:
    return truth["device"]["kind"] if group == "device" else truth[group]


def line(case: Marked) -> str:
    """One case."""
    truth, device = case.truth, case.truth["device"]
    what = [truth["id"], truth["person"], f"{device['kind']} {device['rate']:.0f} Hz"]
    what += [f"{np.degrees(truth['angle_noise_rad']):.2f} deg", truth["trouble"], truth["effect"]]
    what += ["systematic"] * truth["systematic"] + ["table"] * truth["table"]
    said = [fit_words(case.fit)] if case.fit else []
    said += [f"{case.diagnosis.word} ({case.diagnosis.said})"] if case.diagnosis else []
    return " ".join(what) + " | " + "; ".join(said)


def fit_words(mark: FitMark) -> str:
    if mark.refused is not None:
        return f"fit refused: {mark.refused}"
    away = " ".join(f"{100 * d:+.2f}%" for d in mark.deviation)
    errors = " ".join(f"{a:.1f}" for a in mark.away)
    ratio = " ".join(f"{r:.1f}" for r in mark.error_over_bound)
    lost = f" undetermined {','.join(mark.undetermined)}" if mark.undetermined else ""
    verdict = "right" if mark.right else "NOT RIGHT"
    verdict += " (it says so)" * mark.warned
    return f"{verdict} {away} | {errors} errors | error/bound {ratio}{lost}"


def rows(cases: list[Marked]) -> Iterator[tuple[str, ...]]:
    """The whole, then every group's values."""
    yield row("all", cases)
    plain = [c for c in cases if c.truth["trouble"] == "none" and not c.truth["systematic"]]
    yield row("no trouble, no systematic", plain)
    yield row("systematic", [c for c in cases if c.truth["systematic"]])
    yield row("continuous table", [c for c in cases if c.truth["table"]])
    for group in GROUPS:
        for name in sorted({value(c.truth, group) for c in cases}):
            yield row(f"{group} {name}", [c for c in cases if value(c.truth, group) == name])


def row(name: str, cases: list[Marked]) -> tuple[str, ...]:
    fits = [c.fit for c in cases if c.fit is not None]
    covered = [x for f in fits for x in f.covered]
    ratios = [x for f in fits for x in f.error_over_bound]
    words = Counter(c.diagnosis.word for c in cases if c.diagnosis is not None)
    refused = words["refused"] + sum(f.refused is not None for f in fits)
    middle, high = (f"{np.percentile(ratios, q):.2f}" if ratios else "-" for q in (50, 90))
    return (
        name, str(len(cases)),
        str(len(fits)), str(sum(f.right for f in fits)), str(sum(f.warned for f in fits)),
        share(covered), share([x for f in fits for x in f.leg_covered]), middle, high,
        str(sum(words[each] for each in NULL)), str(words["alarm"]),
        str(sum(words[each] for each in EFFECT)), *(str(words[each]) for each in EFFECT),
        str(refused),
    )  # fmt: skip


def share(flags: list[bool]) -> str:
    return f"{100 * np.mean(flags):.1f}" if flags else "-"


def aligned(head: tuple[str, ...], body: list[tuple[str, ...]]) -> str:
    widths = [max(map(len, column)) for column in zip(head, *body, strict=True)]
    return "\n".join(
        "  ".join(cell.ljust(w) for cell, w in zip(each, widths, strict=True)).rstrip()
        for each in (head, *body)
    )


def page(cases: list[Marked]) -> str:
    """The table in Markdown, and a line for each answer that is not as it should be."""
    lines = [HEAD, ("---",) * len(HEAD), *rows(cases)]
    table = "\n".join(f"| {' | '.join(each)} |" for each in lines)
    faulty = [f"- {line(case)}" for case in cases if faults(case)]
    return "\n".join([ABOUT, table, "", "Not as they should be:", "", *(faulty or ["none"]), ""])


def faults(case: Marked) -> bool:
    return (case.fit is not None and not case.fit.right) or (
        case.diagnosis is not None and case.diagnosis.word in FAULTS
    )
