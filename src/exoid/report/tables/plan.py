"""A plan as a person reads it, and as JSON."""

from collections.abc import Iterable
from itertools import groupby
from typing import Any

import numpy as np
from rich.console import Console

from exoid.files.counted import counted
from exoid.fitting.result.fit_result import FitResult
from exoid.planning.candidate_recordings import SWING
from exoid.planning.planned import Candidate, Plan
from exoid.recordings.declared.subject import Subject
from exoid.report.document.plain_json import plain, shown
from exoid.report.tables.table import Table, print_table, with_unit
from exoid.report.words.person import identity
from exoid.report.words.text import heading, note, say, shown_unit, with_digits, with_error

SHOWN = 8  # rows of single segments in the table
ROUNDING = 2  # digits of an error: what differs by less is as good


def print_plan(plan: Plan, console: Console, model: str = "", *, first: bool = False) -> None:
    """Where the goal stands, what to record, what it will be worth, and the rivals.

    `model` are the options by which the same model is fitted again; a `first` recording has no
    other to be fitted with.
    """
    heading(console, f"What to record next for {plan.goal} {plan.symbol}")
    say(console, f"Now:   {stated(plan, plan.before)}")
    if plan.proposed:
        say(console, f"After: {stated(plan, plan.after)}, expected with what follows")
        print_steps(plan.proposed, console, model, first=first)
        print_options(plan, console)
    note(console, plan.sentences)


def print_steps(
    proposed: list[Candidate], console: Console, model: str = "", *, first: bool = False
) -> None:
    """What to do, step by step."""
    together = "fit it together with what there is: exoid fit OLD NEW"
    then = "fit it: exoid fit NEW" if first else together
    heading(console, f"Record, as segments of {files(proposed)}")
    for number, (words, count) in enumerate(steps(proposed), start=1):
        times = f"{count} times: " if count > 1 else ""
        say(console, f"{number}. {times}{words}.", hanging=3)
    say(
        console,
        "Angles are of the knee, 0 straight, -90 hanging. Each time: hold still for 2 s, let "
        f"go without a push, hands off until the leg hangs still, {SWING:g} s at least. The "
        "person relaxes. Stop where knee or seat do not allow the swing. Then "
        f"{then}{model}.",
    )


def print_options(plan: Plan, console: Console) -> None:
    """The best single segments and those that are proposed, best first, and what each would leave
    alone; those that are as good in one row.
    """
    finite = [option for option in plan.options if np.isfinite(option.error)]
    rows = as_good((each.candidate, with_digits(each.error, ROUNDING)) for each in finite)
    known = {
        error: in_one_row(some, plan.proposed)
        for number, (error, some) in enumerate(rows.items())
        if number < SHOWN or {*some} & {*plan.proposed}
    }
    heading(console, "One segment more, and the error it would leave")
    if not known:
        say(console, f"No single segment tells {plan.symbol}: it takes two.")
        return
    columns = {
        "release": [*known.values()],
        f"error [{plan.unit}]" if shown_unit(plan.unit) else "error": [*known],
    }
    print_table(Table("", columns), console)
    if len({each.words for each in plan.proposed}) > 1:
        say(console, "Each by itself: what is proposed above tells more together.")


def as_good(each: Iterable[tuple[Candidate, str]]) -> dict[str, list[Candidate]]:
    """Candidates by what is written of them, in their order."""
    rows: dict[str, list[Candidate]] = {}
    for candidate, written in each:
        rows.setdefault(written, []).append(candidate)
    return rows


def in_one_row(some: list[Candidate], proposed: Iterable[Candidate] = ()) -> str:
    """Candidates that are as good: what is proposed of them, else the simplest, and how many are
    left.
    """
    named = [each for each in some if each in {*proposed}] or [min(some, key=simplicity)]
    others = len(some) - len(named)
    more = f", or {counted(others, 'other')} as good" if others else ""
    return " or ".join(each.words for each in named) + more


def simplicity(each: Candidate) -> tuple[float, float]:
    """What it costs the person who records it, the less the better."""
    return each.effort, each.motion.added_mass


def files(proposed: list[Candidate]) -> str:
    """A seat that is tilted anew is a recording of its own: it owns the error of its angle."""
    seats = {each.thigh_angle for each in proposed}
    return "one file" if len(seats) < 2 else "one file for each tilt of the seat"


def steps(proposed: list[Candidate]) -> list[tuple[str, int]]:
    """What to do, bare drops first, equal ones counted."""
    ordered = sorted(proposed, key=lambda each: (each.effort, each.words))
    return [(words, len(list(same))) for words, same in groupby(each.words for each in ordered)]


def stated(plan: Plan, error: float) -> str:
    """The value with an error, as far as there is one."""
    if not np.isfinite(error):
        return f"{plan.symbol} is not determined"
    slack = "" if plan.if_slack is None else f" (± {plan.if_slack:.2g} more if slack)"
    return with_unit(f"{plan.symbol} = {with_error(plan.value, error)}", plan.unit) + slack


def plan_document(
    plan: Plan, result: FitResult | None = None, subject: Subject | None = None
) -> dict[str, Any]:
    """The plan in SI units and radians, after the fit `result`; null where nothing is known."""
    return plain(
        {
            "subject": identity(subject or Subject()),
            "follows_recording": None if result is None else result.follows,
            "astray": None if result is None else result.astray,
            **shown(
                plan,
                before="standard_error_before",
                after="standard_error_after",
                stays="standard_error_that_stays",
            ),
            "proposed": [segment_document(each) for each in plan.proposed],
            "options": [
                {**segment_document(each.candidate), "standard_error": each.error}
                for each in plan.options
            ],
        }
    )


def segment_document(each: Candidate) -> dict[str, Any]:
    """A segment to record."""
    motion = each.motion
    return {
        "words": each.words,
        "kind": motion.kind,
        "start_angle_rad": float(motion.start_angle),
        "duration_s": motion.duration,
        "added_mass_kg": motion.added_mass,
        "added_mass_distance_m": motion.added_mass_distance or None,
        "thigh_angle_rad": float(each.thigh_angle),
    }
