"""A leg that SciPy swings: it shares no code with exoid but the recording it is put into."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from scipy.integrate import solve_ivp

GRAVITY = 9.81  # m/s^2, as in Eq. 9
EXACT = 1e-9  # tolerance, absolute and relative


@dataclass(frozen=True)
class Leg:
    """What Eq. 9 has of a leg, or of a leg that carries a mass."""

    mass: float  # kg
    inertia: float  # kg m^2, about the knee
    com_distance: float  # m
    damping: float  # N m s/rad
    stiffness: float  # N m/rad

    @property
    def moment(self) -> float:
        """m l [kg m]."""
        return self.mass * self.com_distance

    def loaded(self, mass: float, distance: float, radius: float = 0.0) -> "Leg":
        """With this mass [kg], whose radius of gyration is `radius` [m]."""
        moment, total = self.moment + mass * distance, self.mass + mass
        inertia = self.inertia + mass * (distance**2 + radius**2)
        return Leg(total, inertia, moment / total, self.damping, self.stiffness)


def still(time: float) -> float:
    """Nobody moves the leg."""
    return 0.0


def swing(
    leg: Leg,
    start: float,
    time: np.ndarray,
    *,
    tilt: float = 0.0,
    torque: Callable[[float], float] = still,
) -> tuple[np.ndarray, np.ndarray]:
    """Angle [rad] and angular velocity [rad/s] of a leg let go at `start` [rad].

    J phi'' = tau(t) - m l g cos(phi + tilt) - c phi - d phi', by DOP853.
    """
    weight = leg.moment * GRAVITY

    def change(at, state):
        angle, velocity = state
        pull = weight * np.cos(angle + tilt) + leg.stiffness * angle + leg.damping * velocity
        return velocity, (torque(at) - pull) / leg.inertia

    span = (time[0], time[-1] + 1e-9)
    moved = solve_ivp(change, span, (start, 0.0), "DOP853", time, rtol=EXACT, atol=EXACT)
    return moved.y[0], moved.y[1]
