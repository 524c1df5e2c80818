"""Who is followed and by what model: from what is known of a person, and what was asked for."""

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

from exoid import online
from exoid.recordings.recording import Subject
from exoid.watching.coach import Coach
from exoid.watching.expect import expected_of
from exoid.watching.follower import Company
from exoid.watching.goals import Goal
from exoid.watching.leg import Leg, Person
from exoid.watching.load import Load
from exoid.watching.next_movement import Wish
from exoid.watching.refinement import Refinement


@dataclass(frozen=True)
class Origin:
    """Whose leg, with what on it, how the thigh is inclined [rad]; the terms, and the goals."""

    subject: Subject
    load: Load = field(default_factory=Load)
    thigh_angle: float = 0.0
    terms: tuple[type[Any], ...] = ()
    goals: Sequence[Goal] = ()

    @property
    def model(self) -> online.Model:
        return online.Model(online.Unknowns(self.terms, self.thigh_angle))

    def company(self, *, coached: bool, refined: bool) -> Company:
        """The leg, its estimator compiled or loaded, with who helps. Takes seconds."""
        person = Person(self.subject, expected_of(self.subject), self.model)
        leg = Leg(person, self.load)
        leg.warm()
        coach = Coach(Wish(person, self.goals)) if coached else None
        return Company(leg, coach, Refinement(self.subject, self.model) if refined else None)


def check_subject(subject: Subject) -> None:
    """**Raises** `ValueError` for what is no leg."""
    if subject.kind == "rig":
        raise ValueError(
            "live estimates are of legs: what a rig may be is not expected beforehand. Record it "
            "and fit it (exoid record, exoid fit)."
        )
