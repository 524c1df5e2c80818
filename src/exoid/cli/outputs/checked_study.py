"""What a look at a data set found, in lines for a person."""

from collections import defaultdict
from collections.abc import Iterator
from typing import TYPE_CHECKING

from exoid.files.counted import counted

if TYPE_CHECKING:
    from exoid.studies.dataset.check.check import Checked
    from exoid.studies.dataset.check.finding import Finding

SHOWN = 5  # of each kind; --json has all
MOST = 8  # sessions or devices
UNTOLD = "not told"


def lines(folder: str, found: "Checked") -> Iterator[str]:
    """What is there, what can be run, then what is wrong."""
    yield f"{folder}: {counted(found.recordings, 'recording')} of {people(found.people)}"
    yield f"  layout    {found.layout}"
    yield f"  sides     {counts(found.sides)}"
    yield f"  sessions  {counts(found.sessions)}"
    yield f"  devices   {counts(found.devices) or 'no recording was read'}"
    yield from can_be_run(found)
    for level, title in (("error", "Errors, to be mended"), ("warning", "Warnings, to be known")):
        of_level = [each for each in found.findings if each.level == level]
        if of_level:
            yield ""
            yield f"{title}:"
            yield from grouped(of_level)


def can_be_run(found: "Checked") -> Iterator[str]:
    all_read = found.read == found.recordings
    which = "" if all_read else f" (of {found.recordings}; --read reads more)"
    yield f"  read      {found.readable} of {found.read}{which}"
    yield f"  drops     in {found.drops} of those read: clinical measures can be told"
    ratios = f"; for {people(found.ratios_only)} ratios only" if found.ratios_only else ""
    yield f"  fit       and diagnose can be run on {found.readable} of those read{ratios}"


def grouped(findings: "list[Finding]") -> Iterator[str]:
    kinds: dict[str, list[Finding]] = defaultdict(list)
    for each in findings:
        kinds[each.kind].append(each)
    for kind, group in kinds.items():
        yield f"  {kind}: {len(group)}"
        yield from (f"    {each}" for each in shown(group))


def shown(group: "list[Finding]") -> Iterator[str]:
    """Where, and what is the matter; said once where it is the same of all."""
    if len(group) > 1 and len({each.says for each in group}) == 1:
        more = f" and {len(group) - MOST} more" if len(group) > MOST else ""
        yield f"{', '.join(each.where for each in group[:MOST])}{more}"
        yield group[0].says
        return
    by_cause = alike(group)
    for each in by_cause[:SHOWN]:
        where = f"{len(each)} alike, such as {each[0].where}" if len(each) > 1 else each[0].where
        yield f"{where}{': ' if where else ''}{each[0].says}"
    if len(by_cause) > SHOWN:
        left = sum(map(len, by_cause[SHOWN:]))
        yield f"and {left} more, all of them with --json FILE"


def alike(group: "list[Finding]") -> "list[list[Finding]]":
    """Those that many have in common together; of a few, each is shown with its numbers."""
    from exoid.studies.dataset.cause import cause

    causes: dict[str, list[Finding]] = defaultdict(list)
    for each in group:
        causes[cause(each.says)].append(each)
    many = [each for each in causes.values() if len(each) > SHOWN]
    return many + [[one] for each in causes.values() if len(each) <= SHOWN for one in each]


def counts(told: dict[str, int]) -> str:
    each = [f"{name or UNTOLD} {count}" for name, count in told.items()]
    more = f", and {len(each) - MOST} more" if len(each) > MOST else ""
    return ", ".join(each[:MOST]) + more


def people(count: int) -> str:
    return f"{count} {'person' if count == 1 else 'people'}"
