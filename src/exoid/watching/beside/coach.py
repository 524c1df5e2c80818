"""Looks for the movement that would tell most next, beside the stream, by the newest belief."""

from concurrent.futures import Future, ThreadPoolExecutor

from exoid.watching.beside.next_movement import Advice, Beliefs, Wish, advise
from exoid.watching.estimate.load import Mass


class Coach:
    """Is asked between drops; `latest` is the answer to the last question, once there is one.

    One thread asks, another one looks.
    """

    def __init__(self, wish: Wish):
        self.wish = wish
        self.pool = ThreadPoolExecutor(1)
        self.running: Future[Advice] | None = None
        self.waiting: tuple[Beliefs, Mass, float] | None = None
        self.answer: Advice | None = None  # to the last question that was answered

    @property
    def latest(self) -> Advice | None:
        """An answer from before the last drop would be of errors that it has narrowed."""
        asked = self.waiting is not None or self.running is not None
        return None if asked else self.answer

    def ask(self, beliefs: Beliefs, now: Mass, after: float) -> None:
        """What to do with the weight `now` on the leg, after the time `after` [s]."""
        self.waiting = beliefs, now, after

    def look(self) -> None:
        """Take what is done, and begin what waits."""
        if self.running is not None and self.running.done():
            if self.running.exception() is None:  # a belief of which nothing can be made
                self.answer = self.running.result()
            self.running = None
        if self.running is None and self.waiting is not None:
            beliefs, now, after = self.waiting
            self.waiting = None
            self.running = self.pool.submit(advise, beliefs, self.wish, now, after)

    @property
    def busy(self) -> bool:
        """Is anything left to answer?"""
        return self.running is not None or self.waiting is not None

    def close(self) -> None:
        """Nothing is asked any more."""
        self.waiting = None
        self.pool.shutdown(wait=False, cancel_futures=True)
