"""The words that options can take."""

from enum import StrEnum
from typing import Annotated

import typer


class Table(StrEnum):
    """Where the expected parameters come from."""

    auto = "auto"
    de_leva = "de_leva"
    winter = "winter"
    dumas = "dumas"
    child = "child"
    heavy = "heavy"
    paper = "paper"
    none = "none"


class Bounds(StrEnum):
    """Between which limits a fit searches."""

    body = "body"
    paper = "paper"


class Method(StrEnum):
    """How the misfit is minimised."""

    lm = "lm"
    slsqp = "slsqp"


class Reading(StrEnum):
    """The two readings of Eq. 4."""

    one = "1/T"
    two = "2/T"


class Misfit(StrEnum):
    """What Eq. 11 compares."""

    weighted = "weighted"
    paper = "paper"


class Clip(StrEnum):
    """Which samples of a segment are fitted."""

    free = "free"
    paper = "paper"


class Flip(StrEnum):
    """Channels of the other sign."""

    angle = "angle"
    gyro = "gyro"
    all = "all"


class Zero(StrEnum):
    """What a file calls 0."""

    extended = "extended"
    hanging = "hanging"
    unknown = "unknown"


class Side(StrEnum):
    """Which leg."""

    left = "left"
    right = "right"


Seed = Annotated[int, typer.Option(min=0, help="Of the starts; same seed, same result.")]
FlipOption = Annotated[
    Flip | None, typer.Option("--flip", help="What counts flexion as positive in this file.")
]
ZeroOption = Annotated[
    Zero | None,
    typer.Option(
        "--zero", help="The leg whose angle is 0 in this file; unknown: found where it rests."
    ),
]
