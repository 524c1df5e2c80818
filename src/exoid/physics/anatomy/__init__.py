"""What anatomy expects of a lower leg of a given body mass and height (Eq. 5-8, 14).

One file per table. Plain floats.
"""

from exoid.physics.anatomy.body.capsule import capsule_inertia
from exoid.physics.anatomy.body.segments import com_distance, leg_mass, two_segment_inertia
from exoid.physics.anatomy.body.size import Body, Sex, reach
from exoid.physics.anatomy.choice import TableName
from exoid.physics.anatomy.expect import expected_leg, known_leg, measured_leg
from exoid.physics.anatomy.expected import Expected, ExpectedLeg
from exoid.physics.anatomy.paper import PAPER, paper_prior

__all__ = [
    "PAPER",
    "Body",
    "Expected",
    "ExpectedLeg",
    "Sex",
    "TableName",
    "capsule_inertia",
    "com_distance",
    "expected_leg",
    "known_leg",
    "leg_mass",
    "measured_leg",
    "paper_prior",
    "reach",
    "two_segment_inertia",
]
