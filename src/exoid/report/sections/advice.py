"""What to record next, and what it will bring."""

from collections.abc import Iterator

from exoid.files.counted import counted
from exoid.planning.planned import Plan
from exoid.report.parts.case import Case
from exoid.report.sections.blocks import Block, Group, element
from exoid.report.sections.section import section
from exoid.report.tables.plan import files, stated, steps
from exoid.report.words.text import in_words
from exoid.report.words.typeset import typeset

HOW = (
    "Each time: hold still for 2 s, let go without a push, hands off until the leg hangs still. "
    "The person relaxes."
)
ASK = (
    "exoid plan says which recording would narrow a quantity most; exoid diagnose says whether "
    "the model lacks something, and what would show it."
)
ENOUGH = "The diagnosis asks for no further recording."


@section("advice", "What to record next")
def advice(case: Case) -> Iterator[Block]:
    """What tells rivals apart, and what narrows the inertia."""
    plan, found = case.plan, case.diagnosis
    if found is not None:
        yield found.advice or [ENOUGH]
    if plan is None:
        if found is None:
            yield [ASK]
        return
    yield element("h3", f"To narrow the {in_words(plan.goal)}")
    if plan.proposed:
        yield goal(plan)
        yield Group("ol", [element("li", typeset(each)) for each in tasks(plan)])
        yield element("p", HOW)
    yield plan.sentences


def tasks(plan: Plan) -> list[str]:
    """What to do, equal ones counted."""
    return [
        f"{words}, {counted(count, 'time')}" if count > 1 else words
        for words, count in steps(plan.proposed)
    ]


def goal(plan: Plan) -> str:
    """What the steps are for."""
    return (
        f"Now {stated(plan, plan.before)}. After the following, as segments of "
        f"{files(plan.proposed)}, expect {stated(plan, plan.after)}:"
    )
