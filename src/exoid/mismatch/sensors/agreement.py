"""What encoder and gyro say of each other."""

from dataclasses import dataclass, field

import numpy as np

from exoid.mismatch.sensors.faults import BIAS as GYRO_BIAS
from exoid.mismatch.sensors.faults import SKEW, Fault
from exoid.mismatch.sensors.smooth import Reference
from exoid.physics.parameter import declarations
from exoid.physics.term import Term

BIAS, DELAY = GYRO_BIAS.name, SKEW.name
CLEAR = 25.0  # sum of squares that an error must explain to be one: 5 standard deviations


@dataclass(frozen=True, eq=False)
class SureError:
    """An error whose size the sensors surely tell among themselves."""

    fault: Fault
    values: np.ndarray

    @property
    def possible(self) -> bool:
        """May a sensor err so much? A thigh that moves can look like one that errs by more."""
        ranges = [(each.lower, each.upper) for _, each in declarations(self.fault.term)]
        return all(
            low < value < high for value, (low, high) in zip(self.values, ranges, strict=True)
        )


@dataclass(frozen=True, eq=False)
class Sure:
    """Errors that every model of the leg has, and sets of others that would do as well."""

    errors: tuple[SureError, ...] = ()
    alike: tuple[tuple[type[Term], ...], ...] = ()

    @property
    def faults(self) -> tuple[Fault, ...]:
        return tuple(one.fault for one in self.errors)

    @property
    def terms(self) -> tuple[type[Term], ...]:
        return tuple(one.fault.term for one in self.errors)


@dataclass(frozen=True)
class OwnValue:
    """An error as one segment has it by itself."""

    number: int  # of the segment
    value: float
    standard_error: float


@dataclass(frozen=True, eq=False)
class SensorError:
    """What the gyro does against the encoder."""

    name: str
    value: float
    standard_error: float
    unit: str
    own: list[OwnValue] = field(default_factory=list)  # of each segment, where these differ
    by_size: list[float] = field(default_factory=list)  # of large and of small swings, if apart

    @property
    def clear(self) -> bool:
        return self.value**2 > CLEAR * self.standard_error**2


@dataclass(frozen=True, eq=False)
class Consistency:
    """The sensors against each other, and the motion that they show together."""

    errors: list[SensorError]  # empty without a gyro
    references: list[Reference]
    sure: Sure = field(default_factory=Sure)

    @property
    def delay(self) -> float:
        """By which the gyro clearly is late [s], else 0."""
        known = [each.value for each in self.errors if each.name == DELAY and each.clear]
        return known[0] if known else 0.0
