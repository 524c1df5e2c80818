"""What is at hand when a plan is asked for."""

from dataclasses import dataclass

from exoid.recordings.declared.sensors import Sensors

from .world import CAMERA, EXOSKELETON, Act

ANKLE = 0.4  # m from the knee


@dataclass(frozen=True)
class Situation:
    """What was recorded, by which sensors, and what is wanted."""

    words: str
    goal: str
    acts: tuple[Act, ...]  # none: nothing was recorded yet
    sensors: Sensors = EXOSKELETON


SITUATIONS = (
    Situation("nothing yet", "inertia", ()),
    Situation("one bare drop", "inertia", (Act(-0.3, 6.0),)),
    Situation("1.2 s of one drop", "stiffness_over_inertia", (Act(-0.6, 1.2),)),
    Situation("a loaded drop", "damping", (Act(-0.3, 6.0, added=1.0, distance=ANKLE),)),
    Situation(
        "a drop and two cycles",
        "gravity_over_inertia",
        (Act(-0.3, 3.0), Act(-0.1, 1.3, effort=-5.0), Act(-0.1, 1.7, effort=-4.0)),
    ),
    Situation("a camera's drop", "stiffness", (Act(-0.4, 4.0),), CAMERA),
)
