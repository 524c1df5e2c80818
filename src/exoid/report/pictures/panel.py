"""What a figure shows, in numbers and roles. Whoever draws it knows no more than this.

A symbol in a text stands between backticks: "inertia `J`".
"""

from dataclasses import dataclass, field

import numpy as np
from jaxtyping import Float

from exoid.report.pictures.role import Role

Values = Float[np.ndarray, " value"]
NEAR_TOP = 0.1  # of an upright span from its top, where its name stands clear of a curve
Range = tuple[float, float]
Place = tuple[float, float]


@dataclass(frozen=True)
class Axis:
    """What is counted along an edge; `ticks` are places with their names instead of numbers."""

    title: str = ""
    unit: str = ""
    limits: Range | None = None
    logarithmic: bool = False
    reversed: bool = False
    ticks: tuple[tuple[float, str], ...] = ()
    hidden: bool = False

    @property
    def label(self) -> str:
        """title [unit]."""
        return f"{self.title} [{self.unit}]" if self.unit else self.title


@dataclass(frozen=True, eq=False)
class Line:
    """A curve through samples."""

    role: Role
    x: Values
    y: Values


@dataclass(frozen=True, eq=False)
class Points:
    """Places, each with the errors of all of them where they are known.

    `told` is what a page says of each that is pointed at, `opens` what it opens where it is chosen.
    """

    role: Role
    x: Values
    y: Values
    x_error: float | None = None
    y_error: float | None = None
    told: tuple[str, ...] = ()
    opens: tuple[str, ...] = ()


@dataclass(frozen=True, eq=False)
class Cloud:
    """Places with a value each, which is a colour; beyond `most` colours are the same."""

    x: Values
    y: Values
    value: Values
    most: float
    label: str


@dataclass(frozen=True)
class Band:
    """All between two heights, or upright between two places across."""

    role: Role
    low: float
    high: float
    upright: bool = False


@dataclass(frozen=True)
class Rule:
    """A straight line through the panel at one height, or upright at one place across."""

    role: Role
    at: float
    upright: bool = False


@dataclass(frozen=True, eq=False)
class Bars:
    """Lying bars at these rows; `begin` where they stand on others, `words` beside each."""

    role: Role
    rows: Values
    lengths: Values
    begin: Values | None = None
    words: tuple[str, ...] = ()


@dataclass(frozen=True)
class Span:
    """A named distance between two places, upright or level."""

    begin: Place
    end: Place
    name: str


@dataclass(frozen=True)
class Note:
    """Words in a panel: `across` is a part of its width, `height` a number on its axis."""

    words: str
    across: float
    height: float


Mark = Line | Points | Cloud | Band | Rule | Bars | Span | Note


@dataclass(frozen=True, eq=False)
class Panel:
    """Marks over two axes; `absent` says why there are none."""

    across: Axis
    up: Axis
    marks: tuple[Mark, ...]
    title: str = ""
    size: float = 1.0  # of its height, beside the others of a picture
    absent: str = ""

    def of(self, *kinds: type) -> list:
        """Its marks of these kinds."""
        return [each for each in self.marks if isinstance(each, kinds)]


@dataclass(frozen=True, eq=False)
class Picture:
    """Panels above each other: `alt` for those who do not see them, `caption` for those who do."""

    name: str  # of its place on a page
    alt: str
    caption: str
    panels: tuple[Panel, ...] = field(repr=False)
    linked: str = ""  # pictures of the same word are zoomed together
