"""Where many fits meet: each goes on until it asks a program, and one run then answers several.

A fit is a few runs of a program with much to decide in between. Fits that take turns ask the same
program at about the same time, and lanes of several recordings fill one run of it.
"""

from collections.abc import Callable, Sequence
from contextvars import ContextVar, copy_context
from dataclasses import dataclass
from queue import SimpleQueue
from threading import Thread
from typing import Any, Generic, TypeVar

Result = TypeVar("Result")

PROGRAM = "exoid.fitting.solve.program"
SOLVE, SENSE = f"{PROGRAM}:solve", f"{PROGRAM}:sense_all"
ASKED_TOGETHER = (SOLVE, SENSE)  # programs that can answer several at once


@dataclass(frozen=True, eq=False)
class Question:
    """What a fit asks of a program."""

    name: str
    arguments: tuple
    static: Any
    structure: Any


class Guest(Generic[Result]):
    """A task on a thread of its own, which moves only while it is its turn."""

    def __init__(self, task: Callable[[], Result]):
        self.task = task
        self.answers, self.said = SimpleQueue(), SimpleQueue()
        context = copy_context()
        self.thread = Thread(target=context.run, args=(self.work,), daemon=True)
        self.thread.start()

    def work(self) -> None:
        MEETING.set(self)
        self.answers.get()
        try:
            self.said.put((True, self.task()))
        except Exception as fault:
            self.said.put((True, fault))

    def ask(self, *question) -> Any:
        """The answer to a question, once the meeting has it."""
        self.said.put((False, Question(*question)))
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

    `answer` is given all that is asked, and answers some of it, by its number.
    """
    guests = [Guest(task) for task in tasks]
    asked = {at: guest.go_on() for at, guest in enumerate(guests)}
    while waiting := {at: each for at, each in asked.items() if each is not None}:
        numbers = list(waiting)
        for at, one in answer(list(waiting.values())).items():
            asked[numbers[at]] = guests[numbers[at]].go_on(one)
    return [guest.result for guest in guests]
