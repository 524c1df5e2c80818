"""What a diagnosis says of the numbers of the leg."""

from exoid.fitting.result.fit_result import FitResult
from exoid.fitting.result.remarks.scale_remarks import of_scale
from exoid.mismatch.answer.diagnosis import Booked, Diagnosis
from exoid.mismatch.answer.over_inertia import OVER
from exoid.mismatch.novel.nameless import NAMELESS
from exoid.physics.term import name_of
from exoid.recordings.tables.sheet import listed
from exoid.report.words.text import in_words, quantity_words

SEEN = 0.01  # share of a number, from which on its change is worth a word
USUAL = {  # of a leg, in their units
    "damping": 0.3,
    "stiffness": 2.5,
    "gravity_moment": 12.0,
    "gravity_over_inertia": 27.0,
    "stiffness_over_inertia": 6.0,
    "damping_over_inertia": 0.7,
}
NO_LEG = (
    "its numbers are not to be used: with what was found the model still does not follow the "
    "recording, and no error says how wrong they are."
)
BESIDE = (
    "d, c and m l g are here beside the formula: what it has of the speed, the angle or gravity is "
    "not in them."
)


def beside(found: Diagnosis) -> list[str]:
    """What the numbers of the fit with what was found stand beside: a formula, or causes that it
    has and that are not certain.
    """
    if found.formula is not None:
        return [BESIDE]
    terms = [] if found.after is None else map(type, found.after.fitted_terms)
    nameless = set(map(name_of, NAMELESS))
    maybe = [
        in_words(name)
        for name in map(name_of, terms)
        if name not in found.selected
        and (name in nameless or any(name not in each.split(" + ") for each in found.equivalent))
    ]
    if not maybe:
        return []
    return [f"Not certain: {listed(maybe)}. The numbers above are what they are with that."]


def doubted(found: Diagnosis) -> list[str]:
    """Why no number of the leg is to be used, or those in N m are not."""
    lost = found.verdict == "mismatch" and found.changed and not found.fit.follows
    useless = [NO_LEG] if lost and found.formula is None else []
    return [*useless, *of_scale(found.fit.parameters, found.fit.segments)]


def settled(fit: FitResult) -> bool:
    """Does the recording tell the inertia, or has the user fixed it? Else it comes from tables, and
    is another one for each model.
    """
    inertia = fit.parameters["inertia"]
    return inertia.determined_by == "data" or inertia.by_hand == "fix"


def compared(found: Diagnosis, numbers: list[Booked]) -> list[Booked]:
    """Those of two models that differ by what was found: ratios to J where J is not settled."""
    ratios = [each for each in numbers if each.name.endswith(OVER)]
    others = [each for each in numbers if each not in ratios]
    both = settled(found.before) and settled(found.fit)
    return (others if both else ratios) or numbers  # of an older file there are no ratios


def tabled(found: Diagnosis, numbers: list[Booked]) -> list[Booked]:
    """The same for a table, which has ratios beside all that is settled."""
    both = settled(found.before) and settled(found.fit)
    return numbers if both else compared(found, numbers)


def booked(found: Diagnosis) -> str:
    """What the baseline had made of it: whatever changes by more than a percent. Ratios, where J
    is from tables: each model takes another one.
    """
    numbers = compared(found, found.booked)
    changes = [
        f"{named(found, each)} {each.before:.3g} -> {each.after:.3g} {each.unit}"
        for each in numbers
        if abs(each.after - each.before)
        > SEEN * max(abs(each.before), abs(each.after), USUAL[each.name])
    ]
    if not changes:
        stay = ", ".join(named(found, each) for each in numbers)
        return f"nothing: {stay} changed by less than 1 %."
    return f"{', '.join(changes)}."


def named(found: Diagnosis, each: Booked) -> str:
    """A ratio by its symbol, a number of the leg in words."""
    ratio = found.before.ratios.get(each.name)
    return quantity_words(each.name) if ratio is None else ratio.symbol
