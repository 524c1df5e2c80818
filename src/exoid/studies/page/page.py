"""A study as one HTML file that needs nothing else, in the clothes of a single report."""

from functools import cache
from pathlib import Path

from jinja2 import ChoiceLoader, Environment, PackageLoader

from exoid.files.replacing import replacing
from exoid.files.visible import visible
from exoid.report.templating import packed_library
from exoid.report.templating import templates as of_report
from exoid.studies.page.parts.part import Told
from exoid.studies.page.parts.person import people as everyone
from exoid.studies.page.sections.groups import groups
from exoid.studies.page.sections.origin import failed, origin
from exoid.studies.page.sections.pairs import change, sides
from exoid.studies.page.sections.people import people
from exoid.studies.page.sections.physics import physics
from exoid.studies.page.sections.reliability import reliability
from exoid.studies.page.sections.summary import summary

PARTS = (summary, people, groups, change, reliability, sides, physics, failed, origin)


def write_page(told: Told, path: str | Path) -> None:
    """Writes the page, in full or not at all.

    **Raises** `ValueError` or `OSError` (what to do) where the file cannot be written.
    """
    text = build_page(told)
    with replacing(path) as part:
        part.write_text(text, encoding="utf-8")


def build_page(told: Told) -> str:
    """The page: every part that has something to say of this study."""
    found = [(each, blocks) for each in PARTS if (blocks := filled(each.blocks(told)))]
    text = (
        templates()
        .get_template("study.html")
        .render(
            told=told,
            origin=told.origin,
            case={"who": ""},
            sections=found,
            people=everyone(told.answers),
            library=packed_library(),
        )
    )
    return visible(text, "\n\t")


def filled(blocks) -> list:
    """Without those that show nothing."""
    return [each for each in blocks if each and getattr(each, "blocks", True)]


@cache
def templates() -> Environment:
    """The report's, with those of a study."""
    made = of_report().overlay()
    made.loader = ChoiceLoader([PackageLoader("exoid.studies.page"), PackageLoader("exoid.report")])
    return made
