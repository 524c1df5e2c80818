"""One run of the solver for what many fits ask of it."""

from collections.abc import Sequence
from typing import Any

import jax
import numpy as np

from exoid.fitting.solve.meeting import PROGRAM, Question
from exoid.fitting.solve.program_cache import called

# Lanes of a run, each with its own recording, and their segments at once: more leave the fast path
# of the compiled loop, and a run ends when its slowest lane has.
LANES, SEGMENTS = 32, 32


def answer(asked: Sequence[Question]) -> dict[int, Any]:
    """The answers to the largest group of questions that one program has the answer to.

    The others wait: more may come to ask the same.
    """
    groups: dict[Any, list[int]] = {}
    for at, each in enumerate(asked):
        groups.setdefault(each.kind, []).append(at)
    chosen = max(groups.values(), key=len)
    each = [asked[at] for at in chosen]
    return dict(zip(chosen, solved(each), strict=True))


def solved(asked: Sequence[Question]) -> list[Any]:
    """Of every question, where its starts end."""
    starts = [one.starts for one in asked]
    ends, owner = np.cumsum(starts), np.repeat(np.arange(len(asked)), starts)
    begins, steps = ends - starts, np.asarray(max(one.steps for one in asked))
    parts = []
    for lanes in filled(np.arange(owner.size), lanes_of(asked)):
        first, last = owner[lanes[[0, -1]]].tolist()
        leaves = laned(asked[first : last + 1], lanes - begins[first], owner[lanes] - first)
        arguments = jax.tree.unflatten(asked[0].given, leaves), steps
        program = f"{PROGRAM}:solve_many", arguments, asked[0].static, asked[0].structure
        parts.append(jax.tree.leaves(called(*program)))
    whole = [np.concatenate(each) for each in zip(*parts, strict=True)]
    return [
        jax.tree.unflatten(asked[0].structure, [leaf[begin:end] for leaf in whole])
        for begin, end in zip(begins.tolist(), ends.tolist(), strict=True)
    ]


def laned(asked: Sequence[Question], rows: np.ndarray, owner: np.ndarray) -> list[np.ndarray]:
    """The arguments of lanes: these rows of all their starts, and what is shared by the starts of
    the question that each is of.
    """
    columns = zip(*(one.leaves for one in asked), strict=True)
    return [
        np.concatenate(each)[rows] if at < asked[0].lane_leaves else np.stack(each)[owner]
        for at, each in enumerate(columns)
    ]


def lanes_of(asked: Sequence[Question]) -> int:
    return max(1, min(LANES, SEGMENTS // asked[0].segments))


def filled(each: np.ndarray, lanes: int) -> list[np.ndarray]:
    """So many at a time, the last again where there are fewer."""
    size = -(-each.size // lanes)
    return list(np.pad(each, (0, size * lanes - each.size), "edge").reshape(size, lanes))
