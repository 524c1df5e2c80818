"""Own cases diagnosed on all cores, a process for each."""

from collections.abc import Iterator
from multiprocessing import get_context

import jax

from exoid.fitting.solve.program_cache import keep_programs_in

from .answer import Answer, ask
from .deck import Card
from .sets import Blind, own

TASKS = 15  # of a process: its compiled programs would fill the memory


def diagnosed_cases(
    cards: list[tuple[int, Card]], seed: int, workers: int | None = None
) -> Iterator[tuple[Blind, Answer]]:
    """The case of every numbered card and the answer to it, in order."""
    asked = [(card, seed, number) for number, card in cards]
    with get_context("spawn").Pool(workers, initializer=set_up, maxtasksperchild=TASKS) as pool:
        yield from pool.imap(diagnosed, asked)


def diagnosed(asked: tuple[Card, int, int]) -> tuple[Blind, Answer]:
    card, seed, number = asked
    case = own(card, seed, number)
    return case, ask(case.name, case.load, case.truth, seed)


def set_up() -> None:
    jax.config.update("jax_enable_x64", True)
    keep_programs_in()
