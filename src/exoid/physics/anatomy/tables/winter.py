"""Dempster's cadavers as tabulated by Winter (Biomechanics and Motor Control, 4th ed. 2009)."""

from exoid.physics.anatomy.body.segments import Fractions
from exoid.physics.anatomy.tables.de_leva import ADULT_HEIGHT, ADULT_INDEX, ADULT_SCATTER
from exoid.physics.anatomy.tables.table import Table

# Table 4.1; the foot's length there is ankle to ball, here 0.076 H.
WINTER = Fractions(0.0465, 0.0145, 0.246, 0.433, 0.302, 0.475 * 0.076)

TABLE = Table("winter", lambda body: WINTER, ADULT_SCATTER, ADULT_INDEX, ADULT_HEIGHT)
