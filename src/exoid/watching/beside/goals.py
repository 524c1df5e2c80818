"""How well is well enough: the standard error of a quantity, as a share of it or in its unit."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from math import inf
from types import MappingProxyType

from exoid.online.model.trust import Phase, Trust
from exoid.watching.estimate.moment import Moment

NOBODYS: Mapping[str, float] = MappingProxyType({})  # sizes, where none is expected
SURE = (Trust.LEARNING, Trust.GOOD, Trust.ENOUGH)  # of a leg that was seen moving


@dataclass(frozen=True)
class Goal:
    """A quantity, and the standard error that is wanted."""

    name: str
    wanted: float
    relative: bool  # to the value

    def __str__(self) -> str:
        return f"{self.name}={100 * self.wanted:g}%" if self.relative else self.text

    @property
    def text(self) -> str:
        return f"{self.name}={self.wanted:g}"

    @property
    def error(self) -> str:
        """The error that is wanted."""
        return f"{100 * self.wanted:g} %" if self.relative else f"{self.wanted:g}"

    def share(self, moment: Moment) -> float | None:
        """The error over the wanted one: 1 and less is enough. None where it is not known."""
        found = moment.quantities.get(self.name)
        if found is None:
            return None
        wanted = self.wanted * (abs(found.value) if self.relative else 1.0)
        return found.error / wanted if wanted > 0 else None


def reached(goals: Iterable[Goal], moment: Moment) -> bool:
    """Are all of them reached, by drops that have ended?"""
    sure = moment.trust in SURE and moment.drops > 0 and moment.phase is not Phase.MOVING
    shares = [goal.share(moment) for goal in goals]
    return sure and bool(shares) and all(each is not None and each <= 1.0 for each in shares)


def goal_of(text: str, names: Iterable[str], sizes: Mapping[str, float] = NOBODYS) -> Goal:
    """NAME=SHARE% or NAME=ERROR as a goal; `sizes` are about how large quantities are.

    **Raises** `ValueError` where it is neither, names no quantity, or is no smaller than that.
    """
    name, equals, wanted = (part.strip() for part in text.partition("="))
    if name not in names:
        raise ValueError(f"--until {text}: there is no {name!r}; it can be {', '.join(names)}.")
    try:
        number = float(wanted.removesuffix("%"))
        if not (equals and "_" not in wanted and 0 < number < float("inf")):
            raise ValueError
    except ValueError:
        raise ValueError(
            f"--until {text}: this is not like --until {name}=2% or --until {name}=0.01."
        ) from None
    relative = wanted.endswith("%")
    if number >= (100.0 if relative else sizes.get(name, inf)):
        raise ValueError(
            f"--until {text}: a standard error as large as {name} itself is no goal. Write "
            f"{name}={number:g}% for a share of it, or a smaller error in its unit."
            if not relative
            else f"--until {text}: a standard error as large as {name} itself is no goal."
        )
    return Goal(name, number / 100 if relative else number, relative)
