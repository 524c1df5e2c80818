"""An interactive figure of the report, with what it shows in words."""

from dataclasses import dataclass
from typing import Any

from plotly.graph_objects import Figure as Drawing


@dataclass(frozen=True, eq=False)
class Figure:
    """A drawing; `alt` for those who do not see it, `caption` for those who do."""

    name: str  # of its place on the page
    alt: str
    caption: str
    drawing: Drawing
    linked: str = ""  # figures of the same word are zoomed together

    @property
    def height(self) -> int:
        """In pixels."""
        layout: Any = self.drawing.layout
        return int(layout.height)

    @property
    def document(self) -> str:
        """The drawing as JSON; its angle brackets are escapes, so that no text ends a script."""
        text = self.drawing.to_json()
        assert text is not None  # what plotly drew, it can write
        return text
