"""What an estimator is told before it sees a leg: terms, sensors, and how sure is sure."""

from dataclasses import dataclass, field
from math import pi, radians, sqrt

from exoid.fitting.model.systematics import CLOCK, SLANT, TILT
from exoid.online.model.unknowns import Unknowns

ENCODER_STEP = 2 * pi / 4096  # rad, of the AS5600
GYRO_STEP = radians(0.07)  # rad/s, of the LSM6DS3 at 2000 deg/s
RENEWAL = 1 / 833  # s between the LSM6DS3's samples, which the node reads at any age


@dataclass(frozen=True)
class Node:
    """One standard deviation of what a node's sensors do; the node's own by data sheet.

    What the samples scatter by beyond, or less, is learned from them.
    """

    angle_noise: float = radians(0.043)  # rad
    angle_step: float = ENCODER_STEP  # rad, that it counts
    velocity_noise: float = radians(7e-3) * sqrt(833 / 2)  # rad/s
    velocity_step: float = GYRO_STEP  # rad/s
    delay: float = RENEWAL / 2  # s, mean age of a gyro's sample
    delay_error: float = RENEWAL / 2  # s, of that mean
    # s, from sample to sample: a sawtooth, which averages out sooner than white noise
    delay_wander: float = RENEWAL / sqrt(12)
    # s in a second: of a gyro that renews itself 8.5 times a sample, every other one is as old, and
    # that age drifts
    delay_drift: float = RENEWAL / 6
    zero: float = radians(3.0)  # rad, what the encoder shows with the knee extended
    tilt: float = TILT  # rad, of a seat that looks level
    slant: float = SLANT  # rad, of the line to the centre of mass, where a foot puts it elsewhere
    bias: float = radians(5.0)  # rad/s, of the gyro
    scale: float = 0.015  # relative, of the gyro
    period: float = 0.01  # s between samples; more often is as well
    clock: float = CLOCK  # relative, of a quartz
    clock_declared: bool = False  # else it may be what encoder and gyro disagree by
    gyro: bool = True  # is there one? Else an angle alone is followed

    @property
    def variances(self) -> tuple[float, float]:
        """Of angle [rad^2] and rate [(rad/s)^2], with what reading them in steps adds."""
        angle = self.angle_noise**2 + self.angle_step**2 / 12
        return angle, self.velocity_noise**2 + self.velocity_step**2 / 12


@dataclass(frozen=True)
class Goals:
    """Standard errors of the three ratios from which on an estimate is good, and enough.

    Each is a share of m l g / J, for damping over the leg's own frequency: what counts in a swing.
    """

    good: float = 0.01
    enough: float = 0.003


@dataclass(frozen=True)
class Model:
    """What is estimated, by what sensors, and how surely.

    >>> online.Model().unknowns.names[0]
    'level_gravity'
    """

    unknowns: Unknowns = field(default_factory=Unknowns)
    node: Node = field(default_factory=Node)
    goals: Goals = field(default_factory=Goals)

    @property
    def curved(self) -> bool:
        """Do products of unknowns count? Those of a rate that no gyro shows and of the damping do:
        a filter that takes them for a line has c / J one to two of its errors too large by an
        angle at 25 Hz that scatters by 0.3 deg.
        """
        return self.unknowns.curved or not self.node.gyro
