"""What is held equal between groups: numbers such as an age, words such as a site."""

from collections.abc import Sequence

import numpy as np
from jaxtyping import Float

from exoid.studies.statistics.mixed.stacks import Effects
from exoid.studies.statistics.tables.frames import Frame
from exoid.studies.statistics.tables.said import NotTold

Column = Float[np.ndarray, " row"]


def label(cell: object) -> str:
    """A group's name; whole numbers without a point."""
    return f"{cell:g}" if isinstance(cell, float) else str(cell)


def centred(frame: Frame, column: str) -> list[Column]:
    """A column less its mean; of words one for each but the first, which the mean holds."""
    cells = frame[column]
    if cells.map(type).isin([int, float]).all():
        found = [cells.to_numpy(float)]
    else:
        words = cells.map(label)
        found = [(words == each).to_numpy(float) for each in sorted(words.unique())[1:]]
    return [each - each.mean() for each in found]


def apart(columns: Sequence[Column], by: str, adjust: Sequence[str]) -> Effects:
    """The effects side by side.

    **Raises** `NotTold` where one follows from the others, so that no number of people parts them.
    """
    effects = np.column_stack(columns)
    if np.linalg.matrix_rank(effects) < effects.shape[1]:
        others = " and ".join(repr(each) for each in adjust)
        raise NotTold(
            f"{by!r} and {others} part people in the same way: whose effect a difference is, "
            "cannot be told. Compare within one of them, or adjust for less."
        )
    return effects
