"""Dumas, Cheze, Verriest, J Biomech 40(3):543-553, 2007."""

from exoid.physics.anatomy.body.segments import Fractions
from exoid.physics.anatomy.tables.de_leva import ADULT_HEIGHT, ADULT_INDEX, ADULT_SCATTER
from exoid.physics.anatomy.tables.table import Table, of_sex

# Shank 433 of 1770 mm (388 of 1610 mm), foot 265 mm (233 mm), whose COM lies 101 mm (63 mm) ahead
# of and 40 mm (51 mm) below the ankle.
DUMAS = {
    "male": Fractions(0.048, 0.012, 0.2446, 0.410, 0.28, 0.36 * 0.1497, 0.0226, 0.0572),
    "female": Fractions(0.045, 0.010, 0.2410, 0.404, 0.28, 0.36 * 0.1447, 0.0315, 0.0391),
}


TABLE = Table("dumas", lambda body: of_sex(body, DUMAS), ADULT_SCATTER, ADULT_INDEX, ADULT_HEIGHT)
