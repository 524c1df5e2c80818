"""A lower leg by Eq. 9, with what Eq. 9 may lack, as torques about the knee."""

from typing import NamedTuple

GRAVITY = 9.80665  # m/s^2


class Leg(NamedTuple):
    """What a person's shank and foot are; extension positive, 0 with the shank level."""

    mass: float  # kg
    com_distance: float  # m, from the knee
    inertia: float  # kg m^2, about the knee
    stiffness: float  # N m/rad, slack at full extension
    damping: float  # N m s/rad

    @property
    def weight(self) -> float:
        """m l g in N m."""
        return self.mass * self.com_distance * GRAVITY

    @property
    def ratios(self) -> dict[str, float]:
        """What free motion can tell."""
        return {
            "gravity_over_inertia": self.weight / self.inertia,
            "stiffness_over_inertia": self.stiffness / self.inertia,
            "damping_over_inertia": self.damping / self.inertia,
        }


class Physics(NamedTuple):
    """Every coefficient of the motion; the defaults are Eq. 9 alone."""

    inertia: float  # kg m^2
    weight: float  # N m
    stiffness: float  # N m/rad
    damping: float  # N m s/rad
    tilt: float = 0.0  # rad, of the seat against gravity
    rest_angle: float = 0.0  # rad, where the spring is slack
    friction: float = 0.0  # N m, dry
    drag: float = 0.0  # N m s^2/rad^2
    cubic: float = 0.0  # N m/rad^3
    stop_angle: float = -10.0  # rad, of flexion
    stop_stiffness: float = 0.0  # N m/rad
    stop_damping: float = 0.0  # N m s/rad
    reflex_gain: float = 0.0  # N m s/rad
    reflex_threshold: float = 0.0  # rad/s
    reflex_delay: float = 0.05  # s
    maxwell_stiffness: float = 0.0  # N m/rad
    maxwell_time: float = 1.0  # s


def physics_of(leg: Leg, **more: float) -> Physics:
    return Physics(leg.inertia, leg.weight, leg.stiffness, leg.damping, **more)
