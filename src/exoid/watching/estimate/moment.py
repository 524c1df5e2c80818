"""What is known of a leg at a moment of its stream."""

from collections.abc import Callable
from dataclasses import dataclass
from math import inf

from exoid.online.model.trust import Phase, Trust

# With these a number that looks sure may be wrong: none is told.
UNBELIEVABLE = (Trust.UNEXPLAINED, Trust.FAULTY)


@dataclass(frozen=True)
class Quantity:
    """A value with its standard error, both in `unit`, and how much more that is for a spring slack
    elsewhere than at full extension, where it is as much as the error.
    """

    name: str
    value: float
    error: float
    unit: str
    if_slack: float | None = None


@dataclass(frozen=True)
class Unlike:
    """J / (m l) of a limb by its motion, and what is expected of its body [m]."""

    length: float
    expected: float
    scatter: float


@dataclass(frozen=True)
class Misplaced:
    """An added mass that is declared at a distance from the knee, and swings as one at another [m];
    is it so far off that hardly one in a thousand is?
    """

    declared: float
    acts: float
    strange: bool


@dataclass(frozen=True)
class Change:
    """From a time [s] on the numbers rest on other drops: so many before told `before` of the leg
    as it swung.
    """

    since: float
    drops: int
    before: tuple[Quantity, ...]
    another: bool = False  # by more than a leg differs from drop to drop


@dataclass(frozen=True)
class Moment:
    """Motion, phase and trust, and the quantities, of which none is told that cannot be believed.

    `ratios` are of the bare leg at this moment, `as_loaded` of the leg as it swings; `others` (J
    where a known mass or torque tells it, terms) of the end of the last drop.
    """

    time: float  # s, on the stream's clock
    angle: float  # rad, of the encoder
    angular_velocity: float  # rad/s
    phase: Phase
    trust: Trust
    drops: int  # on which the numbers rest
    ratios: tuple[Quantity, ...]
    as_loaded: tuple[Quantity, ...]
    others: tuple[Quantity, ...] = ()
    begun: float = -inf  # s, when the last free movement began, whether it counted or not
    unlike: Unlike | None = None  # where it moves as no leg of its body does
    misplaced: Misplaced | None = None  # where what is on it moves as hardly any that hangs there
    change: Change | None = None  # until the end of the first drop of other numbers

    @property
    def believed(self) -> bool:
        return self.trust not in UNBELIEVABLE

    @property
    def quantities(self) -> dict[str, Quantity]:
        """By name; none where none can be believed."""
        return {each.name: each for each in (*self.ratios, *self.others)} if self.believed else {}


Sink = Callable[[Moment], None]  # who is told of every moment
