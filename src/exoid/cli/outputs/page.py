"""A report as the user gets it: gathered from what a command has found."""

from pathlib import Path
from typing import Any


def sources_of(taken, named) -> tuple[Any, ...]:
    """What was read, and the (name, recording) that was analysed of it."""
    from exoid.report.parts.case import Source

    return tuple(
        Source(name, recording, loaded.notes, loaded.quality)
        for loaded, (name, recording) in zip(taken, named, strict=True)
    )


def planned(result, subject):
    """What to record next for the inertia; None of a rig, which can be weighed."""
    from exoid.fitting.solve.program_cache import with_sound_programs
    from exoid.planning.plan import plan

    if subject.kind == "rig":
        return None
    return with_sound_programs(lambda: plan(result, subject, "inertia"))


def write_report(path: Path, sources, result, origin, **found) -> None:
    """The page of one fit, and of what else was found: told, diagnosis, plan."""
    from exoid.report.page import write_page
    from exoid.report.parts.case import Case

    write_page(Case(sources, result, origin, **found), path)
