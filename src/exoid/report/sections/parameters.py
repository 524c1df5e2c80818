"""The leg's numbers with their errors, beside what anatomy expects and what was allowed."""

from collections.abc import Iterator

from exoid.fitting.result.estimates.estimate import Estimate
from exoid.fitting.result.fit_result import FitResult
from exoid.report.parts.case import Case
from exoid.report.pictures.determined import show_parameters
from exoid.report.sections.blocks import Block, element
from exoid.report.sections.section import section
from exoid.report.tables import leg as tables
from exoid.report.tables.fit import remarks


@section("parameters", "The leg's numbers")
def parameters(case: Case) -> Iterator[Block]:
    """Parameters, ratios, and what each recording owned; why values or errors are missing."""
    if case.fit.follows:
        yield from numbers(case.fit)
    said = remarks(case.fit)
    if said:
        yield element("h3", "Notes")
        yield said


def numbers(fit: FitResult) -> Iterator[Block]:
    """Their tables, and the parameters as a figure."""
    quantities = parameters_of(fit)
    yield tables.parameters(quantities)
    yield f"Prior: {fit.prior}."
    figure = show_parameters(quantities)
    if figure is not None:
        yield figure
    yield tables.ratios(fit)
    yield tables.terms(fit)
    yield tables.mountings(fit)


def parameters_of(fit: FitResult) -> dict[str, Estimate]:
    """m, J, l, d, c, m l g, and the torque of voluntary segments."""
    torque = fit.torque_amplitude
    return {**fit.of_leg, **({} if torque is None else {"torque_amplitude": torque})}
