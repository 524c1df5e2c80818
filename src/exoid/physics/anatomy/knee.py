"""Damping and stiffness of a knee: of anything between a relaxed and a spastic one.

A relaxed, healthy knee, from a pendulum test (omicsonline.org 2161-0673-S6-001, Fig. 1): peaks .94,
.60, .38, .26 rad at a period of 1.10 s give 2.6-3.2 N m/rad beside gravity and 0.31-0.41 N m s/rad.
Passive moments of healthy knees have slopes of 2.5 to 31 N m/rad (Riener & Edrich, J Biomech 32(5),
1999). Spastic ones: fits of pendulum tests in cerebral palsy find 19 times the passive stiffness
(Androwis et al., EMBC 2014, 4403-6), both stiffness and damping grow with the reflex (Lin & Rymer,
IEEE TBME 38(9), 1991), and a leg that no longer swings has a damping ratio of 1 or more, against
0.06-0.07: sixteen times and more. So both are log-normal, a twentieth to twenty times a relaxed
knee's in 95 of 100. They are ratios to the inertia, which motion tells by itself: where it does,
they say nothing of m, l and J.
"""

from math import log

from exoid.physics.anatomy.expected import Expected

RELAXED_STIFFNESS = 2.9  # N m/rad
RELAXED_DAMPING = 0.36  # N m s/rad
RELAXED_INERTIA = 0.44  # kg m^2, of the leg that makes these of the record
FACTOR = 20.0  # two standard deviations either way
LOG_SCATTER = log(FACTOR) / 2

# Below these, relative to a relaxed knee's, all is alike: none at all is no surprise.
NONE = 0.1


def knee(inertia: float) -> tuple[Expected, Expected]:
    """Damping and stiffness of a relaxed knee that moves this inertia [kg m^2]."""
    size = inertia / RELAXED_INERTIA
    return (
        Expected(RELAXED_DAMPING * size, None),
        Expected(RELAXED_STIFFNESS * size, None),
    )
