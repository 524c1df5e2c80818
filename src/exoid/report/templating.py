"""What every page is made with: templates that escape, and the library that draws its figures."""

import base64
import gzip
from functools import cache

from jinja2 import Environment, PackageLoader, StrictUndefined
from plotly.offline import get_plotlyjs

from exoid.report.figures.draw import draw
from exoid.report.words.typeset import tidy, typeset


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
