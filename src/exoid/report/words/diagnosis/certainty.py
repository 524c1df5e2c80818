"""How sure an answer is, and what else it may be."""

from exoid.mismatch.answer.diagnosis import Diagnosis
from exoid.mismatch.sensors.agreement import BIAS
from exoid.physics.library import library
from exoid.physics.term import Term, name_of
from exoid.report.words.text import causes_in_words

SUSPECTS = 3  # that are named
SENSOR_ZERO = "torque sensor whose zero is off"
CERTAIN = 0.001  # below this share a chance is written as "below"


def others(found: Diagnosis) -> list[str]:
    """What may act besides, and what it may be instead, where that is no exact twin."""
    named = set(found.selected)
    mine = named - {BIAS}  # a bias is free in every candidate, and has no rival
    each = [name.split(" + ") for name in found.equivalent]
    beside = [" + ".join(x for x in one if x not in named) for one in each if mine <= {*one}]
    rest = [one for one in each if not mine <= {*one} and not exact_twin(mine, {*one})]
    instead = [" + ".join(one) for one in rest]
    said = [f"besides it perhaps {', or '.join(filter(None, beside))}"] if any(beside) else []
    said += [f"or instead {', or '.join(instead)}"] if instead else []
    doubts = [f"{'; '.join(said)}: this recording cannot tell"] if said else []
    return [one.replace("_", " ") for one in doubts]


def twins(found: Diagnosis) -> dict[str, str]:
    """The titles of what looks exactly like one of the causes in every recording, by its name."""
    return {name_of(term): term.title for term in exact_twins(found)} | of_torque_sensor(found)


def of_torque_sensor(found: Diagnosis) -> dict[str, str]:
    """Its zero, which is a constant torque where a measured torque drove all of the recording: only
    where none is measured does such a torque act alone.
    """
    alike = like_its_zero(found, found.selected)
    return {"torque_zero": f"a {SENSOR_ZERO} by as much"} if alike else {}


def like_its_zero(found: Diagnosis, causes: list[str]) -> bool:
    """Is one of them a constant torque, where a measured torque drove all of the recording?"""
    steady = {name_of(term) for term in library() if term.steady}
    driven = all(each.kind == "measured" for each in found.before.segments)
    return driven and bool(steady & {*causes})


def exact_twins(found: Diagnosis) -> list[type[Term]]:
    """What looks exactly like one of the causes in every recording."""
    mine = set(found.selected) - {BIAS}
    known = {name_of(term): term for term in library()}
    each = [exact_twin(mine, {*name.split(" + ")}) for name in found.equivalent]
    return [known[name] for name in each if name]


def explanations_alike(found: Diagnosis) -> list[str]:
    """How each of them comes about."""
    return [f"Or ({twin.title}): {twin.explanation}" for twin in exact_twins(found)]


def exact_twin(mine: set[str], other: set[str]) -> str | None:
    """The one cause that is another there, where it is the same in every recording."""
    known = {name_of(term): term for term in library()}
    match [*(mine - other)], [*(other - mine)]:
        case [one], [twin] if one in known and twin in (known[one].twin, known[one].same_torque):
            return twin
    return None


def how_sure(found: Diagnosis) -> str:
    """Whether other data would say the same, and what else it may be."""
    share, weight = found.inclusion, found.weight
    held = "" if weight is None else f"explanations with it hold {certain(weight)} of the weight; "
    again = "" if share is None else f"with segments drawn anew, {share:.0%} say the same; "
    alike = "".join(f"{one}; " for one in others(found))
    return (
        f"{held}{again}{alike}chance alone would look like it in "
        f"{chance(found.false_alarm_rate)} of recordings, an effect of this size is found with a "
        f"chance of {certain(found.power)}."
    )


def suspected(found: Diagnosis) -> str:
    """The causes that it may be, of each of which a table says what it would make of the leg; where
    none explains most of it, what explains most.
    """
    ran = [one for one in (*found.singles, *found.pairs) if one.terms][:SUSPECTS]
    each = [one.terms for one in found.suspected or ran]
    said = ", ".join(by_push(each, found.equivalent)) + "."
    if not like_its_zero(found, [name for terms in each for name in terms]):
        return said
    return f"{said} A constant torque is here as a {SENSOR_ZERO}: read it with nothing on it."


def by_push(some: list[list[str]], equivalent: list[str]) -> list[str]:
    """Sets of causes in words; those that push alike whatever is recorded, and the twins that are
    `equivalent`, as one.
    """
    alike: dict[frozenset[str], list[list[str]]] = {}
    for each in some:
        alike.setdefault(pushes(each), []).append(each)
    for each in (one.split(" + ") for one in equivalent):
        known = alike.get(pushes(each), [])
        if known and {*each} not in [{*one} for one in known]:
            known.append(each)
    return [" or, exactly alike, ".join(map(causes_in_words, each)) for each in alike.values()]


def pushes(terms: list[str]) -> frozenset[str]:
    """What they are by their torques, each under the first of its names."""
    twin = {name_of(term): term.same_torque for term in library()}
    return frozenset(min(name, twin.get(name) or name) for name in terms)


def trust(found: Diagnosis) -> str:
    return (
        f"{tested(found)} chance makes one of them stand out in "
        f"{chance(found.false_alarm_rate)} of recordings."
    )


def tested(found: Diagnosis) -> str:
    """How many causes, and which of them a table lists."""
    some = ", and those that come closest are listed" if found.singles else ""
    return f"the {len(found.pinned)} causes that can act here were tested{some};"


def chance(share: float) -> str:
    return "fewer than 0.1 %" if share < CERTAIN else f"{share:.1%}"


def certain(share: float) -> str:
    return "above 99.9 %" if share > 1 - CERTAIN else f"{share:.1%}"
