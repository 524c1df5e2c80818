"""How a page was made, and how to make it again."""

from collections.abc import Iterator

from markupsafe import Markup

from exoid.report.parts.origin import Origin
from exoid.report.sections.blocks import Block, element
from exoid.report.tables.table import Table

COMMAND = Markup('<pre class="wide" tabindex="0" aria-label="Command"><code>{}</code></pre>')


def made(origin: Origin) -> Iterator[Block]:
    """Versions, settings, files with their SHA-256, time, and the command."""
    yield element("p", f"Made on {origin.made} by the command")
    yield COMMAND.format(origin.command)
    yield "which repeats it where the files, settings and versions below are the same."
    yield listed("Files that were read", ("file", "SHA-256"), origin.files)
    yield listed("Settings", ("setting", "value"), origin.settings)
    yield listed("Versions", ("software", "version"), origin.versions)


def listed(caption: str, heads: tuple[str, str], each) -> Table:
    """Names and what they are."""
    return Table(caption, dict(zip(heads, (list(each), list(each.values())), strict=True)))
