"""A figure for print: truth against first answers, and held-out errors before and after."""

from pathlib import Path

import matplotlib as mpl
import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Rectangle

from exoid.report.plots.style import TEXT

from .answer import Answer
from .score import Answers, Score
from .sets import Blind
from .truth import AS_RIGHT

SAID = ("none", "cannot tell", "novel", "unnamed", "failed")  # instead of a name, the last columns
CELL = 0.17  # inch
NARROWEST = 10  # cells
MARGINS = (4.6, 2.4)  # inch, for words beside and below both panels
ERRORS = 2.6  # inch, width of the second panel
MOST = 60  # cases, beyond which each is a dot and pairs have no row
DOTS = 200  # per inch
BLUE, ORANGE = "#0072B2", "#D55E00"  # of Okabe and Ito, with markers of different form


def draw(cases: list[Blind], answers: Answers, score: Score, path: Path) -> None:
    """Save the figure."""
    told = [case for case in cases if answers[case.name].before and answers[case.name].after]
    many = len(told) > MOST
    truths = [name for name in score.confusion if not (many and "+" in name)]
    truths.sort(key=lambda name: (kind_of(name), name))
    columns = columns_of(score, truths)
    height = CELL * max(len(truths), 0 if many else len(told), 8) + MARGINS[1]
    with mpl.rc_context(TEXT):
        wide = CELL * max(len(columns), NARROWEST)
        figure = Figure(figsize=(wide + ERRORS + MARGINS[0], height))
        figure.set_layout_engine("constrained")
        widths = [wide, 2 * ERRORS if many else ERRORS]
        matrix, errors = figure.subplots(1, 2, width_ratios=widths)
        draw_matrix(matrix, score, truths, columns)
        if many:
            draw_cloud(errors, [answers[case.name] for case in told])
        else:
            draw_errors(errors, told, answers)
        figure.savefig(path, dpi=DOTS)


def columns_of(score: Score, truths: list[str]) -> list[str]:
    """The names that were answered or true, then what was said instead."""
    given = {name for truth in truths for name in score.confusion[truth]}
    true = {name for name in truths if "+" not in name and "_novel" not in name}
    names = sorted((given | true) - set(SAID))
    return [*names, *(each for each in SAID if each in given or each in true)]


def draw_matrix(axes: Axes, score: Score, truths: list[str], columns: list[str]) -> None:
    """Counts, shaded by their share of the row; what is right is framed."""
    counts = np.array([[score.confusion[truth][name] for name in columns] for truth in truths])
    counts = counts.reshape(len(truths), len(columns))
    share = counts / np.maximum(counts.sum(axis=1, keepdims=True), 1)
    axes.imshow(share, cmap="Blues", vmin=0.0, vmax=1.4, aspect="equal")
    for at, truth in enumerate(truths):
        for place, name in enumerate(columns):
            if counts[at, place]:
                axes.text(place, at, str(counts[at, place]), ha="center", va="center", fontsize=6)
            if is_right(truth, name):
                axes.add_patch(Rectangle((place - 0.5, at - 0.5), 1, 1, fill=False, linewidth=0.9))
    axes.set_xticks(range(len(columns)), [in_words(name) for name in columns], rotation=90)
    axes.set_yticks(range(len(truths)), [in_words(name) for name in truths])
    axes.set_xlabel("first answer")
    axes.set_ylabel("truth")
    axes.set_title("Framed: right", loc="left")


def kind_of(truth: str) -> int:
    """Single effects first, then pairs, novelties, and recordings that lack nothing."""
    if truth == "none":
        return 3
    return 2 if truth.endswith("_novel") else 1 if "+" in truth else 0


def is_right(truth: str, answer: str) -> bool:
    if truth.endswith("_novel") and answer == "novel":
        return True
    return any(answer in (each, *AS_RIGHT.get(each, ())) for each in truth.split("+"))


def draw_errors(axes: Axes, told: list[Blind], answers: Answers) -> None:
    """A line from before to after for every case, and the noise floor."""
    given = [answers[case.name] for case in told]
    order = np.argsort([each.before for each in given])
    for at, index in enumerate(order):
        each = given[index]
        before, after, floor = (
            np.degrees(np.nan if value is None else value)
            for value in (each.before, each.after, each.floor)
        )
        axes.plot([before, after], [at, at], color="0.6", linewidth=0.8, zorder=1)
        axes.plot(before, at, "o", color=ORANGE, markerfacecolor="white", markersize=4)
        axes.plot(after, at, "D", color=BLUE, markersize=3.5)
        axes.plot(floor, at, "|", color="black", markersize=6)
    axes.set_xscale("log")
    axes.xaxis.set_major_formatter("{x:g}")
    labels = [f"{told[k].name}  {in_words(told[k].concealed)}" for k in order]
    axes.set_yticks(range(len(labels)), labels)
    axes.yaxis.tick_right()
    axes.set_ylim(-1, max(len(labels), 1))
    axes.set_xlabel("rms error of the angle, held out / deg")
    axes.set_title("Held out: ○ before, ◆ after, | noise", loc="left")


def draw_cloud(axes: Axes, given: list[Answer]) -> None:
    """A dot for every case, in units of its noise floor."""
    told = np.array([(each.before, each.after, each.floor) for each in given], dtype=float)
    before, after, floor = told.T
    axes.plot(before / floor, after / floor, "D", color=BLUE, markersize=3, alpha=0.5)
    axes.axline((1, 1), (10, 10), color="0.6", linewidth=0.8)
    axes.axhline(1.2, color=ORANGE, linewidth=0.8, linestyle="--")
    axes.set_xscale("log")
    axes.set_yscale("log")
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_major_formatter("{x:g}")
        axis.set_minor_formatter("")
    axes.set_xlabel("held-out error before / noise floor")
    axes.set_ylabel("held-out error after / noise floor")
    axes.set_title("Dashed: 1.2 noise floors; grey: no better", loc="left")


def in_words(name: str) -> str:
    return name.replace("_", " ").replace("+", " + ")
