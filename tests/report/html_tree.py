"""A page as a tree of elements, by Python's own parser."""

from collections.abc import Iterator
from dataclasses import dataclass, field
from html.parser import HTMLParser

VOID = {"meta", "link", "br", "img", "input", "hr"}


@dataclass(eq=False)
class Element:
    """A tag with its attributes, its children and the text between them."""

    tag: str
    attributes: dict[str, str] = field(default_factory=dict)
    children: list["Element | str"] = field(default_factory=list)

    def __iter__(self) -> Iterator["Element"]:
        """This element and all below it, in the order of the page."""
        yield self
        for child in self.children:
            if isinstance(child, Element):
                yield from child

    def all(self, *tags: str) -> list["Element"]:
        return [each for each in self if each.tag in tags]

    def of_class(self, name: str) -> list["Element"]:
        return [each for each in self if name in each.attributes.get("class", "").split()]

    def by_id(self, name: str) -> "Element":
        return next(each for each in self if each.attributes.get("id") == name)

    @property
    def text(self) -> str:
        parts = (each if isinstance(each, str) else each.text for each in self.children)
        return " ".join("".join(parts).split())


class Reader(HTMLParser):
    def __init__(self):
        super().__init__()
        self.open = [Element("page")]

    def handle_starttag(self, tag, attrs):
        element = Element(tag, {name: value or "" for name, value in attrs})
        self.open[-1].children.append(element)
        if tag not in VOID:
            self.open.append(element)

    def handle_endtag(self, tag):
        assert self.open.pop().tag == tag, f"</{tag}> closes something else"

    def handle_data(self, data):
        self.open[-1].children.append(data)


def parse(page: str) -> Element:
    """The tree; every element that was opened is closed, and in order."""
    reader = Reader()
    reader.feed(page)
    reader.close()
    (root,) = reader.open
    return root


def rows(table: Element) -> list[dict[str, str]]:
    """The rows of a table by its heads."""
    heads = [each.text for each in table.all("thead")[0].all("th")]
    body = table.all("tbody")[0].all("tr")
    return [dict(zip(heads, [c.text for c in row.all("th", "td")], strict=True)) for row in body]
