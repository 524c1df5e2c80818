"""The words that options can take."""

from typing import Annotated, Literal

import typer

# Where the expected parameters come from.
TABLES = ("auto", "de_leva", "winter", "dumas", "child", "heavy", "paper", "none")
Bounds = Literal["body", "paper"]  # between which limits a fit searches
Method = Literal["lm", "slsqp"]  # how the misfit is minimised
Reading = Literal["1/T", "2/T"]  # the two readings of Eq. 4
Misfit = Literal["weighted", "paper"]  # what Eq. 11 compares
Clip = Literal["free", "paper"]  # which samples of a segment are fitted
Flip = Literal["angle", "gyro", "all"]  # channels of the other sign
Zero = Literal["extended", "hanging", "unknown"]  # what a file calls 0
Side = Literal["left", "right"]  # which leg

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
