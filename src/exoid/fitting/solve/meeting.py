"""Where many fits meet: each goes on until it asks the solver, and one run then answers several.

A fit is a few runs of the solver with much to decide in between. Fits that take turns ask it at
about the same time, and lanes of several recordings fill one run of it.
"""

from collections.abc import Callable, Sequence
from contextvars import ContextVar, copy_context
from queue import SimpleQueue
from threading import Thread
from typing import Any, Generic, TypeVar

import jax
import numpy as np

Result = TypeVar("Result")

PROGRAM = "exoid.fitting.solve.program"
SOLVE = f"{PROGRAM}:solve"  # the program that can answer several at once
OF_START = 2  # arguments of it that are of every start


class Question:
    """What a fit asks of SOLVE; those of one `kind` can be answered by one run."""

    def __init__(self, arguments: tuple, static: Any, structure: Any):
        self.static, self.structure = static, structure
        leaves, self.given = jax.tree.flatten(arguments)
        self.leaves = [np.asarray(leaf) for leaf in leaves]
        self.lane_leaves = len(jax.tree.leaves(arguments[:OF_START]))
        self.starts = len(self.leaves[0])
        self.steps = int(arguments[6].stage.steps)
        self.segments = len(arguments[2].time)
        shapes = [
            leaf.shape[1:] if at < self.lane_leaves else leaf.shape
            for at, leaf in enumerate(self.leaves)
        ]
        # A run goes over the most steps of all that it answers: those with half as many wait.
        self.kind = self.given, tuple(shapes), static, self.steps.bit_length()


class Guest(Generic[Result]):
    """A task on a thread of its own, which moves only while it is its turn."""

    def __init__(self, task: Callable[[], Result]):
        self.task = task
        self.answers, self.said = SimpleQueue(), SimpleQueue()
        self.thread = Thread(target=copy_context().run, args=(self.work,), daemon=True)
        self.thread.start()

    def work(self) -> None:
        MEETING.set(self)
        self.answers.get()
        try:
            self.said.put((True, self.task()))
        except Exception as fault:
            self.said.put((True, fault))

    def ask(self, arguments: tuple, static: Any, structure: Any) -> Any:
        """The answer of SOLVE, once the meeting has it, or the exception that it ends with."""
        self.said.put((False, Question(arguments, static, structure)))
        answer = self.answers.get()
        if isinstance(answer, Exception):
            raise answer
        return answer

    def go_on(self, answer: Any = None) -> Question | None:
        """Its next question; None where it has ended, with its `result`."""
        self.answers.put(answer)
        ended, said = self.said.get()
        if not ended:
            return said
        self.thread.join()
        self.result: Result | Exception = said
        return None


MEETING: ContextVar[Guest | None] = ContextVar("MEETING", default=None)


def meet(
    tasks: Sequence[Callable[[], Result]],
    answer: Callable[[Sequence[Question]], dict[int, Any]],
) -> list[Result | Exception]:
    """What every task returns, or the exception that it ends with.

    `answer` is given all that is asked, and answers some of it, by its number there.
    """
    guests = [Guest(task) for task in tasks]
    asked = {at: guest.go_on() for at, guest in enumerate(guests)}
    while waiting := {at: each for at, each in asked.items() if each is not None}:
        numbers = list(waiting)
        try:
            answers = answer(list(waiting.values()))
        except Exception as fault:  # nobody is left waiting for ever
            for at in numbers:
                while guests[at].go_on(fault) is not None:
                    pass
            raise
        for at, one in answers.items():
            asked[numbers[at]] = guests[numbers[at]].go_on(one)
    return [guest.result for guest in guests]
