"""A report as one HTML file that needs nothing else: no network, no second file."""

import base64
import gzip
from functools import cache
from pathlib import Path

from jinja2 import Environment, PackageLoader, StrictUndefined
from plotly.offline import get_plotlyjs

from exoid.report.document.replacing import replacing
from exoid.report.figures.draw import draw
from exoid.report.parts.case import Case
from exoid.report.sections.advice import Advice
from exoid.report.sections.determined import Determined
from exoid.report.sections.drops import Drops
from exoid.report.sections.mismatch.parting import Parting
from exoid.report.sections.mismatch.physics import Physics
from exoid.report.sections.mismatch.proof import Proof
from exoid.report.sections.motion import Motion
from exoid.report.sections.multistart import Multistart
from exoid.report.sections.parameters import Parameters
from exoid.report.sections.provenance import Provenance
from exoid.report.sections.quality import Quality
from exoid.report.sections.section import Section
from exoid.report.sections.summary import Summary
from exoid.report.words.keyboard_text import tidy
from exoid.report.words.typeset import typeset

SECTIONS: tuple[type[Section], ...] = (
    Summary,
    Quality,
    Drops,
    Parameters,
    Determined,
    Motion,
    Multistart,
    Parting,
    Physics,
    Proof,
    Advice,
    Provenance,
)


def write_page(case: Case, path: str | Path) -> None:
    """Writes the page, in full or not at all.

    **Raises** `ValueError` or `OSError` (what to do) where the file cannot be written.
    """
    text = build_page(case)
    with replacing(path) as part:
        part.write_text(text, encoding="utf-8")


def build_page(case: Case) -> str:
    """The page: every section that has something to say of this case, in the order above."""
    found = [section for each in SECTIONS if (section := each.of(case)) is not None]
    template = templates().get_template("page.html")
    return template.render(case=case, sections=found, library=packed_library())


@cache
def templates() -> Environment:
    """Whatever a template shows is escaped."""
    made = Environment(
        loader=PackageLoader("exoid.report"),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    made.filters["tidy"] = tidy
    made.filters["drawn"] = draw
    made.filters["typeset"] = typeset
    return made


@cache
def packed_library() -> str:
    """plotly.js, compressed as a browser can unpack it: a third of its size."""
    return base64.b64encode(gzip.compress(get_plotlyjs().encode(), mtime=0)).decode("ascii")
