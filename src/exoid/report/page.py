"""A report as one HTML file that needs nothing else: no network, no second file."""

from dataclasses import replace
from pathlib import Path

from exoid.files.replacing import replacing
from exoid.files.visible import visible
from exoid.fitting.result.refused.without_numbers import without_numbers
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
from exoid.report.templating import packed_library, templates

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
    """The page: every section that has something to say of this case, in the order above; no number
    of a fit that does not follow its recording.
    """
    case = replace(case, fit=without_numbers(case.fit))
    found = [(each, blocks) for each in SECTIONS if (blocks := list(each.blocks(case)))]
    template = templates().get_template("page.html")
    text = template.render(case=case, origin=case.origin, sections=found, library=packed_library())
    return visible(text, "\n\t")
