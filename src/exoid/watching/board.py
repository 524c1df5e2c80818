"""What is shown of a leg that is watched: written by who follows it, read by panel and page."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

from exoid.watching.beside.goals import Goal
from exoid.watching.beside.next_movement import Advice
from exoid.watching.beside.refinement import Refined
from exoid.watching.estimate.gyro_off import GyroOff
from exoid.watching.estimate.left_out import LeftOut
from exoid.watching.estimate.moment import Moment

MOST = 600  # points of the history; of more, every second one is dropped


@dataclass(frozen=True)
class Ended:
    """A drop that has ended, with a weight [kg] on the leg, and what was known then; it counts
    until a time [s].
    """

    weight: float
    moment: Moment
    until: float


@dataclass(frozen=True)
class Weight:
    """A weight that can be put on and taken off, and what tells that it was."""

    words: str
    on: Callable[[], bool]
    turn: Callable[[], None]


@dataclass
class Board:
    """The latest of everything. Each field is replaced as a whole, so that no lock is needed."""

    goals: Sequence[Goal] = ()
    state: str = "starting"  # then "following", "ended", or "failed"
    over: str = ""  # that a file has no more, in words
    fault: BaseException | None = None
    spoiled: str | None = None  # why nothing of the stream can be believed
    filtered: bool = False
    moment: Moment | None = None
    reached: bool = False
    movements: tuple[Ended | LeftOut, ...] = ()  # as it became clear what each of them was
    advice: Advice | None = None
    refined: Refined | None = None
    unrefined: str | None = None  # why no fit was made
    weight: Weight | None = None
    stream: str = ""  # how the frames come, in words
    silent: float = 0.0  # s since the last sample
    history: list[Moment] = field(default_factory=list)
    number: int = 0  # of the changes so far

    @property
    def ended(self) -> list[Ended]:
        """The drops on which the numbers rest: of this leg, and none that was taken back."""
        found: list[Ended] = []
        for each in self.counted:
            found = [*found[: each.moment.drops - 1], each]
        return found

    @property
    def counted(self) -> list[Ended]:
        """The drops of any leg, but for those that were taken back."""
        left = {each.begun for each in self.left_out}
        drops = (each for each in self.movements if isinstance(each, Ended))
        return [each for each in drops if each.moment.begun not in left]

    @property
    def left_out(self) -> list[LeftOut]:
        return [each for each in self.movements if isinstance(each, LeftOut)]

    @property
    def gyro(self) -> GyroOff | None:
        """How the gyro differs from the encoder, where it did in a movement that strayed."""
        return next((each.gyro for each in self.left_out if each.gyro is not None), None)

    @property
    def falls_astray(self) -> bool:
        """Did the leg stray in first falls alone? So it does where a hand lets go of it slowly, or
        a muscle leads it.
        """
        return bool(self.left_out) and all(each.falling for each in self.left_out)

    def show(self, moment: Moment) -> None:
        """A new moment."""
        self.moment = moment
        history = [*self.history, moment]
        self.history = history if len(history) <= MOST else history[::2]
        self.number += 1
