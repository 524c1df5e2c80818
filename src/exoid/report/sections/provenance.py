"""How the report came about, and how to make it again."""

from dataclasses import dataclass
from typing import ClassVar

from exoid.report.parts.case import Case
from exoid.report.sections.section import Section
from exoid.report.tables.table import Table


@dataclass(frozen=True, eq=False)
class Provenance(Section):
    """Versions, settings, files with their SHA-256, time, and the command."""

    name: ClassVar[str] = "provenance"
    title: ClassVar[str] = "Where this comes from"

    command: str
    made: str
    files: Table
    settings: Table
    versions: Table

    @classmethod
    def of(cls, case: Case) -> "Provenance":
        origin = case.origin
        return cls(
            command=origin.command,
            made=origin.made,
            files=listed("Files that were read", ("file", "SHA-256"), origin.files),
            settings=listed("Settings", ("setting", "value"), origin.settings),
            versions=listed("Versions", ("software", "version"), origin.versions),
        )


def listed(caption: str, heads: tuple[str, str], each) -> Table:
    """Names and what they are."""
    return Table(caption, dict(zip(heads, (list(each), list(each.values())), strict=True)))
