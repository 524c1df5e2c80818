"""The paper's own expectations: Eq. 5-8 as printed, and the vector of Eq. 14."""

from exoid.physics.anatomy.body.capsule import capsule_inertia
from exoid.physics.anatomy.body.segments import com_distance, leg_mass
from exoid.physics.anatomy.body.size import Body, check_body
from exoid.physics.anatomy.expected import Expected, ExpectedLeg
from exoid.physics.anatomy.tables.de_leva import ADULT_HEIGHT, ADULT_INDEX, ADULT_SCATTER
from exoid.physics.anatomy.tables.table import Table
from exoid.physics.anatomy.tables.winter import WINTER

# The paper's 5 % and 2 % (Eq. 5-6); it does not say where the parts hang: Winter's geometry.
PAPER = WINTER._replace(shank_mass=0.05, foot_mass=0.02)
SHANK_RADIUS = 0.05 / 1.80  # of body height; engineering estimate, the paper gives no number

TABLE = Table("paper", lambda body: PAPER, ADULT_SCATTER, ADULT_INDEX, ADULT_HEIGHT)


def printed_inertia(body: Body, shank_length: float, shank_radius: float | None) -> float:
    """J = m l^2 + theta of Eq. 12, theta the shank's alone, by Eq. 8 as printed [kg m^2]."""
    radius = SHANK_RADIUS * body.height if shank_radius is None else shank_radius
    theta = capsule_inertia(PAPER.shank_mass * body.mass, shank_length, radius, as_printed=True)
    distance = com_distance(PAPER, body.height, shank_length)
    return leg_mass(PAPER, body.mass) * distance**2 + theta


def paper_prior(body_mass: float = 77.0, height: float = 1.80) -> ExpectedLeg:
    """The paper's expected vector (Eq. 14), scaled from its subject (77 kg, 1.80 m) to another.

    m = 0.07 body mass, l by height, J by mass and height squared; d and c as printed. All standard
    deviations are 1 in the parameter's own unit: Eq. 11 weighs every difference alike.

    Eq. 14 does not follow from Eq. 5-8: for its subject those give l = 0.276 m, not 0.2461, and
    J = 0.48 kg m^2 (0.58 with the foot's part), not 0.35; J - m l^2 of Eq. 14 is the theta of a
    shin 0.25 m long.
    Its d = 30 is some eighty times a relaxed knee's: d and c of its source look interchanged.
    """
    check_body(Body(body_mass, height))
    heavier, taller = body_mass / 77.0, height / 1.80
    values = (0.07 * body_mass, 0.35 * heavier * taller**2, 0.2461 * taller, 30.0, 2.0)
    return ExpectedLeg(*(Expected(value, 1.0) for value in values), source="paper, Eq. 14")
