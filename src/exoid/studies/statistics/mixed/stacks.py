"""Values by people, as a mixed model sees them: who shares what with whom."""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from jaxtyping import Float, Int

from exoid.studies.statistics.tables.frames import Frame
from exoid.studies.statistics.tables.said import NotTold

Rows = Float[np.ndarray, " row"]
Effects = Float[np.ndarray, "row effect"]
Codes = Int[np.ndarray, " row"]

# What the values of a person may have in common, from all of them to none but itself.
LEVELS: dict[str, list[str]] = {
    "person": ["person"],
    "side": ["person", "side"],
    "day": ["person", "session"],
    "side on a day": ["person", "session", "side"],
}
DROP = "drop"


@dataclass(frozen=True, eq=False)
class Stack:
    """People who have equally many values.

    `known` are the variances of the values' own errors; `same` is one where two values share a
    level, so that `V = sum_k theta_k same_k + diag(known)` of each person.
    """

    rows: Int[np.ndarray, "person value"]  # of the frame
    value: Float[np.ndarray, "person value"]
    effects: Float[np.ndarray, "person value effect"]
    known: Float[np.ndarray, "person value"]
    same: Float[np.ndarray, "level person value value"]


@dataclass(frozen=True, eq=False)
class Problem:
    """All stacks, of values in units of `scale` about `origin`."""

    stacks: tuple[Stack, ...]
    levels: tuple[str, ...]
    origin: float
    scale: float

    @property
    def effects(self) -> int:
        return self.stacks[0].effects.shape[-1]


def problem_of(frame: Frame, effects: Effects) -> Problem:
    """Of columns `person`, `side`, `session`, `value` and `error`, and the fixed effects of each
    row. Errors count where all are known; where one is not, scatter alone tells them.

    **Raises** `NotTold` (why) where values do not vary, or effects cannot be told apart.
    """
    value = frame["value"].to_numpy(float)
    scale = float(value.std())
    if not scale > np.finfo(float).eps * float(np.abs(value).max(initial=0.0)) * 8:
        raise NotTold("The values do not vary.")
    if np.linalg.matrix_rank(effects) < effects.shape[1]:
        raise NotTold("Groups and covariates cannot be told apart in this study.")
    error = frame["error"].to_numpy(float)
    known = np.square(error / scale) if np.isfinite(error).all() else np.zeros_like(value)
    levels = levels_of(frame)
    origin = float(value.mean())
    columns = ((value - origin) / scale, effects, known)
    stacks = tuple(stack_of(frame, columns, levels, rows) for rows in equally_many(frame))
    return Problem(stacks, tuple(levels), origin, scale)


def levels_of(frame: Frame) -> dict[str, Codes]:
    """Who shares each level; a level that parts the values as one before it does is left out."""
    each = {name: frame.groupby(keys).ngroup().to_numpy() for name, keys in LEVELS.items()}
    each[DROP] = np.arange(len(frame))
    kept: dict[str, Codes] = {}
    for name, codes in each.items():
        if not any(same_parting(codes, other) for other in kept.values()):
            kept[name] = codes
    return kept


def same_parting(one: Codes, other: Codes) -> bool:
    both = np.unique(np.stack([one, other]), axis=1).shape[1]
    return both == len(np.unique(one)) == len(np.unique(other))


def equally_many(frame: Frame) -> list[Int[np.ndarray, " chosen"]]:
    """Rows of people who have equally many values, person by person."""
    order = np.argsort(frame["person"].to_numpy(str), kind="stable")
    counts = frame["person"].map(frame["person"].value_counts()).to_numpy()[order]
    return [order[counts == count] for count in np.unique(counts)]


def stack_of(
    frame: Frame,
    columns: tuple[Rows, Effects, Rows],
    levels: Mapping[str, Codes],
    rows: Int[np.ndarray, " chosen"],
) -> Stack:
    shape = (frame["person"].iloc[rows].nunique(), -1)
    value, effects, known = (each[rows] for each in columns)
    codes = np.stack([codes[rows].reshape(shape) for codes in levels.values()])
    same = (codes[..., :, None] == codes[..., None, :]).astype(float)
    return Stack(
        rows.reshape(shape),
        value.reshape(shape),
        effects.reshape(*shape, effects.shape[1]),
        known.reshape(shape),
        same,
    )
