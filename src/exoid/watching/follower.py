"""A thread that follows a leg: readings go in as they come, and what is known appears on a board.

Reading a bus must wait for nothing, and the estimator takes seconds to load where it is compiled.
"""

from collections.abc import Callable, Sequence
from queue import Queue
from threading import Thread

from exoid.online.model.trust import Phase
from exoid.recordings.live.decoding.reading import Reading
from exoid.watching.beside.coach import Coach
from exoid.watching.beside.goals import reached
from exoid.watching.beside.refinement import Refinement
from exoid.watching.board import Board, Ended
from exoid.watching.estimate.left_out import LeftOut
from exoid.watching.estimate.leg import Leg, LegDrop
from exoid.watching.estimate.moment import Moment, Sink


class Follower:
    """Gives `sinks` every moment, in order. Where the goals are reached, it looks at nothing more.

    Of readings that are given faster than they are taken in, `most` batches wait; then `give` does.
    """

    def __init__(
        self,
        make: Callable[[], "Company"],
        board: Board,
        sinks: Sequence[Sink] = (),
        most: int = 0,
    ):
        self.make, self.board, self.sinks = make, board, sinks
        self.queue: Queue[list[Reading] | None] = Queue(most)
        self.company: Company | None = None
        self.thread = Thread(target=self.run, daemon=True)
        self.thread.start()

    def give(self, readings: list[Reading]) -> None:
        if readings:
            self.queue.put(readings)

    def end(self, patience: float | None = None) -> None:
        """No more will come: wait until all is taken in, or for so long [s]."""
        self.queue.put(None)
        self.thread.join(patience)

    def run(self) -> None:
        try:
            self.company = self.make()
            self.board.state = "following"
            while (readings := self.queue.get()) is not None:
                self.follow(readings)
            self.board.state = "ended"
        except BaseException as fault:
            self.board.fault, self.board.state = fault, "failed"
            while self.queue.get() is not None:  # who gives must not wait for ever
                pass

    def follow(self, readings: list[Reading]) -> None:
        """What these readings tell, up to the end of the drop with which the goals are reached."""
        assert self.company is not None
        if self.board.reached:
            return
        for news in self.company.leg.take(readings):
            if isinstance(news, LegDrop):
                self.ended(news)
            elif isinstance(news, LeftOut):
                self.left_out(news)
            elif self.board.reached:
                return
            else:
                self.told(news)

    def told(self, moment: Moment) -> None:
        self.board.reached = reached(self.board.goals, moment)
        self.board.show(moment)
        for sink in self.sinks:
            sink(moment)

    def left_out(self, left: LeftOut) -> None:
        """A movement does not count, or no longer."""
        assert self.company is not None
        self.board.movements = (*self.board.movements, left)
        if self.company.refinement is not None:
            self.company.refinement.leave_out(left)

    def ended(self, drop: LegDrop) -> None:
        """A drop has ended: what to do next, and what the batch fit says, is found beside this."""
        assert self.company is not None
        ended = Ended(drop.mass.weight, drop.moment, drop.until)
        self.board.movements = (*self.board.movements, ended)
        if self.board.reached:
            return
        if self.company.coach is not None:
            self.company.coach.ask(drop.beliefs, drop.mass, drop.moment.time)
        if self.company.refinement is not None:
            self.company.refinement.add(drop)


class Company:
    """A leg that is followed, with who helps: in the background, or not at all."""

    def __init__(self, leg: Leg, coach: Coach | None = None, refinement: Refinement | None = None):
        self.leg, self.coach, self.refinement = leg, coach, refinement
        if coach is not None:
            coach.ask(leg.beliefs, leg.now, 0.0)

    def ask_anew(self, moment: Moment) -> None:
        """What to do next is found for what is known at the end of a stream, amid a movement."""
        if self.coach is not None and moment.phase is Phase.MOVING:
            self.coach.ask(self.leg.beliefs, self.leg.now, moment.time)

    def look(self, board: Board) -> None:
        """Put on the board what was found meanwhile."""
        if self.coach is not None:
            self.coach.look()
            board.advice = self.coach.latest
        if self.refinement is not None:
            self.refinement.look()
            board.refined, board.unrefined = self.refinement.latest, self.refinement.failed

    @property
    def fits(self) -> bool:
        """Is the batch fit still made?"""
        return self.refinement is not None and self.refinement.busy

    @property
    def busy(self) -> bool:
        """Is anything that was asked still looked for?"""
        return any(each is not None and each.busy for each in (self.coach, self.refinement))

    def close(self) -> None:
        for each in (self.coach, self.refinement):
            if each is not None:
                each.close()
