"""Children and infants: the leg's share of the body grows until puberty, its shape hardly changes.

Masses: Jensen's boys of 6, 12, 15 and 18 years (J Biomech 19(5):359-368, 1986; 22(6-7):529-536,
1989), relative to his own adults, and infants of Sun & Jensen (J Biomech 27(3), 1994; shank 0.169
+ 0.00416 kg per week, foot 0.0522 + 0.00212 kg per week). Jensen's elliptical zones make every leg
14 % heavier than gamma scans do, so his growth is taken and de Leva's level. Shape:
lengths go with the lower half of the body, whose share of the height is 0.33 at birth, 0.38 at one
year, 0.44 at five and 0.48 of adults (sitting heights of Fredriks et al., Arch Dis Child
90(8):807-812, 2005); otherwise it is an adult's, as the inertia of the lower leg goes with the
fifth power of height between 5 and 18 years (Lebiedowska & Polisiakiewicz, J Biomech 30(7):723-728,
1997). The coefficients of Jensen's regressions of shape on age were not to be had.
"""

from collections.abc import Sequence
from itertools import pairwise

from exoid.physics.anatomy.body.segments import Fractions
from exoid.physics.anatomy.body.size import Body
from exoid.physics.anatomy.tables.table import Scatter, Table

GROWTH = (  # m, years: median height of boys and girls (WHO 2006 and 2007)
    (0.50, 0.0),
    (0.76, 1.0),
    (0.87, 2.0),
    (1.03, 4.0),
    (1.16, 6.0),
    (1.27, 8.0),
    (1.38, 10.0),
    (1.50, 12.0),
    (1.62, 14.0),
    (1.70, 18.0),
)
# Of an adult's share of body mass, by age [years].
SHANK = ((0.25, 0.80), (1.0, 0.80), (6.0, 0.96), (12.0, 1.10), (15.0, 1.17), (18.0, 1.0))
FOOT = ((0.25, 1.30), (1.0, 1.10), (6.0, 1.12), (12.0, 1.24), (15.0, 1.24), (18.0, 1.0))
LOWER_HALF = (  # m, shank length over height, of an adult's
    (0.50, 0.70),
    (0.76, 0.80),
    (0.87, 0.85),
    (1.10, 0.92),
    (1.27, 0.96),
    (1.45, 1.0),
)

# One study's boys, another's girls unmeasured, ages guessed from heights.
CHILD_SCATTER = Scatter(mass=0.08, com_distance=0.035, radius=0.035)


def straight(points: Sequence[tuple[float, float]], at: float) -> float:
    """Straight between the points, level beyond them."""
    if at <= points[0][0]:
        return points[0][1]
    for (low, first), (high, last) in pairwise(points):
        if at <= high:
            return first + (last - first) * (at - low) / (high - low)
    return points[-1][1]


def age_of(body: Body) -> float:
    """As given, or at which half of all children are this tall [years]."""
    return straight(GROWTH, body.height) if body.age is None else body.age


def grown(adult: Fractions, body: Body) -> Fractions:
    """An adult's fractions, made as young."""
    age = age_of(body)
    return adult._replace(
        shank_mass=adult.shank_mass * straight(SHANK, age),
        foot_mass=adult.foot_mass * straight(FOOT, age),
        shank_length=adult.shank_length * straight(LOWER_HALF, body.height),
    )


def of(adult: Table) -> Table:
    """Children in the place of the adults of a table."""
    return Table(
        "child",
        lambda body: grown(adult.fractions(body), body),
        CHILD_SCATTER,
        (13.0, 24.0),
        (1.0, 1.75),
    )
