"""A segment as it enters the fit: its channels, its extent, its clock, its noise."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from exoid.fitting.data.time_jitter import TimeJitter
from exoid.fitting.model.systematics import DECLARED_NOTHING, Systematics
from exoid.recordings.conventions.jumps import Jump, jumps
from exoid.recordings.declared.sensors import Sensors
from exoid.recordings.filter.constants import UNTOLD
from exoid.recordings.measured.samples import Samples
from exoid.recordings.measured.segment import Segment
from exoid.recordings.motion.extent import Extent
from exoid.recordings.remembered import remembered
from exoid.recordings.signal.local_line import local_line
from exoid.recordings.signal.noise import Noise

# A hand from the release on, or what acts on a leg once it is fast, as a reflex; or either. Where
# nothing keeps a leg back, a thrust in its first swing, or that or a spring; nothing where "alike".
KeptBack = Literal[
    "hand", "speed", "filtered", "neither", "thrust", "thrust or spring", "alike", "unknown"
]


@dataclass(frozen=True, eq=False)
class Movement:
    """A segment as it enters the fit: clipped, on its own clock, with its noise and its drive."""

    name: str  # of the recording, and the segment's number in it
    kind: str  # passive, active or measured
    kind_said: bool  # by the sidecar; otherwise it was taken from the shape of the motion
    segment: Segment
    angle: Samples  # rad, the channel that is fitted
    angular_velocity: Samples | None
    filtered: bool  # that channel went through the firmware's filter
    noise: Noise  # of the angle [rad]
    gyro_noise: Noise | None  # rad/s
    onset: float  # s, where the clock of Eq. 10 starts
    period: float  # s, of the cycle; nan where there is none
    added_mass: float  # kg
    added_mass_distance: float  # m, nan where it is to be estimated
    thigh_angle: float  # rad
    least_mass: float = 0.0  # kg, of all that are fitted together
    recording: int = 0  # of those that are fitted together
    session: str | None = None  # in all recordings of one the same seat and weights ...
    sensors: Sensors = field(default_factory=Sensors)  # ... and sensors, but where said otherwise
    extent: Extent | None = None  # how it began and ended; None where the whole segment is kept
    systematics: Systematics = DECLARED_NOTHING  # how well what is declared is known
    absent: tuple[str, ...] = ()  # what of Eq. 9 a rig does not have: gravity, stiffness
    gain_known: bool = True  # of the measured torque; else its unit is any
    late: int = 0  # samples from the first that weigh nothing, though nobody was seen to hold it
    slow: float = 0.0  # s that were left out behind its release: something kept the leg back ...
    kept_back: KeptBack = "unknown"  # ... which was this
    kept: int | None = None  # samples after which a hand holds it that only a fit has seen
    filter: str = UNTOLD  # which filter its filtered channels went through
    filter_told: bool = True  # and does the recording say so?
    filter_step: float | None = None  # s, by the filter's own clock; None: the time between samples
    divisor: float | None = None  # rad, of the angle's residuals; None: its noise
    angle_jitter: TimeJitter | None = None  # where the noise grows with speed
    gyro_jitter: TimeJitter | None = None
    rounds_alike: bool = False  # at rest a coarse encoder errs alike in all samples

    @cached_property
    def angle_noise(self) -> float:
        """Standard deviation of an angle sample [rad]."""
        if self.angle_jitter is None:
            return self.noise.level
        return self.angle_jitter.level(self.segment.time, self.angle)

    @property
    def residual_unit(self) -> float:
        """What a fit divides the angle's residuals by [rad]."""
        return self.angle_noise if self.divisor is None else self.divisor

    @cached_property
    def velocity_noise(self) -> float:
        """Standard deviation of a gyro sample [rad/s]; infinite without a gyro."""
        if self.gyro_noise is None or self.angular_velocity is None:
            return np.inf
        if self.gyro_jitter is None:
            return self.gyro_noise.level
        return self.gyro_jitter.level(self.segment.time, self.angular_velocity)

    @cached_property
    def jumps(self) -> list[Jump]:
        """Of its angle, which no leg makes; by the clock of the recording."""
        clock = self.segment.begins + self.segment.time
        return jumps(clock, self.angle, self.angular_velocity, self.angle_noise)

    @property
    def caught(self) -> float | None:
        """When a hand ended what is fitted of it, by the clock of the recording [s]; else None."""
        count = self.kept
        if count is None and self.extent is not None and self.extent.ended == "caught":
            count = self.extent.stop - self.extent.start
        time = self.segment.begins + self.segment.time
        whole = self.kept is None and count != time.size  # as the paper clips it, with the hand
        return None if count is None or whole else float(time[count - 1])

    @property
    def source(self) -> str:
        """The recording, by its name where there are several."""
        return self.name.rpartition(" ")[0] or "recording"

    @property
    def voluntary(self) -> bool:
        return self.kind == "active"

    @property
    def scaled(self) -> bool:
        """Does a known mass or torque act, so that this segment can tell the inertia?"""
        return self.kind == "measured" or self.added_mass > 0

    @property
    def unplaced(self) -> bool:
        """Is it unknown where the added mass sat?"""
        return self.added_mass > 0 and bool(np.isnan(self.added_mass_distance))

    @property
    def borne(self) -> float:
        """Its added mass beyond the least of all that are fitted together [kg]."""
        return max(self.added_mass - self.least_mass, 0.0)

    @property
    def load(self) -> tuple[float, float | None]:
        """The added mass [kg] and where it sat [m], None of none and where that is unknown."""
        placed = self.added_mass > 0 and not self.unplaced
        return self.added_mass, self.added_mass_distance if placed else None


def all_driven(movements: Sequence[Movement]) -> bool:
    """Was the torque of all of them measured?"""
    return all(each.kind == "measured" for each in movements)


def absent_of(movements: Sequence[Movement]) -> frozenset[str]:
    """What of Eq. 9 the rig is said not to have: gravity, stiffness."""
    return frozenset(name for each in movements for name in each.absent)


def with_channels(each: Movement, change: Callable[[Samples], Samples], **more: Any) -> Movement:
    """The same movement, the change made to every channel that is fitted."""
    rate = each.angular_velocity
    changed = None if rate is None else change(rate)
    return replace(each, angle=change(each.angle), angular_velocity=changed, **more)


def weightless(each: Movement, these: NDArray[np.bool_], **changed: Any) -> Movement:
    """The same movement, in which these samples weigh nothing."""
    return with_channels(each, lambda samples: np.where(these, np.nan, samples), **changed)


def angle_of_leg(each: Movement) -> Samples:
    """The angle as it was measured, before any chain [rad]."""
    part = each.segment
    angle = part.angle if part.raw_angle is None else part.raw_angle
    assert angle is not None  # a Segment has one or the other
    return angle


@remembered  # of most widths twice
def smoothed_motion(each: Movement, width: float) -> tuple[Samples, Samples]:
    """Angle and angular velocity as the leg had them, before any chain, smoothed over `width` s."""
    part = each.segment
    gyro = part.angular_velocity if part.raw_angle is None else part.raw_angular_velocity
    smooth, slope = local_line(part.time, angle_of_leg(each), width)
    return smooth, slope if gyro is None else local_line(part.time, gyro, width)[0]
