"""Two diagnoses side by side: verdicts, what is missing, held-out errors."""

from itertools import zip_longest
from textwrap import wrap
from typing import Any

from exoid.mismatch.answer.diagnosis import Diagnosis
from exoid.report.tables.table import Table
from exoid.report.words.diagnosis.cause import formula_words
from exoid.report.words.diagnosis.verdict import titles
from exoid.report.words.text import in_degrees

VERDICTS = {
    "none": "nothing is missing",
    "mismatch": "something is missing",
    "cannot_tell": "cannot tell",
}
NOT_ASKED = {"verdict": "not diagnosed"}
WIDE = 29  # characters of a cell


def side_by_side(sides: list[Diagnosis | None]) -> Table:
    """What does not fit into a cell goes on below it."""
    told = [NOT_ASKED if each is None else answers(each) for each in sides]
    names = dict.fromkeys(name for each in told for name in each)
    columns: dict[str, list[str]] = {"": [], "first": [], "second": []}
    for name in names:
        cells = [wrap(each.get(name, ""), WIDE) for each in told]
        for row in zip_longest([name], *cells, fillvalue=""):
            for column, cell in zip(columns.values(), row, strict=True):
                column.append(cell)
    return Table("", columns, "What the model was missing")


def answers(found: Diagnosis) -> dict[str, str]:
    """What is compared, by its name."""
    before, after = found.proof.before.total, found.proof.after.total
    own = found.formula
    known = ", ".join(titles(found)) if own is None else formula_words(found, own)
    return {
        "verdict": VERDICTS[found.verdict],
        "missing": known or ("nothing that has a name" if found.novel else "-"),
        "or else": ", ".join(found.equivalent[1:]).replace("_", " ") or "-",
        "held-out RMSE [deg]": in_degrees(before),
        "... with it [deg]": in_degrees(after) if found.changed else "-",
        "noise floor [deg]": in_degrees(found.proof.noise_floor),
        "mean square / noise": f"{found.baseline.mean_square:.3g}",
        "... with it": f"{found.best.mean_square:.3g}" if found.changed else "-",
    }


def diagnosis_entry(found: Diagnosis | None) -> dict[str, Any] | None:
    """The same for machines, in rad; None where it was not diagnosed."""
    if found is None:
        return None
    return {
        "verdict": found.verdict,
        "selected": found.selected,
        "equivalent": found.equivalent,
        "novel": found.novel,
        "novel_formula": None if found.formula is None else found.formula.words,
        "heldout_rmse_before": found.proof.before.total,
        "heldout_rmse_after": found.proof.after.total,
        "noise_floor": found.proof.noise_floor,
        "mean_square_before": found.baseline.mean_square,
        "mean_square_after": found.best.mean_square,
    }
