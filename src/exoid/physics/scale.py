"""How large a rig's motion and torque are beside a leg's: its terms' ranges and starts go with it.

A term declares its ranges and starts for a leg. A parameter of the unit N m^a rad^b s^c is as many
times larger on a rig, as the torque, the angle and the time of the rig's recording are.
"""

import re
from dataclasses import dataclass, replace

import numpy as np

from exoid.physics.parameter import Declaration

UNITS = {"N m": (1, 0, 0), "rad": (0, 1, 0), "s": (0, 0, 1), "Hz": (0, 0, -1)}
UNITS["kg m^2"] = (1, -1, 2)  # N m over rad/s^2
FACTOR = re.compile(r"(kg m\^2|N m|rad|s|Hz)(?:\^(\d))?")


@dataclass(frozen=True)
class Scale:
    """Of a rig's recording over a leg's: torque, angle and time."""

    torque: float = 1.0
    angle: float = 1.0
    time: float = 1.0

    def of(self, unit: str) -> float:
        """How many times larger a parameter of this unit is."""
        size = np.array([self.torque, self.angle, self.time])
        return float(np.prod(size ** np.array(powers(unit))))


AS_A_LEG = Scale()


def powers(unit: str) -> tuple[int, ...]:
    """Of N m, rad and s in a unit such as N m s/rad; zeros where it has others, as m."""
    above, _, below = unit.partition("/")
    total = np.zeros(3, dtype=int)
    for part, sign in ((above, 1), (below.strip("()"), -1)):
        if FACTOR.sub("", part).strip() not in ("", "1"):
            return 0, 0, 0
        for name, power in FACTOR.findall(part):
            total += sign * int(power or 1) * np.array(UNITS[name])
    return tuple(int(each) for each in total)


def ranged(declared: Declaration, scale: Scale) -> Declaration:
    """The declaration of a rig of this scale: its range at least a leg's."""
    factor = scale.of(declared.unit)
    if factor == 1.0:
        return declared
    starts = declared.starts
    return replace(
        declared,
        lower=min(declared.lower, factor * declared.lower),
        upper=max(declared.upper, factor * declared.upper),
        starts=starts if callable(starts) else tuple(factor * each for each in starts),
    )
