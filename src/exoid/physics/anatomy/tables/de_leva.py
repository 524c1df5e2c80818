"""Zatsiorsky and Seluyanov's gamma scans as adjusted by de Leva (J Biomech 29(9), 1996)."""

from exoid.physics.anatomy.body.segments import Fractions
from exoid.physics.anatomy.tables.table import Scatter, Table, of_sex

# Shank knee to ankle centre (440.3 of 1741 mm, 438.6 of 1735 mm), foot length 258.1 and 228.3 mm.
DE_LEVA = {
    "male": Fractions(0.0433, 0.0137, 0.2529, 0.4395, 0.246, 0.245 * 0.1482),
    "female": Fractions(0.0481, 0.0129, 0.2528, 0.4352, 0.263, 0.279 * 0.1316),
}

# At a given mass and height the regressions of the same scans leave 0.22 kg of the shank and
# 0.10 kg of the foot unexplained, 6-8 % of the leg; 13 % of the shank's own inertia, and up to
# 1.25 cm of its centre, 5 % of l, the scan's error included (Zatsiorsky, Kinetics of Human Motion,
# 2002, Table A2.6). Lower legs of one height differ in length by 3 %, and l and J / (m l) with
# them.
ADULT_SCATTER = Scatter(mass=0.07, com_distance=0.025, radius=0.03)
ADULT_INDEX, ADULT_HEIGHT = (18.0, 29.0), (1.55, 1.95)  # kg/m^2, m: of those scanned


TABLE = Table(
    "de_leva", lambda body: of_sex(body, DE_LEVA), ADULT_SCATTER, ADULT_INDEX, ADULT_HEIGHT
)
