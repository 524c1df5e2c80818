"""What to record next, and what it will bring."""

from dataclasses import dataclass
from typing import ClassVar

from exoid.planning.planned import Plan
from exoid.report.parts.case import Case
from exoid.report.sections.section import Section
from exoid.report.tables.plan import files, stated, steps
from exoid.report.words.text import counted

HOW = (
    "Each time: hold still for 2 s, let go without a push, hands off until the leg hangs still. "
    "The person relaxes."
)
ASK = (
    "exoid plan says which recording would narrow a quantity most; exoid diagnose says whether "
    "the model lacks something, and what would show it."
)
ENOUGH = "The diagnosis asks for no further recording."


@dataclass(frozen=True, eq=False)
class Advice(Section):
    """What tells rivals apart, and what narrows the inertia."""

    name: ClassVar[str] = "advice"
    title: ClassVar[str] = "What to record next"

    diagnosis: tuple[str, ...]  # to tell causes apart
    narrowing: str  # which quantity the plan is for; empty without one
    goal: str
    steps: tuple[str, ...]
    notes: tuple[str, ...]
    how: str

    @classmethod
    def of(cls, case: Case) -> "Advice":
        plan, found = case.plan, case.diagnosis
        tasks = () if plan is None else tasks_of(plan)
        said = () if found is None else tuple(found.advice)
        return cls(
            diagnosis=(ASK,) if found is None and plan is None else said or (ENOUGH,),
            narrowing="" if plan is None else f"To narrow the {plan.goal.replace('_', ' ')}",
            goal="" if plan is None or not tasks else goal(plan),
            steps=tasks,
            notes=() if plan is None else tuple(plan.sentences),
            how=HOW if tasks else "",
        )


def tasks_of(plan: Plan) -> tuple[str, ...]:
    """What to do, equal ones counted."""
    return tuple(
        f"{words}, {counted(count, 'time')}" if count > 1 else words
        for words, count in steps(plan.proposed)
    )


def goal(plan: Plan) -> str:
    """What the steps are for."""
    return (
        f"Now {stated(plan, plan.before)}. After the following, as segments of "
        f"{files(plan.proposed)}, expect {stated(plan, plan.after)}:"
    )
