"""A rigid body that turns as the leg does, as engines want it: by its centre of mass."""

from dataclasses import dataclass

from exoid.physics.leg import GRAVITY

SLENDER = 0.1  # the inertia along a shank over that across it: no joint of one axis feels it
NEAR = 0.9  # of J / (m l), as far as a centre may be put so that an inertia is left about it
LIGHT = 1e-3  # kg, of a body without weight


@dataclass(frozen=True)
class Body:
    """Its centre lies on the line from the knee, `distance` from it."""

    mass: float  # kg
    distance: float  # m
    inertia: float  # kg m^2, about the knee

    @property
    def central(self) -> float:
        """About the axis through the centre, parallel to the knee's [kg m^2]."""
        return self.inertia - self.mass * self.distance**2

    @property
    def along(self) -> float:
        """About the line from the knee [kg m^2]: any that is possible."""
        return SLENDER * self.central


def body(mass: float, moment: float, inertia: float) -> tuple[Body, str]:
    """The body of this mass [kg], moment m l [kg m] and inertia about the knee [kg m^2]; and what
    to say where no body has all three.

    A hinge feels m l and J alone, so that another m and l with the same product move alike.
    """
    if mass > 0 and inertia - moment**2 / mass > 0:
        return Body(mass, moment / mass, inertia), ""
    if moment == 0.0:
        return Body(max(mass, LIGHT), 0.0, inertia), ""
    distance = NEAR * inertia / moment
    other = Body(moment / distance, distance, inertia)
    return other, (
        f"No body of {mass:.3g} kg has its centre at {moment / mass if mass else 0:.3g} m and "
        f"J = {inertia:.3g} kg m^2 about the knee: m = {other.mass:.4g} kg at "
        f"{other.distance:.4g} m is written, which moves alike."
    )


def hung(inertia: float, gravity: float) -> Body:
    """The body of this inertia about the knee whose weight there is `gravity` [N m]."""
    return body(0.0, gravity / GRAVITY, inertia)[0]
