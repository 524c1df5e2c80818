"""The leg's numbers with their errors, beside what anatomy expects and what was allowed."""

from dataclasses import dataclass
from typing import ClassVar

from exoid.fitting.result.fit_result import Estimate, FitResult
from exoid.report.parts.case import Case
from exoid.report.pictures.determined import show_parameters
from exoid.report.pictures.panel import Picture
from exoid.report.sections.section import Section
from exoid.report.sections.table import Table, quantity
from exoid.report.tables.fit import (
    MOUNTED,
    bounds,
    expectation,
    in_print,
    limited_by,
    remarks,
    shown_terms,
)
from exoid.report.words.typeset import formula


@dataclass(frozen=True, eq=False)
class Parameters(Section):
    """Parameters, ratios, and what each recording owned; why values or errors are missing."""

    name: ClassVar[str] = "parameters"
    title: ClassVar[str] = "The leg's numbers"

    figure: Picture | None
    table: Table
    ratios: Table
    terms: Table
    mountings: Table
    prior: str
    remarks: tuple[str, ...]

    @classmethod
    def of(cls, case: Case) -> "Parameters":
        quantities = parameters_of(case.fit)
        return cls(
            figure=show_parameters(quantities),
            table=table_of(quantities),
            ratios=ratios_of(case.fit),
            terms=terms_of(case.fit),
            mountings=mountings_of(case.fit),
            prior=case.fit.prior,
            remarks=tuple(remarks(case.fit)),
        )


def parameters_of(fit: FitResult) -> dict[str, Estimate]:
    """m, J, l, d, c, and the torque of voluntary segments."""
    torque = fit.torque_amplitude
    return {**fit.parameters, **({} if torque is None else {"torque_amplitude": torque})}


def table_of(quantities: dict[str, Estimate]) -> Table:
    each = list(quantities.values())
    columns = {
        "parameter": [name.replace("_", " ") for name in quantities],
        "symbol": [formula(one.symbol) for one in each],
        "value": [quantity(one) for one in each],
        "expected": [with_unit(expectation(one), one.unit) for one in each],
        "limits": [with_unit(bounds(one), one.unit) for one in each],
        "set by": [set_by(one) for one in each],
    }
    return Table("Parameters of the leg; ± is one standard error", columns)


def ratios_of(fit: FitResult) -> Table:
    each = list(fit.ratios.values())
    columns = {
        "ratio": [one.title for one in each],
        "symbol": [formula(one.symbol) for one in each],
        "value": [quantity(one) for one in each],
        "set by": [set_by(one) for one in each],
        "limited by": [limited_by(one) for one in each],
    }
    return Table("Ratios to the inertia: what motion alone can tell", columns)


def terms_of(fit: FitResult) -> Table:
    rows = shown_terms(fit)
    columns = {
        "term": [term.replace("_", " ") for term, _ in rows],
        "parameter": [one.title for _, one in rows],
        "symbol": [formula(one.symbol) for _, one in rows],
        "value": [quantity(one) for _, one in rows],
        "set by": [set_by(one) for _, one in rows],
    }
    return Table("Terms: what the model has beside Eq. 9", columns)


def mountings_of(fit: FitResult) -> Table:
    """What every recording owned, where there was something to estimate."""
    rows = [
        (mounting.recording, MOUNTED[name], in_print(each))
        for mounting in fit.mountings
        for name, each in mounting.known.items()
    ]
    columns = {
        "recording": [recording for recording, *_ in rows],
        "quantity": [name for _, name, _ in rows],
        "value": [quantity(each) for *_, each in rows],
    }
    return Table("Sensors, seat and added mass, against what is declared of them", columns)


def with_unit(words: str, unit: str) -> str:
    return words and f"{words} {unit}"


def set_by(each: Estimate) -> str:
    """The parts of the precision in words, the largest first."""
    if each.shares is None:
        return "nothing"
    if each.by_hand == "fix":
        return str(each.set_by)
    parts = {source: getattr(each.shares, source) for source in ("data", "prior", "bound")}
    kind = each.shares.kind
    said = [
        f"{source}{f' ({kind})' if kind and source == 'data' else ''} {part:.0%}"
        for source, part in sorted(parts.items(), key=lambda item: -item[1])
        if round(part, 2) > 0
    ]
    yours = [] if each.determined_by in ("data", each.set_by) else [str(each.set_by)]
    return ": ".join([*yours, ", ".join(said)])
