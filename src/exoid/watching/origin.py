"""Who is followed and by what model: from what is known of a person, and what was asked for."""

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

from exoid.online.model.model import Model, Node
from exoid.online.model.unknowns import Unknowns
from exoid.recordings.declared.subject import Subject
from exoid.watching.beside.coach import Coach
from exoid.watching.beside.goals import Goal
from exoid.watching.beside.next_movement import Wish
from exoid.watching.beside.refinement import Refinement
from exoid.watching.estimate.expect import expected_of
from exoid.watching.estimate.leg import Leg, Person
from exoid.watching.estimate.load import Load
from exoid.watching.estimate.switch import Switch
from exoid.watching.follower import Company


@dataclass(frozen=True)
class Origin:
    """Whose leg, with what on it, how the thigh is inclined [rad]; terms, sensors, and goals."""

    subject: Subject
    load: Load | Switch = field(default_factory=Load)
    thigh_angle: float = 0.0
    terms: tuple[type[Any], ...] = ()
    node: Node = field(default_factory=Node)
    goals: Sequence[Goal] = ()

    @property
    def model(self) -> Model:
        return Model(Unknowns(self.terms, self.thigh_angle), self.node)

    def company(self, *, coached: bool, refined: bool) -> Company:
        """The leg, its estimator compiled or loaded, with who helps. Takes seconds."""
        person = Person(self.subject, expected_of(self.subject), self.model)
        leg = Leg(person, self.load)
        leg.warm()
        coach = Coach(Wish(person, self.goals)) if coached else None
        return Company(leg, coach, Refinement(self.subject, self.model) if refined else None)
