"""Heavy bodies: most of the weight is gained elsewhere than below the knee.

Masses: regressions of the gamma scans on mass W [kg] and height H [cm] (Zatsiorsky, Kinetics of
Human Motion, 2002, Table A2.6: shank -1.592 + 0.0362 W + 0.0121 H, residual 0.219 kg; foot -0.829 +
0.0077 W + 0.0073 H, 0.101 kg), carried on beyond the men of 73 +- 9 kg that they are made of: at
110 kg and 1.74 m a leg has 5.3 % of the body, where de Leva's constant share has 5.9 %. DXA scans
of obese adults say the same without numbers for foot and shank together: less of their mass is in
the shank, and its centre is nearer to the knee (Chambers et al., Clin Biomech 25(2):131-136, 2010);
tables of others miss single segments by up to 60 % (Merrill et al., 2019). Women's legs are heavier
by as much as in de Leva's tables. The changes by weight loss of Matrangola et al. (J Biomech
41(15), 2008) were not to be had.
"""

from exoid.physics.anatomy.body.segments import Fractions
from exoid.physics.anatomy.body.size import Body
from exoid.physics.anatomy.tables.de_leva import DE_LEVA
from exoid.physics.anatomy.tables.table import Scatter, Table, of_sex

SHANK = (-1.592, 0.0362, 1.21)  # kg, kg per kg, kg per m
FOOT = (-0.829, 0.0077, 0.73)

# Chambers et al. say that the shank's centre lies higher, not by how much: an engineering estimate.
HIGHER = 0.015  # of the shank's length
HEAVY_SCATTER = Scatter(mass=0.065, com_distance=0.04, radius=0.04)


def weighed(adult: Fractions, body: Body) -> Fractions:
    """An adult's shape, masses by the regressions of men and de Leva's step to women."""
    anyone, man = of_sex(body, DE_LEVA), DE_LEVA["male"]
    return adult._replace(
        shank_com=adult.shank_com - HIGHER,
        shank_mass=share(SHANK, body) * anyone.shank_mass / man.shank_mass,
        foot_mass=share(FOOT, body) * anyone.foot_mass / man.foot_mass,
    )


def share(line: tuple[float, float, float], body: Body) -> float:
    """Of a segment in the body's mass."""
    constant, by_mass, by_height = line
    return (constant + by_mass * body.mass + by_height * body.height) / body.mass


def of(adult: Table) -> Table:
    """Heavy people in the place of the adults of a table."""
    return Table(
        "heavy",
        lambda body: weighed(adult.fractions(body), body),
        HEAVY_SCATTER,
        (24.0, 40.0),
        (1.50, 1.95),
    )
