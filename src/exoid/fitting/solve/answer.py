"""One run of a program for what many fits ask of it."""

from collections.abc import Iterator, Sequence
from typing import Any

import jax
import numpy as np

from exoid.fitting.solve.meeting import PROGRAM, SOLVE, Question
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
    found = solved(each) if each[0].name == SOLVE else reduced(each)
    return dict(zip(chosen, found, strict=True))


def solved(asked: Sequence[Question]) -> list[Any]:
    """Of every question, where its starts end."""
    lanes = [(one, row) for one in asked for row in range(one.starts)]
    own = asked[0].lane_leaves
    parts = []
    for chosen in filled(lanes, lanes_of(asked)):
        columns = zip(*(one.leaves for one, _ in chosen), strict=True)
        rows = [row for _, row in chosen]
        leaves = [
            np.stack([leaf[row] for leaf, row in zip(column, rows, strict=True)])
            if at < own
            else np.stack(column)
            for at, column in enumerate(columns)
        ]
        parts.append(answered("solve_many", asked, leaves))
    whole = jax.tree.map(lambda *every: np.concatenate(every), *parts)
    leaves, structure = jax.tree.flatten(whole)
    ends = np.cumsum([one.starts for one in asked])
    each = zip(*(np.split(leaf[: ends[-1]], ends[:-1]) for leaf in leaves), strict=True)
    return [jax.tree.unflatten(structure, one) for one in each]


def reduced(asked: Sequence[Question]) -> list[Any]:
    """Of every question, the triangles at its point."""
    found: list[Any] = []
    lanes = lanes_of(asked)
    for chosen in filled(asked, lanes):
        leaves = map(np.stack, zip(*(one.leaves for one in chosen), strict=True))
        made = answered("triangles_many", asked, leaves)
        found += [jax.tree.map(lambda leaf, at=at: leaf[at], made) for at in range(lanes)]
    return found[: len(asked)]


def lanes_of(asked: Sequence[Question]) -> int:
    return max(1, min(LANES, SEGMENTS // asked[0].segments))


def filled(each: Sequence[Any], lanes: int) -> Iterator[list[Any]]:
    """So many at a time, the last again where there are fewer."""
    for first in range(0, len(each), lanes):
        own = list(each[first : first + lanes])
        yield own + own[-1:] * (lanes - len(own))


def answered(program: str, asked: Sequence[Question], leaves) -> Any:
    """One run, over the most steps that anybody asks for."""
    first, steps = asked[0], np.asarray(max(one.steps for one in asked))
    arguments = jax.tree.unflatten(first.given, list(leaves))
    return called(f"{PROGRAM}:{program}", (arguments, steps), first.static, first.structure)
