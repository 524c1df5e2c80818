"""A report as one HTML file that needs nothing else: no network, no second file."""

import base64
import gzip
from functools import cache
from pathlib import Path

from jinja2 import Environment, PackageLoader, StrictUndefined
from plotly.offline import get_plotlyjs

from exoid.files.replacing import replacing
from exoid.files.visible import visible
from exoid.report.figures.draw import draw
from exoid.report.parts.case import Case
from exoid.report.sections.advice import advice
from exoid.report.sections.determined import determined
from exoid.report.sections.drops import drops
from exoid.report.sections.mismatch.parting import parting
from exoid.report.sections.mismatch.physics import physics
from exoid.report.sections.mismatch.proof import proof
from exoid.report.sections.motion import motion
from exoid.report.sections.multistart import multistart
from exoid.report.sections.parameters import parameters
from exoid.report.sections.provenance import provenance
from exoid.report.sections.quality import quality
from exoid.report.sections.summary import summary
from exoid.report.words.typeset import tidy, typeset

SECTIONS = (
    summary,
    quality,
    drops,
    parameters,
    determined,
    motion,
    multistart,
    parting,
    physics,
    proof,
    advice,
    provenance,
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
    found = [(each, blocks) for each in SECTIONS if (blocks := list(each.blocks(case)))]
    template = templates().get_template("page.html")
    text = template.render(case=case, sections=found, library=packed_library())
    return visible(text, "\n\t")


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
    made.filters["kind"] = lambda block: type(block).__name__
    made.filters["tidy"] = tidy
    made.filters["drawn"] = draw
    made.filters["typeset"] = typeset
    return made


@cache
def packed_library() -> str:
    """plotly.js, compressed as a browser can unpack it: a third of its size."""
    return base64.b64encode(gzip.compress(get_plotlyjs().encode(), mtime=0)).decode("ascii")
