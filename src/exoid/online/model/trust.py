"""How far to believe what is estimated, and what the leg is doing: as words, one number each."""

from enum import IntEnum


class Trust(IntEnum):
    """How far the estimates can be believed."""

    WAITING = 0
    LEARNING = 1
    GOOD = 2
    ENOUGH = 3
    UNEXPLAINED = 4
    CHANGED = 5
    FAULTY = 6

    @property
    def words(self) -> str:
        """What a person is told."""
        return WORDS[self]


WORDS = {
    Trust.WAITING: "waiting for a free movement",
    Trust.LEARNING: "learning: the errors are still large",
    Trust.GOOD: "good: gravity over inertia is known to 1 %",
    Trust.ENOUGH: "enough: another drop would hardly change a thing",
    Trust.UNEXPLAINED: "the model does not explain the movement",
    Trust.CHANGED: "the leg has changed, and is learned anew",
    Trust.FAULTY: "the stream is faulty: frames are lost, doubled, frozen or of another clock",
}


class Phase(IntEnum):
    """What the leg is doing."""

    HELD = 0  # in a hand, or nothing is known yet
    WAITING = 1  # at rest, so that a release would be seen
    MOVING = 2  # freely, as far as anybody can tell
    DONE = 3  # it came to rest or was caught
