"""A fitted joint as other tools take it: numbers with their origin, and formulas of its terms."""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from jaxtyping import Float

from exoid.fitting.data.observe import with_gaps_bridged
from exoid.fitting.data.pace import LONGEST_STEP
from exoid.interchange.formula.expression import ZERO, Expression
from exoid.physics.term import Term
from exoid.physics.torque import Torque

STILL = {
    "drive_amplitude": 0.0,
    "drive_period": 1.0,
    "drive_frequency": 0.0,
    "drive_onset": 0.0,
}  # of a drive that does nothing
STATE = ("time", "angle", "rate", "acceleration")  # what formulas hang on, beside a memory


@dataclass(frozen=True)
class Number:
    """A number of the model, with its error and who determined it."""

    name: str
    title: str
    symbol: str
    unit: str
    value: float
    error: float | None = None
    by: str | None = None  # data, prior, both, bound, or a user's hand
    if_slack: float | None = None  # error more, for a spring slack elsewhere than at full extension

    @property
    def origin(self) -> str:
        """Its errors, unit and who told it, as comments say it."""
        error = "" if self.error is None else f"± {self.error:.2g} "
        more = "" if self.if_slack is None else f"(± {self.if_slack:.2g} if slack) "
        return f"{error}{more}{self.unit}, {self.by or 'told by nothing: any that moves alike'}"

    @property
    def words(self) -> str:
        return f"{self.title}, {self.symbol} = {self.value:.6g} {self.origin}"


@dataclass(frozen=True, eq=False)
class Part:
    """A term of the model: its formulas by `angle`, `rate`, `time`, its memory and its numbers."""

    name: str
    title: str
    formula: str  # as its class writes it
    term: Term
    numbers: tuple[Number, ...]
    begun: Float[np.ndarray, " memory"]  # its memory where the motion begins
    torque: Expression = ZERO  # N m
    friction: Expression = ZERO  # N m, dry: holds a leg at rest and opposes one that moves
    rates: tuple[Expression, ...] = ()  # of its memory
    within: tuple[Expression, ...] = ()  # its memory, brought back to where it can be
    shown_angle: Expression = ZERO  # what the encoder shows beyond the angle
    shown_rate: Expression = ZERO  # and the gyro
    delay: Expression = ZERO  # s, of the gyro

    @property
    def values(self) -> dict[str, float]:
        return {each.name: each.value for each in self.numbers}

    @property
    def hangs_on(self) -> frozenset[str]:
        """What its torque and friction hang on: time, angle, rate, acceleration, memory."""
        names = self.torque.symbols | self.friction.symbols
        memory = {"memory"} if any(each.startswith(f"{self.name}_memory") for each in names) else ()
        return frozenset({each for each in STATE if each in names} | {*memory})

    @property
    def pushes(self) -> bool:
        """Does it act on the leg, and not on what sensors show alone?"""
        return self.torque.value != 0.0 or self.friction.value != 0.0

    @property
    def shows(self) -> bool:
        """Do the sensors show another motion for it?"""
        return any(each.value != 0.0 for each in (self.shown_angle, self.shown_rate, self.delay))


@dataclass(frozen=True)
class Sensing:
    """What encoder and gyro of the recording made of the motion."""

    zero: float = 0.0  # rad
    gyro_scale: float = 0.0  # relative, less 1
    gyro_bias: float = 0.0  # rad/s
    angle_noise: float = 0.0  # rad
    rate_noise: float | None = None  # rad/s


@dataclass(frozen=True, eq=False)
class Joint:
    """The leg of a fit with its terms, where it begins and what drives it, by the true clock."""

    title: tuple[str, ...]  # what was exported, in lines
    numbers: tuple[Number, ...]  # m, J, l, d, c of what turns
    gravity: Number  # m l g, known better than m and l
    ratios: tuple[Number, ...]  # that motion alone tells, the terms' among them
    thigh_angle: float  # rad
    parts: tuple[Part, ...]
    angle: float  # rad, where it begins
    rate: float  # rad/s
    drive: Torque
    drive_numbers: tuple[Number, ...]
    number: int  # of the segment, from 0
    times: Float[np.ndarray, " time"]  # s, of the fitted samples
    clock: float  # true seconds in a recorded one
    sensing: Sensing
    finer: int = 1  # parts of a step, in which the fit simulated it
    reach: tuple[float, float] = (-2.0, 0.0)  # rad, between which the fitted motion went
    astray: str | None = None

    @property
    def value(self) -> Mapping[str, float]:
        """The leg's numbers by name, `gravity` (m l g, N m) among them."""
        return {each.name: each.value for each in (*self.numbers, self.gravity)}

    @property
    def constants(self) -> dict[str, float]:
        """Every number that formulas name."""
        leg = dict(self.value)
        over = {
            f"{each}_over_inertia": leg[each] / leg["inertia"]
            for each in ("gravity", "stiffness", "damping")
        }
        terms = {name: value for part in self.parts for name, value in part.values.items()}
        drive = STILL | {each.name: each.value for each in self.drive_numbers}
        seat = {"thigh_angle": self.thigh_angle, "number": float(self.number)}
        return leg | over | seat | drive | terms

    @property
    def longest_step(self) -> float:
        """Of the fit [s]: samples that are farther apart are bridged by several."""
        return LONGEST_STEP * self.clock

    @property
    def edges(self) -> Float[np.ndarray, " edge"]:
        """Where the fit's steps begin and end [s]."""
        return with_gaps_bridged(self.times / self.clock) * self.clock

    @property
    def driven(self) -> bool:
        return bool(self.drive_numbers) or hasattr(self.drive, "torque")


@dataclass(frozen=True)
class Kept:
    """What became of one thing of the model."""

    what: str
    how: str  # exact, approximate, in words, none found
    where: str

    @property
    def cells(self) -> tuple[str, str, str]:
        return self.what, self.how, self.where


@dataclass(frozen=True)
class Exported:
    """A model in the words of another tool: the `text` of a file, and what became of each thing.

    >>> found = exoid.export(exoid.fit("drops.csv"), "urdf")
    >>> found.kept[0].what, found.kept[0].how
    ('leg', 'exact')
    """

    text: str
    kept: tuple[Kept, ...]
    warnings: tuple[str, ...] = ()

    def __repr__(self) -> str:
        return "\n".join("  ".join(each.cells) for each in self.kept)
