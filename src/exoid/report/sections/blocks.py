"""What a page is made of, part by part."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Literal

from markupsafe import Markup

from exoid.report.pictures.panel import Picture
from exoid.report.tables.table import Table
from exoid.report.words.typeset import typeset

State = Literal["good", "care", "open"]
ANSWER = Markup("<p><strong>{}</strong></p>\n<p>{}</p>")


@dataclass(frozen=True, eq=False)
class Group:
    """Blocks within an element of HTML, of a class where it has one."""

    tag: str
    blocks: "Sequence[Block]"
    style: str = ""


# A sentence is a paragraph, several are a list, those with names a list of what the names mean;
# Markup is HTML already. A table or a list that holds nothing is left out.
Block = str | Sequence[str] | Mapping[str, str] | Table | Picture | Group


def card(question: str, state: State, answer: str, because: str) -> Group:
    """One question with its answer."""
    said = ANSWER.format(typeset(answer), typeset(because))
    return Group("div", [element("h3", question), said], f"card {state}")


def element(tag: str, words: str, style: str = "") -> Markup:
    """Words as HTML, with no symbol typeset."""
    opened = Markup('<{} class="{}">').format(tag, style) if style else Markup("<{}>").format(tag)
    return Markup("{}{}</{}>").format(opened, words, tag)


def some(figures: Sequence[Picture]) -> Iterator[Block]:
    """Figures beside each other, of which paper has two."""
    if len(figures) > 2:
        words = f"On paper are two of the {len(figures)} figures; the others are on the screen."
        yield element("p", words, "paper")
    yield Group("div", figures, "grid some")
