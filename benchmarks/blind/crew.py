"""Own cases diagnosed on all cores, a process for each."""

import os
from collections.abc import Iterator
from concurrent.futures import ProcessPoolExecutor
from multiprocessing import get_context

import jax

from exoid.fit.program import keep_programs_in

from .answer import Answer, ask
from .deck import Card
from .sets import Blind, own

TASKS = 15  # of a process: its compiled programs would fill the memory


def diagnosed_cases(cards: list[Card], seed: int) -> Iterator[tuple[Blind, Answer]]:
    """Every card's case and the answer to it, in order."""
    context = get_context("spawn")
    with ProcessPoolExecutor(os.cpu_count(), context, set_up, max_tasks_per_child=TASKS) as pool:
        yield from pool.map(diagnosed, cards, [seed] * len(cards), range(len(cards)))


def diagnosed(card: Card, seed: int, number: int) -> tuple[Blind, Answer]:
    case = own(card, seed, number)
    return case, ask(case.name, case.load, seed)


def set_up() -> None:
    jax.config.update("jax_enable_x64", True)
    keep_programs_in()
