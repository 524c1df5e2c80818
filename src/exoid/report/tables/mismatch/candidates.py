"""The causes that were tried, and those that it may be, as tables."""

from exoid.mismatch.answer.diagnosis import Diagnosis
from exoid.mismatch.answer.over_inertia import guessed, parameters_shown
from exoid.report.tables.table import Column, Table
from exoid.report.words.diagnosis.asserted import evidence, is_chosen, ran_free
from exoid.report.words.diagnosis.cause import for_inertia, parameter, remark
from exoid.report.words.diagnosis.leg import tabled
from exoid.report.words.text import causes_in_words, quantity_words, shown_unit

SMALL = 0.01  # times the noise, below which two decimals would be none
LEGEND = (
    "left: mean square of what is left over the noise, 1.00 is the noise itself. evidence: log "
    "odds times two against the baseline, after the price of the parameters."
)
CHOSEN = "chosen: more causes only where they leave less than a third as much."


def suspects(found: Diagnosis) -> Table:
    """A number by Eq. 9 alone, and what each suspected cause would make of it."""
    numbers = [tabled(found, each.numbers) for each in found.suspected]
    first = numbers[0]
    columns: dict[str, Column | list[str]] = {
        "quantity": [quantity_words(one.name) for one in first],
        "Eq. 9 alone": Column([f"{one.before:.3g}" for one in first], head="Eq. 9\nalone"),
    }
    for each, own in zip(found.suspected, numbers, strict=True):
        name = causes_in_words(each.terms)
        cells = [f"{one.after:.3g}" for one in own]
        columns[name] = Column(cells, head=name.replace(" ", "\n"))
    columns["unit"] = [shown_unit(one.unit) for one in first]
    title = "What each cause that it may be would make of the leg"
    return Table(title, columns, title)


def how_large(found: Diagnosis) -> str:
    """The sizes of the suspects, by noise and J but for what a fit has; none in older files."""
    each = [
        f"{causes_in_words(one.terms)}: {', '.join(map(parameter, parameters_shown(found, own)))}"
        f"{''.join(map(remark, one.terms))}"
        for one in found.suspected
        if (own := one.parameters)
    ]
    torques = any(one.unit.startswith("N m") for each in found.suspected for one in each.parameters)
    known = torques and not guessed(found.fit)
    scale = f" ({for_inertia(found.inertia, found.fit)})" if known else ""
    return f"As large as: {'; '.join(each)}{scale}." if each else ""


def candidates(found: Diagnosis) -> Table:
    """Those that ran free with their evidence."""
    ran = ran_free(found)
    chosen = ["", *("chosen" if is_chosen(one, found) else "" for one in ran)]
    columns = {
        "cause": ["baseline, Eq. 9", *(causes_in_words(one.terms) for one in ran)],
        "left": [in_times(one.mean_square) for one in (found.baseline, *ran)],
        "evidence": ["", *(f"{evidence(one):.0f}" for one in ran)],
        "verdict": Column(chosen, head=" "),
    }
    return Table("The candidates that ran free", columns, "Candidates")


def in_times(left: float) -> str:
    """With two decimals, and never as nothing."""
    return f"{left:.2f}" if left >= SMALL else f"{left:.1g}"


def legend(found: Diagnosis) -> str:
    """What the columns of the candidates say."""
    return f"{LEGEND} {CHOSEN}" if is_chosen(found.best, found) else LEGEND
