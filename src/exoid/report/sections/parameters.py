"""The leg's numbers with their errors, beside what anatomy expects and what was allowed."""

from dataclasses import dataclass
from typing import ClassVar

from exoid.fitting.result.fit_result import Estimate, FitResult
from exoid.report.parts.case import Case
from exoid.report.pictures.determined import show_parameters
from exoid.report.pictures.panel import Picture
from exoid.report.sections.section import Section
from exoid.report.tables.fit import remarks
from exoid.report.tables.leg import mountings, parameters, ratios, terms
from exoid.report.tables.table import Table


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
            table=parameters(quantities),
            ratios=ratios(case.fit),
            terms=terms(case.fit),
            mountings=mountings(case.fit),
            prior=case.fit.prior,
            remarks=tuple(remarks(case.fit)),
        )


def parameters_of(fit: FitResult) -> dict[str, Estimate]:
    """m, J, l, d, c, and the torque of voluntary segments."""
    torque = fit.torque_amplitude
    return {**fit.parameters, **({} if torque is None else {"torque_amplitude": torque})}
