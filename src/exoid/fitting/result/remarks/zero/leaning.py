"""How far the numbers of a leg lean on where its knee's spring is slack."""

from dataclasses import dataclass
from typing import Annotated

import numpy as np

BENT = np.radians(30.0)  # of flexion, where a spring may well be slack: Riener & Edrich have 61 deg
BEYOND = 1.5  # times what one makes of the ratios that is slack at BENT
STIFFER = 2.0  # times as stiff as by the fit that a remark takes the leg for, at most, or as soft
CLEAR = 4.0  # errors of a constant torque from which on it is worth a sentence
LEANING = ("gravity_over_inertia", "stiffness_over_inertia")


@dataclass(frozen=True)
class Leaning:
    """How far the numbers of a leg whose spring is slack at BENT are from those of the fit."""

    off: dict[str, float]  # by the names of a result, in their units
    usual: float  # how much of that a leg mostly is which shows the same, as a standard deviation
    seen: Annotated[float, "rad"]  # the constant torque that the recording shows, over the fit's c
    told: Annotated[float, "rad"]  # the error with which it does so
    softer: float  # 1/rad, what that torque makes the fit's c / J stiffer by than the leg's
    shown: bool  # is that clear, beside all else that is missing?
    push: float = 0.0  # the constant torque that makes it, over m l g
    share: float = 0.0  # of the squares that are missed or made up for, what it would take away

    @property
    def rest_angle(self) -> tuple[float, float]:
        """Where a spring that makes the torque is slack [rad], and its error: T / (c - s T), of the
        leg's own c, not of the fit's.
        """
        left = max(1 - self.softer * self.seen, 1 / STIFFER)
        return self.seen / left, self.told / left**2

    @property
    def of_ratios(self) -> np.ndarray:
        """Of the `LEANING` [1/s^2]."""
        return np.array([self.off[name] for name in LEANING])

    @property
    def pushed(self) -> bool:
        """Is something missing that looks like a constant torque, well beyond that of a spring as
        stiff as the fit's that is slack at BENT?
        """
        clear = abs(self.seen) > CLEAR * self.told
        return bool(clear and self.usual > BEYOND and not self.shown)

    @property
    def spread(self) -> dict[str, float]:
        """How far the numbers of legs are from the fit's whose springs are slack elsewhere, as a
        standard deviation: root mean square.
        """
        return {name: abs(each) * self.usual for name, each in self.off.items()}
