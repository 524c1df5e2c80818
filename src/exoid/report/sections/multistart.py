"""Where the starts of the search ended, and which other sets of parameters fit as well."""

from collections.abc import Iterator

from exoid.files.counted import counted
from exoid.fitting.result.fit_result import MultistartReport
from exoid.report.parts.case import Case
from exoid.report.pictures.search import pairs_of, show_costs, show_family
from exoid.report.sections.blocks import Block, Group
from exoid.report.sections.section import section
from exoid.report.tables.fit import span
from exoid.report.tables.table import Table
from exoid.report.words.text import in_words


@section("multistart", "The search from many starts")
def multistart(case: Case) -> Iterator[Block]:
    """The waterfall of costs, and the families."""
    report = case.fit.multistart
    yield summary(report)
    yield [
        f"{counted(count, 'start')} failed: {reason}." for reason, count in report.failures.items()
    ]
    costs = show_costs(report)
    families = [show_family(case.fit, pair) for pair in pairs_of(case.fit)]
    yield Group("div", [*([] if costs is None else [costs]), *families], "grid")
    if not case.fit.follows:
        return
    columns = {
        "parameter": [in_words(name) for name in report.family],
        "range": [span(case.fit, name) for name in report.family],
    }
    yield Table("Any set within these ranges that keeps the ratios fits equally well", columns)


def summary(report: MultistartReport) -> str:
    """How many starts arrived, and whether they agree."""
    found = counted(report.distinct, "distinct minimum", "distinct minima")
    return (
        f"{counted(report.starts, 'start')}: {report.succeeded} succeeded, {report.at_best} at the "
        f"best cost; {found}."
    )
