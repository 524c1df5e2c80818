"""Asks a study everything that a report shows."""

from collections.abc import Callable
from dataclasses import replace
from math import isfinite, nan
from typing import TypeVar

from exoid.studies.statistics.agreement import Agreement, agreement
from exoid.studies.statistics.asked import Answer, Answers, Asked
from exoid.studies.statistics.groups import compare_groups
from exoid.studies.statistics.multiple import corrected, tested_as
from exoid.studies.statistics.pairs import Pairs, pairs_of
from exoid.studies.statistics.physics import missing_physics
from exoid.studies.statistics.presence import presence
from exoid.studies.statistics.reliability import reliability
from exoid.studies.statistics.tables.said import NotTold, Untold
from exoid.studies.statistics.tables.study import Study
from exoid.studies.statistics.tables.values import PERSONAL, Values, values_of
from exoid.studies.statistics.visits.exchanged import exchanged

Result = TypeVar("Result")
TESTED = ("sides", "change", "groups", "change_by_group")


def ask(study: Study, asked: Asked) -> Answers:
    """Every answer, or why there is none.

    **Raises** `ValueError` (what, and what there is) for a quantity, a column or a session that the
    tables do not have.
    """
    asked = known(study, asked)
    answers, silent = [], {}
    for quantity in dict.fromkeys((*asked.primary, *(asked.quantities or study.of_legs))):
        try:
            values = values_of(study, quantity, asked.task)
        except NotTold as why:
            silent[quantity] = str(why)
        else:
            answers.append(answer(study, values, asked))
    physics = answered(lambda: missing_physics(study, asked.by))
    turned = exchanged(study, asked.task)
    return Answers(study, asked, with_corrected(answers, asked), physics, silent, turned)


def known(study: Study, asked: Asked) -> Asked:
    """With columns as the tables call them."""
    check("quantity", (*asked.primary, *asked.quantities), study.told)
    sessions = tuple(sorted({*study.recordings["session"]} - {""}))
    check("session", [each for each in (asked.before, asked.after) if each], sessions)
    if bool(asked.before) != bool(asked.after) or (asked.before and asked.before == asked.after):
        raise ValueError("before and after are two different sessions: name both.")
    if asked.task:
        check("task", [asked.task], tuple(sorted({*study.recordings["task"]} - {""})))
    by, *adjust = (column_of(study, each) if each else "" for each in (asked.by, *asked.adjust))
    return replace(asked, by=by, adjust=tuple(adjust))


def column_of(study: Study, name: str) -> str:
    """`group` is `participant_group`, `age` is `age_years`."""
    columns = [each for each in study.recordings if each.startswith("participant_")]
    columns += [each for each in PERSONAL if each in study.recordings]
    for each in columns:
        if name in (each, each.removeprefix("participant_"), each.rpartition("_")[0]):
            return each
    short = tuple(each.removeprefix("participant_") for each in columns)
    check("column of participants", [name], short)
    return name


def check(what: str, wanted, there: tuple[str, ...]) -> None:
    for each in wanted:
        if each not in there:
            known = f"There is: {', '.join(there[:40])}." if there else "They have none."
            raise ValueError(f"{each!r}: the results have no such {what}. {known}")


def answer(study: Study, values: Values, asked: Asked) -> Answer:
    """Of one quantity; what changes between `before` and `after` is no test and retest."""
    steady = values if not asked.after else without(values, asked.after)
    first = values.where(session=asked.before) if asked.before else values
    change = changed = groups = None
    if asked.before:
        change = answered(lambda: paired(values, "session", asked.before, asked.after))
    if asked.by:
        groups = answered(lambda: compare_groups(first, asked.by, asked.adjust))
    if asked.by and isinstance(change, Agreement):
        pairs = change.pairs
        changed = answered(lambda: compare_groups(changes(values, pairs), asked.by, asked.adjust))
    whom = {*first.frame["person"]}
    if isinstance(change, Agreement):
        whom = {*change.pairs.frame.index}
    return Answer(
        values.quantity,
        values,
        presence(study, values, (asked.task, asked.by), whom),
        only_steady(answered(lambda: reliability(steady)), asked),
        answered(lambda: paired(first, "side", "left", "right")),
        answered(lambda: retested(steady)),
        change,
        groups,
        changed,
    )


def answered(work: Callable[[], Result]) -> Result | Untold:
    """What `work` gives, or why it gives nothing."""
    try:
        return work()
    except NotTold as why:
        return Untold(str(why))


def only_steady(found: Result | Untold, asked: Asked) -> Result | Untold:
    """Why there is no test and retest, where a session was left out of it."""
    if isinstance(found, Untold) and asked.after:
        return Untold(
            f"{found.why} {asked.after!r} does not count: something was to change by then."
        )
    return found


def paired(values: Values, column: str, first: str, second: str) -> Agreement:
    return agreement(pairs_of(values, column, first, second))


def retested(values: Values) -> Agreement:
    """The two sessions that most people share, in the order of their names."""
    shared = values.frame.groupby("session")["person"].nunique().sort_values(kind="stable")
    if len(shared) < 2:
        raise NotTold("All values are of one session.")
    return paired(values, "session", *sorted(shared.index[-2:]))


def without(values: Values, session: str) -> Values:
    frame = values.frame
    return Values(values.quantity, values.unit, frame[frame["session"] != session], values.notes)


def changes(values: Values, pairs: Pairs) -> Values:
    """The change of each person as a value of theirs."""
    people = values.frame.drop_duplicates("person").set_index("person")
    found = people.loc[pairs.frame.index].reset_index()
    found = found.assign(
        side="", session="", value=pairs.difference.to_numpy(), error=pairs.error.to_numpy()
    )
    return Values(values.quantity, values.unit, found)


def with_corrected(answers: list[Answer], asked: Asked) -> tuple[Answer, ...]:
    """Every p among those of its kind: of the primary quantities, and of the others."""
    first = [each for each in answers if each.quantity in asked.primary]
    others = [each for each in answers if each.quantity not in asked.primary]
    return (*family(first, asked), *family(others, asked))


def family(answers: list[Answer], asked: Asked) -> list[Answer]:
    """Every p among those of its kind of these quantities, and how many there are."""
    own = tested_as([each.quantity for each in answers])
    for kind in TESTED:
        raw = [getattr(getattr(each, kind), "p", nan) for each in answers]
        asked_of = [p if own[at] == at else nan for at, p in enumerate(raw)]
        known, count = corrected(asked_of, asked.correction), sum(map(isfinite, asked_of))
        among = [known[at] for at in own]
        answers = [
            replace(each, corrected={**each.corrected, kind: p}, among={**each.among, kind: count})
            if isfinite(p)
            else each
            for each, p in zip(answers, among, strict=True)
        ]
    return answers
