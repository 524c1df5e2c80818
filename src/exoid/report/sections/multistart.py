"""Where the starts of the search ended, and which other sets of parameters fit as well."""

from dataclasses import dataclass
from typing import ClassVar

from exoid.fitting.result.fit_result import MultistartReport
from exoid.report.parts.case import Case
from exoid.report.pictures.panel import Picture
from exoid.report.pictures.search import pairs_of, show_costs, show_family
from exoid.report.sections.section import Section
from exoid.report.tables.fit import span
from exoid.report.tables.table import Table
from exoid.report.words.text import counted, in_words


@dataclass(frozen=True, eq=False)
class Multistart(Section):
    """The waterfall of costs, and the families."""

    name: ClassVar[str] = "multistart"
    title: ClassVar[str] = "The search from many starts"

    summary: str
    failures: tuple[str, ...]
    costs: Picture | None
    families: tuple[Picture, ...]
    ranges: Table

    @classmethod
    def of(cls, case: Case) -> "Multistart":
        report = case.fit.multistart
        ranges = {name: span(case.fit, name) for name in report.family}
        return cls(
            summary=summary(report),
            failures=tuple(
                f"{counted(count, 'start')} failed: {reason}."
                for reason, count in report.failures.items()
            ),
            costs=show_costs(report),
            families=tuple(show_family(case.fit, pair) for pair in pairs_of(case.fit)),
            ranges=Table(
                "Any set within these ranges that keeps the ratios fits equally well",
                {
                    "parameter": [in_words(name) for name in ranges],
                    "range": list(ranges.values()),
                },
            ),
        )


def summary(report: MultistartReport) -> str:
    """How many starts arrived, and whether they agree."""
    found = counted(report.distinct, "distinct minimum", "distinct minima")
    return (
        f"{counted(report.starts, 'start')}: {report.succeeded} succeeded, {report.at_best} at the "
        f"best cost; {found}."
    )
