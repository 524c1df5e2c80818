"""Where simulation and recording part, as it was found."""

from dataclasses import dataclass, replace
from typing import Annotated

import numpy as np
from jaxtyping import Float

Samples = Float[np.ndarray, " sample"]

ALONE = 0.3  # of the variance of what is missing, from which on something alone explains it
APART = 0.1  # of it, by which one explains more than another
OPEN = 2.0  # standard deviations, within which the sensors leave a torque open


@dataclass(frozen=True, eq=False)
class Missing:
    """The torque that a segment's baseline lacks."""

    segment: str
    time: Annotated[Samples, "s"]
    angle: Annotated[Samples, "rad"]
    angular_velocity: Annotated[Samples, "rad/s"]
    torque: Annotated[Samples, "N m"]
    band: Annotated[float, "N m"]  # standard deviation
    modelled: Annotated[Samples | None, "N m"]  # by what was found: without noise
    width: int  # samples, over which torques are averaged
    inertia: Annotated[float | None, "kg m^2"] = None  # that moves; older files have none

    def times(self, factor: float) -> "Missing":
        """With every torque so many times as large."""
        modelled = None if self.modelled is None else self.modelled * factor
        grown = {"torque": self.torque * factor, "band": self.band * factor}
        return replace(self, modelled=modelled, **grown)


@dataclass(frozen=True)
class Region:
    """A stretch of time in which a torque is missing."""

    segment: str
    begin: Annotated[float, "s"]
    end: Annotated[float, "s"]
    region: str
    description: str
    torque: Annotated[float, "N m"]  # mean

    def times(self, factor: float, unit: str = "N m") -> "Region":
        """With its torque so many times as large, in that unit."""
        torque = self.torque * factor
        return replace(self, torque=torque, description=described(torque, self.region, unit))


@dataclass(frozen=True, eq=False)
class Location:
    """The missing torque of every segment, where it is strongest, and what it goes with."""

    missing: list[Missing]
    regions: list[Region]
    by_angle: Annotated[float, "1"]  # share of its variance that the angle alone explains
    by_speed: Annotated[float, "1"]  # that speed and direction alone explain
    inertia: Annotated[float | None, "kg m^2"] = None  # of the leg, with which the torques grow
    by_segment: Annotated[float, "1"] = 0.0  # that a torque of its own in each segment explains
    rig: bool = False  # and no leg

    def with_inertia(self, inertia: float) -> "Location":
        """The same of a leg with another inertia: J (phi'' - Eq. 9) grows with it, but for what a
        known mass adds to it.
        """
        if self.inertia is None:
            return self
        more = inertia - self.inertia
        factors = {one.segment: 1 + more / (one.inertia or self.inertia) for one in self.missing}
        missing = [one.times(factors[one.segment]) for one in self.missing]
        regions = [one.times(factors[one.segment]) for one in self.regions]
        return replace(self, missing=missing, regions=regions, inertia=inertia)

    @property
    def pattern(self) -> str:
        """In one sentence."""
        angle, speed = f"{self.by_angle:.0%}", f"{self.by_speed:.0%}"
        if self.by_segment > max(ALONE, self.by_angle + APART, self.by_speed + APART):
            why = "" if self.rig else "a muscle that was not relaxed alike, a seat or "
            return (
                "it stays the same within each segment, and differs between them "
                f"({self.by_segment:.0%} of its variance; angle {angle}, speed {speed}): "
                f"{why}a zero that moved"
            )
        if max(self.by_angle, self.by_speed) < ALONE:
            return f"neither angle ({angle} of its variance) nor speed ({speed}) alone explains it"
        if self.by_speed > self.by_angle + APART:
            return f"it goes with speed and direction ({speed} of its variance, angle {angle})"
        if self.by_angle > self.by_speed + APART:
            return f"it goes with the angle ({angle} of its variance, speed {speed})"
        return f"angle ({angle} of its variance) and speed ({speed}) explain it about alike"


def described(torque: float, region: str, unit: str = "N m") -> str:
    """What is missing in a stretch of time."""
    towards = "extension" if torque > 0 else "flexion"
    return f"{abs(torque):.2g} {unit} towards {towards} are missing at {region}"
