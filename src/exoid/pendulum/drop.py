"""Drops with the measures that were read off them, and their average."""

from dataclasses import dataclass
from math import hypot
from typing import Any

from exoid.pendulum import summary
from exoid.recordings.landmarks.landmarks import Landmarks
from exoid.recordings.landmarks.measure import Measure
from exoid.recordings.landmarks.swing import Curve
from exoid.recordings.landmarks.track import SURE
from exoid.recordings.measured.segment import Segment


@dataclass(frozen=True, eq=False)
class Drop:
    """A segment with what could be read off it; without measures where it is refused whole."""

    name: str  # of the recording, where there are several, and the segment's number in it
    segment: Segment
    added_mass: float  # kg
    measures: dict[str, Measure]
    landmarks: Landmarks | None  # None where it is refused whole
    reason: str | None = None
    note: str | None = None  # what its errors do not hold
    halt: str | None = None  # in its first swing
    drift: float = 0.0  # rad/s, of the angle's sensor, less which it was read
    thigh_angle: float = 0.0  # rad, the knee above the hip, as declared

    @property
    def measured(self) -> bool:
        """Could anything be read off it?"""
        return any(each.value is not None for each in self.measures.values())

    @property
    def ends_above(self) -> bool:
        """Does its first flexion end above its lowest angle, as where a reflex turns it?"""
        flexions = [] if self.landmarks is None else self.landmarks.turns[::2]
        if len(flexions) < 2:
            return False
        first, lowest = flexions[0], min(flexions[1:], key=lambda one: one.value)
        return first.value - lowest.value > SURE * hypot(first.error, lowest.error)

    @property
    def curve(self) -> Curve | None:
        """Angle and its derivatives from the release on, worked out when first asked for; None
        where it is refused whole.
        """
        return None if self.landmarks is None else self.landmarks.curve


@dataclass(frozen=True)
class Average:
    """The mean over drops, and their scatter."""

    name: str
    title: str
    symbol: str
    unit: str
    mean: float
    standard_deviation: float | None  # None of a single drop
    drops: tuple[str, ...]  # that it was read off


@dataclass(frozen=True, eq=False, repr=False)
class PendulumTest:
    """The drops of one leg. `average` is over those with the least added mass.

    >>> test = exoid.measure_drops("drops.csv")
    >>> len(test.drops), test.left_out
    (2, [])
    """

    drops: list[Drop]
    average: dict[str, Average]
    left_out: list[str]  # drops with another added mass

    def __repr__(self) -> str:
        return summary.lines(self)

    def _repr_html_(self) -> str:
        return summary.page(self)

    def to_dataframe(self) -> Any:
        """Every measure of every drop for pandas: a row each, with error, unit and reason."""
        return summary.frame(self)
