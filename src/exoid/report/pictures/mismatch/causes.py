"""The causes that a diagnosis tried, by what each leaves unexplained."""

from dataclasses import dataclass

import numpy as np

from exoid.mismatch.answer.diagnosis import Diagnosis, Tested
from exoid.report.pictures.panel import Axis, Bars, Panel, Picture, Rule
from exoid.report.pictures.role import Role
from exoid.report.words.diagnosis.asserted import is_chosen, ran_free

BAR = 0.53  # size of one
LINES = 2  # of its name, for which a bar's row has room
LARGE = 1000.0  # times the noise, from which on three digits would be a power of ten
NARROWEST = 20.0  # times the noise: at least two powers of ten
ROOM = 1.3  # times the longest bar on its logarithmic axis, for the number beside it
MOST = 7  # beside the baseline
CHOSEN = "Blue without stripes: what was chosen."
NONE_CHOSEN = "None of them was chosen."
LESS = 0.01  # of what the baseline leaves, below which a cause explains nothing
LEAST = 0.5  # where the logarithmic axis begins, or at this share of what leaves still less


@dataclass(frozen=True)
class Cause:
    """One or two effects, or a formula."""

    name: str
    left: float  # mean square of what remains over the noise: 1 is the noise itself
    chosen: bool


def causes(found: Diagnosis) -> list[Cause]:
    """The baseline first, then those that the table of candidates has, in its order. Where none ran
    free, those that leave least at first sight, which is not to be compared with what others leave.
    """
    looked_at = sorted(found.pinned, key=lambda one: one.mean_square)
    rows = ran_free(found) or looked_at
    best = [*rows[:MOST], *(one for one in rows[MOST:] if is_chosen(one, found))]
    alone = Cause("Eq. 9 alone", found.baseline.mean_square, False)
    return [alone, *(Cause(label(one), one.mean_square, is_chosen(one, found)) for one in best)]


def label(one: Tested) -> str:
    return " +\n".join(one.terms).replace("_", " ")


def causes_of(found: Diagnosis) -> Panel:
    """The baseline and the causes beside it, on a logarithmic axis."""
    rows = causes(found)
    size, names = room(rows), [row.name for row in rows]
    at = np.cumsum(size) - size / 2 - 0.5  # the middle of each
    chosen = np.array([each.chosen for each in rows])
    most = max(NARROWEST, *(row.left for row in rows))
    least = lowest(rows)
    limits = least, least * (most / least) ** ROOM
    marks = (
        bars(Role.CHOSEN_CAUSE, rows, at, chosen),
        bars(Role.CAUSE, rows, at, ~chosen),
        Rule(Role.FLOOR, 1.0, upright=True),
    )
    return Panel(
        Axis("mean square left / noise", "-", limits, logarithmic=True),
        Axis(ticks=tuple(zip(at.tolist(), names, strict=True)), reversed=True),
        marks,
        "what explains it" if explains(rows) else "no cause leaves less than Eq. 9",
        BAR * float(size.sum()),
    )


def explains(rows: list[Cause]) -> bool:
    """Does any cause leave less than the baseline, which is the first row?"""
    return any(row.left < (1 - LESS) * rows[0].left for row in rows[1:])


def lowest(rows: list[Cause]) -> float:
    """Where the axis begins: every cause that leaves anything has a bar."""
    least = min((row.left for row in rows if row.left > 0), default=1.0)
    return LEAST if least > LEAST else LEAST * least


def room(rows: list[Cause]) -> np.ndarray:
    """How many rows each takes: a name of many lines needs more than one."""
    lines = np.array([1 + row.name.count("\n") for row in rows])
    return np.maximum(lines / LINES, 1.0)


def bars(role: Role, rows: list[Cause], at: np.ndarray, these: np.ndarray) -> Bars:
    """Those of `these` rows, which stand at these places."""
    left = [row.left for row, one in zip(rows, these, strict=True) if one]
    lengths = np.array([max(each, lowest(rows)) for each in left])
    return Bars(role, at[these], lengths, words=tuple(map(in_times, left)))


def show_causes(found: Diagnosis) -> Picture:
    rows = causes(found)
    least = [min(rows[1:], key=lambda row: row.left)] if rows[1:] else []
    others = [f"; {' '.join(one.name.split())} leaves {in_times(one.left)}" for one in least]
    some = any(row.chosen for row in rows)
    return Picture(
        "causes",
        "Bars of what every cause leaves unexplained, as mean square over the noise. Eq. 9 alone "
        f"leaves {in_times(rows[0].left)}{''.join(others)}.",
        "How much each explanation leaves, on a logarithmic scale: the dashed line is the noise "
        f"itself, nothing is left below it. {CHOSEN if some else NONE_CHOSEN}",
        (causes_of(found),),
    )


def in_times(left: float) -> str:
    """With three digits, and never as a power of ten."""
    return f"{left:.3g}" if left < LARGE else f"{left:.0f}"
