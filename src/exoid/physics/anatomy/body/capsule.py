"""The paper's shank: a capsule (Eq. 8)."""

from math import pi


def capsule_inertia(
    mass: float, length: float, radius: float, *, as_printed: bool = False
) -> float:
    """Inertia of a solid capsule about a transverse axis through its centre [kg m^2] (Eq. 8).

    `length` [m] is from tip to tip, so that the cylinder is h = length - 2 radius long, and with
    the density rho = mass / (V_cylinder + V_sphere):

        theta = rho V_cylinder (h^2/12 + r^2/4) + rho V_sphere (2 r^2/5 + h^2/4 + 3 h r/8)

    `as_printed` puts the paper's h^2/2 in place of h^2/4, a known slip that makes a shin's theta
    32-36 % too large.
    """
    h, r = length - 2 * radius, radius
    if not (mass > 0 and r > 0 and h >= 0):
        raise ValueError(
            f"a capsule of {mass:g} kg, length {length:g} m and radius {radius:g} m does not "
            "exist: the length includes both round ends."
        )
    cylinder, sphere = pi * r**2 * h, 4 / 3 * pi * r**3
    density = mass / (cylinder + sphere)
    ends = h**2 / 2 if as_printed else h**2 / 4
    return density * (
        cylinder * (h**2 / 12 + r**2 / 4) + sphere * (2 * r**2 / 5 + ends + 3 * h * r / 8)
    )
