"""How the report came about, and how to make it again."""

from collections.abc import Iterator

from exoid.report.parts.case import Case
from exoid.report.sections.blocks import Block
from exoid.report.sections.made import made
from exoid.report.sections.section import section


@section("provenance", "Where this comes from")
def provenance(case: Case) -> Iterator[Block]:
    """Of the case's origin."""
    yield from made(case.origin)
