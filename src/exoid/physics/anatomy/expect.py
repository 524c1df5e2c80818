"""`expected_leg`: from a body to the leg that anatomy expects, with how m, l and J scatter."""

from collections.abc import Iterable
from math import exp, log
from typing import NamedTuple

import numpy as np

from exoid.physics.anatomy.body.segments import com_distance, leg_mass, two_segment_inertia
from exoid.physics.anatomy.body.size import Body, Sex, check_body
from exoid.physics.anatomy.choice import DISAGREEMENT, TableName, speaking
from exoid.physics.anatomy.expected import ExpectedLeg, Matrix, scattered
from exoid.physics.anatomy.knee import knee
from exoid.physics.anatomy.paper import printed_inertia
from exoid.physics.anatomy.tables.table import Scatter, Table

# J / (m l^2) of de Leva's, Winter's and Dumas' leg: 1.38, 1.44, 1.49.
SLENDERNESS = 1.43
MEASURED = Scatter(mass=0.10, com_distance=0.06, radius=0.06)


class Build(NamedTuple):
    """Logarithms of m, l and J / (m l), and how they scatter."""

    logarithms: np.ndarray
    covariance: np.ndarray


def expected_leg(
    body_mass: float,
    height: float,
    *,
    table: TableName = "auto",
    sex: Sex | None = None,
    age: float | None = None,
    shank_length: float | None = None,
    shank_radius: float | None = None,
) -> ExpectedLeg:
    """The leg that anatomy expects of a body mass [kg] and a height [m].

    - `auto` (default): all tables of adults, and where they disagree, that is scatter; `child`
      below 15 years (or 1.30 m, where no `age` is given), `heavy` above a body mass index of 33; a
      mixture between.
    - `de_leva`, `dumas`: adults by sex; without one, the mean of female and male.
    - `winter`: one table for all adults.
    - `paper`: Eq. 5-8 and J = m l^2 + theta of Eq. 12 as printed: only the shank's own theta, by
      Eq. 8 with its capsule as printed, the foot's left out. That is 17 % below both segments'.

    m, l and J / (m l) scatter independently; a table's scatter widens with the distance of the body
    from those whom it measured. A measured `shank_length` [m], knee to ankle, takes the place of
    the table's. `shank_radius` [m] enters Eq. 8 alone. The foot hangs 0.0226 H below and 0.0316 H
    ahead of the ankle (Dumas: its own place); 1 cm more or less changes the inertia by about
    0.01 kg m^2. Damping and stiffness are those of a relaxed knee; they spread over decades.

    **Raises** `ValueError` when body mass and height are not those of one person in kg and m.

    >>> leg = exoid.expected_leg(77.0, 1.80)
    >>> 0.3 < leg.inertia.value < 0.6  # kg m^2
    True
    """
    body = Body(body_mass, height, sex, age)
    check_body(body)
    spoken = speaking(body, table)
    builds = [build(each, body, shank_length, shank_radius) for each, _ in spoken]
    shares = [share for _, share in spoken]
    names = list(dict.fromkeys(each.name for each, _ in spoken))
    source = f"anatomy, table{'s' if len(names) > 1 else ''} {listed(names)}"
    source += f", {sex}" if sex else ""
    centre, covariance = mixture(builds, shares)
    if len(spoken) == 1:
        covariance = covariance + squared(DISAGREEMENT)
    return leg_of(centre, covariance, source)


def measured_leg(mass: float, distance: float) -> ExpectedLeg:
    """What to expect where m [kg] and l [m] were measured: J as the shape of all tables has it."""
    logarithms = (log(mass), log(distance), log(SLENDERNESS * distance))
    return leg_of(logarithms, squared(MEASURED), "measured mass and distance")


def known_leg(leg: ExpectedLeg, mass: float | None, distance: float | None) -> ExpectedLeg:
    """The same where m [kg], l [m] or both are known instead: J goes with them, J / (m l) with l as
    the shape of all tables has it. So does a stump's.
    """
    if leg.covariance is None or (mass is None and distance is None):
        return leg
    known, shape = (mass, distance), leg.inertia.value / (leg.mass.value * leg.com_distance.value)
    logarithms = [log(leg.mass.value), log(leg.com_distance.value), log(shape)]
    covariance = np.array(leg.covariance)
    told = [at for at, each in enumerate(known) if each is not None]
    logarithms[:2] = [
        old if each is None else log(each) for each, old in zip(known, logarithms[:2], strict=True)
    ]
    if distance is not None:
        logarithms[2], told = log(SLENDERNESS * distance), [*told, 2]
    covariance[told], covariance[:, told] = 0.0, 0.0
    covariance[told, told] = np.diag(squared(MEASURED))[told]
    return leg_of(logarithms, covariance, leg.source)


def build(
    table: Table, body: Body, shank_length: float | None, shank_radius: float | None
) -> Build:
    """What one table says of a body."""
    part = table.fractions(body)
    length = part.shank_length * body.height if shank_length is None else shank_length
    if not 0.12 <= length / body.height <= 0.36:
        raise ValueError(f"shank_length {length:g} m does not fit a height of {body.height:g} m.")
    mass, distance = leg_mass(part, body.mass), com_distance(part, body.height, length)
    inertia = two_segment_inertia(part, body.mass, body.height, length)
    if table.name == "paper":
        inertia = printed_inertia(body, length, shank_radius)
    logarithms = log(mass), log(distance), log(inertia / (mass * distance))
    return Build(np.array(logarithms), squared(table.scatter_of(body)))


def mixture(builds: list[Build], shares: list[float]) -> Build:
    """Mean and covariance of tables that each speak for a share: their disagreement is scatter."""
    each = list(zip(builds, shares, strict=True))
    centre = sum((share * one.logarithms for one, share in each), np.zeros(3))
    covariance = np.zeros((3, 3))
    for one, share in each:
        away = one.logarithms - centre
        covariance += share * one.covariance
        covariance += np.outer(share * away, away)
    return Build(centre, covariance)


def leg_of(logarithms: Iterable[float], covariance: np.ndarray, source: str) -> ExpectedLeg:
    """The leg around which m, l and J / (m l) scatter so."""
    mass, distance, radius = map(exp, logarithms)
    inertia = mass * distance * radius
    damping, stiffness = knee(inertia)
    matrix: Matrix = tuple(map(tuple, covariance.tolist()))
    return ExpectedLeg(
        mass=scattered(mass, matrix[0][0]),
        inertia=scattered(inertia, sum(map(sum, matrix))),
        com_distance=scattered(distance, matrix[1][1]),
        damping=damping,
        stiffness=stiffness,
        source=source,
        covariance=matrix,
    )


def listed(names: list[str]) -> str:
    return " and ".join([", ".join(names[:-1]), names[-1]] if len(names) > 1 else names)


def squared(scatter: Scatter) -> np.ndarray:
    """The covariance of what scatters independently."""
    return np.diag([each**2 for each in scatter])
