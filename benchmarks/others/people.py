"""People and their legs, scattered about two published tables of shank and foot together."""

from dataclasses import dataclass

import numpy as np

from .leg import Leg

# Of body mass; of body height: knee to COM, and J / (m l), the length of the equal simple pendulum.
# Winter, Biomechanics and Motor Control of Human Movement, 4th ed. 2009, Table 4.1, "leg and foot":
# COM at 0.606 and radius of gyration about the knee 0.735 of a segment of 0.246 H.
WINTER = (0.061, 0.606 * 0.246, 0.735**2 / 0.606 * 0.246)
# de Leva, J Biomech 29(9), 1996, shank and foot combined with the ankle at a right angle.
DE_LEVA = (0.057, 0.1517, 0.210)
SCATTER = (0.08, 0.04, 0.03)  # of one person about the tables, relative, one standard deviation

# Mass of shank and foot against the tables': fat sits on the trunk; children's legs are light
# (Jensen, J Biomech 19(5), 1986).
SHARE = {"child": 0.95, "obese": 0.86}
# c over m l g, and damping over critical damping of the hanging leg. Healthy: pendulum tests swing
# 5 to 7 times. Spastic: d to about 3 N m s/rad and c to about 15 N m/rad of an adult.
KNEES = {
    "adult": ((0.08, 0.40), (0.04, 0.12)),
    "child": ((0.08, 0.45), (0.04, 0.12)),
    "obese": ((0.08, 0.40), (0.05, 0.15)),
    "spastic": ((0.20, 1.10), (0.18, 0.60)),
    "stiff": ((0.50, 1.40), (0.10, 0.30)),
}
HARDEST = 15.0  # N m/rad


@dataclass(frozen=True)
class Person:
    """Who was recorded; body mass and height are None where nobody wrote them down."""

    kind: str
    leg: Leg
    body_mass: float | None  # kg
    height: float | None  # m


def draw_person(rng: np.random.Generator) -> Person:
    kind = str(rng.choice(list(KNEES), p=(0.32, 0.18, 0.15, 0.2, 0.15)))
    build = kind if kind not in ("spastic", "stiff") else str(rng.choice(["adult", "child"]))
    height, body_mass = draw_body(build, rng)
    mass, distance, length = draw_table(rng)
    mass *= body_mass * SHARE.get(build, 1.0)
    inertia = mass * distance * height * length * height
    bare = Leg(mass, distance * height, inertia, 0.0, 0.0)
    (softest, stiffest), (least, most) = KNEES[kind]
    stiffness = min(HARDEST, bare.weight * rng.uniform(softest, stiffest))
    damping = 2 * rng.uniform(least, most) * np.sqrt(bare.weight * inertia)
    told = rng.random() < 0.8
    written = (round(body_mass, 1), round(height, 3)) if told else (None, None)
    return Person(kind, bare._replace(stiffness=stiffness, damping=float(damping)), *written)


def draw_body(build: str, rng: np.random.Generator) -> tuple[float, float]:
    """Height in m and body mass in kg."""
    if build == "child":
        height, index = rng.uniform(1.05, 1.50), rng.normal(16.5, 1.5)
    elif build == "obese":
        height, index = rng.normal(1.70, 0.08), rng.uniform(32, 50)
    else:
        height, index = rng.normal(1.73, 0.09), np.clip(rng.normal(24, 3), 18, 31)
    return float(height), float(index * height**2)


def draw_table(rng: np.random.Generator) -> tuple[float, float, float]:
    """One person's fractions: mass of body mass, COM and pendulum length of body height."""
    table = (WINTER, DE_LEVA)[rng.integers(2)]
    spread = np.clip(rng.standard_normal(3), -2.5, 2.5) * SCATTER
    mass, distance, length = np.array(table) * np.exp(spread)
    return float(mass), float(distance), float(length)
