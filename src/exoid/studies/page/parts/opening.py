"""What a study says first: its clearest answers, in a few sentences."""

from collections.abc import Iterator

from exoid.files.counted import counted
from exoid.recordings.tables.sheet import listed
from exoid.report.words.text import by_reason, capital, quantity_words
from exoid.studies.page.parts.correction import tested
from exoid.studies.page.parts.presence import rests, whose
from exoid.studies.page.parts.tables import failures
from exoid.studies.page.parts.words import (
    FEWEST,
    MAIN,
    SURE,
    TOO_FEW,
    cause_words,
    finding,
    grade,
    shares,
    sided,
)
from exoid.studies.statistics.agreement import Agreement
from exoid.studies.statistics.asked import Answers
from exoid.studies.statistics.physics import ALL, NOTHING, Cause
from exoid.studies.statistics.reliability import Reliability
from exoid.studies.statistics.tables.frames import Frame
from exoid.studies.statistics.tables.said import Untold
from exoid.studies.statistics.tables.study import OF_RELEASE
from exoid.studies.statistics.visits.exchanged import Exchanged

NAMED = 3  # quantities or causes of a sentence


def opening(answers: Answers) -> list[str]:
    """What differs, how well it repeats, which physics was missing, whose sides may be exchanged,
    and what failed.
    """
    untold = [*unanswered(answers)]
    if not answers.each:
        return [*untold, finding(answers), failed(answers.study.once)]
    parts = (difference(answers), repeats(answers), lacked(answers))
    said = (each for each in parts if each)
    return [*untold, *said, *map(turned, answers.exchanged), failed(answers.study.once)]


def unanswered(answers: Answers) -> Iterator[str]:
    """The questions from the start to which there is no answer, and why."""
    for name in answers.asked.primary:
        if name in answers.silent:
            yield (
                f"{capital(quantity_words(name))}, which was the question, is not told, and "
                f"nothing below answers it: {answers.silent[name]}"
            )


def difference(answers: Answers) -> str:
    """The finding, where groups or sessions were compared; else whether sides differ."""
    if any(kind in each.corrected for each in answers.each for kind in MAIN):
        return finding(answers)
    first = answers.each[0]
    why = [found.why for kind in MAIN if isinstance(found := getattr(first, kind), Untold)]
    whom = [said for said in (whose(first),) if why and said]
    return " ".join([*dict.fromkeys(why), *whom, *between_sides(answers)])


def between_sides(answers: Answers) -> Iterator[str]:
    """The first difference that is sure, or that none is."""
    each = tested([one for one in answers.each if isinstance(one.sides, Agreement)])
    sure = next((one for one in each if one.corrected["sides"] < SURE), None)
    if sure is not None and isinstance(sure.sides, Agreement):
        yield sided(sure.sides, sure.corrected["sides"], sure.among["sides"])
        yield rests(sure)
    elif each:
        count = counted(len(each), "quantity", "quantities")
        yield f"No difference between left and right is sure in any of {count}."


def repeats(answers: Answers) -> str:
    """The quantities by how well one day of them tells people apart; those that hang on the release
    only where there is no other.
    """
    asked = tested(answers.each)
    outcomes = [one for one in asked if one.quantity not in OF_RELEASE]
    each = [(one.quantity, one.reliability) for one in outcomes or asked]
    found = [(name, one) for name, one in each if isinstance(one, Reliability)]
    if not found:
        why = [one.why for _, one in each if isinstance(one, Untold)]
        return f"How well they repeat is not told: {why[0]}"
    if all(grade(one) == TOO_FEW for _, one in found):
        most = max(one.people for _, one in found)
        return (
            f"How well one day of one leg tells people apart, {most} people do not tell: at least "
            f"{FEWEST} are needed to call it anything. Intervals stand in the table."
        )
    graded = by_reason((quantity_words(name), grade(one)) for name, one in found)
    said = "; ".join(f"{word} for {listed(names, NAMED)}" for word, names in graded.items())
    return (
        "How well one day of one leg tells people apart, by the lower end of the interval of "
        f"ICC(A,1): {said}."
    )


def lacked(answers: Answers) -> str:
    """In how many recordings which physics was missing, and in whom; nothing where nobody was
    diagnosed.
    """
    if isinstance(answers.physics, Untold):
        return ""
    found = [each for each in answers.physics if each.group == ALL]
    named = [each for each in found if each.name not in NOTHING]
    shown = [*named[:NAMED], *(each for each in found if each.name in NOTHING)]
    said = "; ".join(map(in_whom, shown))
    recordings = counted(found[0].of_recordings, "recording")
    return f"Missing physics, of {recordings}: {said}."


def in_whom(each: Cause) -> str:
    """In how many recordings, and of a cause that has a name also in how many people."""
    said = f"{cause_words(each.name)} in {each.recordings}"
    if each.name in NOTHING:
        return said
    return f"{said}, of {each.people} of {each.of_people} people, {shares(each)}"


def turned(each: Exchanged) -> str:
    """Whose sides are exchanged at which visit, and what to do."""
    visits = ", ".join(each.sessions)
    which = f"of one of the visits {visits}" if len(each.sessions) > 1 else f"of visit {visits}"
    return (
        f"{each.person}: left and right {which} look exchanged: left moves as right does at the "
        "other visit, and the reverse, which makes test and retest, sides and changes wrong. See "
        "how the files were named, mend them, and run the study again."
    )


def failed(recordings: Frame) -> str:
    """How many recordings failed, and the reason that most of them have."""
    count = int((recordings["status"] == "failed").sum())
    if not count:
        return f"None of {counted(len(recordings), 'recording')} failed."
    most, names, reason = failures(recordings).rows[0]
    alike = recordings.loc[recordings["reason"] == reason, "name"]
    first = names if alike.empty else alike.iloc[0]
    which = first if count == 1 else f"{most} of them as {first}"
    said = f"{count} of {counted(len(recordings), 'recording')} failed"
    return f"{said}, {which}: {reason.rstrip('.')}."
