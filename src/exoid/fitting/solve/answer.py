"""One run of a program for what many fits ask of it."""

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import jax
import numpy as np

from exoid.fitting.model.coordinates import take
from exoid.fitting.solve.meeting import PROGRAM, SOLVE, Question
from exoid.fitting.solve.program_cache import called

# Lanes of a run, each with its own recording: more leave the fast path of the compiled loop, and a
# run ends when its slowest lane has.
LANES = 8
COARSENESS = 2.0  # times the steps of the shortest that one run simulates for all


def answer(asked: Sequence[Question]) -> dict[int, Any]:
    """The answers to the largest group of questions that one program has the answer to.

    The others wait: more may come to ask the same.
    """
    groups: dict[Any, list[int]] = {}
    for at, each in enumerate(asked):
        groups.setdefault(kind(each), []).append(at)
    chosen = max(groups.values(), key=len)
    each = [asked[at] for at in chosen]
    found = solved(each) if each[0].name == SOLVE else sensed(each)
    return dict(zip(chosen, found, strict=True))


def kind(question: Question) -> tuple:
    """Questions of one kind can be answered by one run."""
    alike = question.arguments[1:] if question.name != SOLVE else question.arguments[2:]
    of_start = question.arguments[:2] if question.name == SOLVE else question.arguments[:1]
    leaves, structure = jax.tree.flatten((of_start, alike))
    own = [np.shape(leaf)[question.name == SOLVE :] for leaf in jax.tree.leaves(of_start)]
    shapes = (*own, *map(np.shape, jax.tree.leaves(alike)))
    reach = int(np.log(max(steps_of(question), 1)) / np.log(COARSENESS))
    return question.name, structure, shapes, question.static, reach


def steps_of(question: Question) -> int:
    stage = question.arguments[6].stage if question.name == SOLVE else question.arguments[4]
    return int(stage.steps)


def solved(asked: Sequence[Question]) -> list[Any]:
    """Of every question, where its starts end."""
    lanes = [(at, row) for at, one in enumerate(asked) for row in range(starts_of(one))]
    steps = np.asarray(max(map(steps_of, asked)))
    parts = []
    for first in range(0, len(lanes), LANES):
        own = np.resize(np.arange(first, min(first + LANES, len(lanes))), LANES)
        chosen = [lanes[number] for number in own]
        given = [take(asked[at].arguments[:2], row) for at, row in chosen]
        starts, requests = stacked(given)
        each = stacked([asked[at].arguments[2:] for at, _ in chosen])
        made = called(
            f"{PROGRAM}:solve_many",
            (starts, requests, each, steps),
            asked[0].static,
            asked[0].structure,
        )
        parts.append(made)
    whole = jax.tree.map(lambda *every: np.concatenate(every), *parts)
    rows = np.cumsum([0, *map(starts_of, asked)])
    return [
        jax.tree.map(lambda leaf, a=a, b=b: leaf[a:b], whole)
        for a, b in zip(rows[:-1], rows[1:], strict=True)
    ]


def starts_of(question: Question) -> int:
    return question.arguments[0].log_mass.shape[0]


def sensed(asked: Sequence[Question]) -> list[Any]:
    """Of every question, the sensitivities at its point."""
    steps = np.asarray(max(map(steps_of, asked)))
    found = []
    for first in range(0, len(asked), LANES):
        own = list(asked[first : first + LANES])
        each = stacked([one.arguments for one in (own * LANES)[:LANES]])
        made = called(
            f"{PROGRAM}:sense_many", (each, steps), asked[0].static, asked[0].structure
        )
        found += [take(made, at) for at in range(len(own))]
    return found


def stacked(trees: Sequence[Any]) -> Any:
    return jax.tree.map(lambda *every: np.stack(every), *trees)
