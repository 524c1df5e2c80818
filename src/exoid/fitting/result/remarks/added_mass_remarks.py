"""That a mass on the leg is another one, or hangs elsewhere, than is declared."""

from collections.abc import Callable
from math import exp, hypot, sqrt

from exoid.fitting.data.movement import Movement
from exoid.fitting.model.systematics import OF_THE_LOAD, OF_THE_MASS
from exoid.fitting.multistart.search_result import SearchResult
from exoid.fitting.solve.problem import Problem
from exoid.physics.anatomy.added_mass import UNUSUAL, same_swing
from exoid.physics.anatomy.expected import STRANGE

MEASURED = 0.005  # m, to which a distance is measured: no mass hangs elsewhere by less
AGREES = {True: "does not agree with", False: "hardly agrees with"}
HELD = (
    " ± of J, and of what goes with it, holds that the distance may be centimetres off: by so much "
    "more as it is more likely than such a mass."
)
MEASURE = (
    "Measure from the axis of the knee to the middle of the mass, and give added_mass_distance_m "
    "and added_mass_gyration_m."
)
MISSED = (
    "That may be what the model misses, as friction is: 'exoid diagnose' asks what; else measure "
    "from the axis of the knee to the middle of the mass."
)


def of_added_mass(problem: Problem, ended: SearchResult, field: str, entry: int) -> str:
    """What the fit takes the mass of a recording for, where it moves a `field` of its mounting too
    far. Its distance comes before its extent, which hardly anybody measures.
    """
    each, whose = loaded(problem, entry)
    found = found_of(problem, ended, entry)
    if field == "log_added":
        return (
            f"it takes the added mass{whose} to be {each.added_mass * exp(found(field)):.3g} kg, "
            f"where {each.added_mass:.3g} kg is declared"
        )
    return f"the added mass{whose} acts as one at {acting(each, found)}"


def misplaced(problem: Problem, ended: SearchResult) -> list[int]:
    """The recordings whose mass moves as hardly any would that hangs as declared."""
    return [entry for entry, far in away(problem, ended) if far > STRANGE]


def away(problem: Problem, ended: SearchResult) -> list[tuple[int, float]]:
    """By recording, how many standard deviations its mass is from what is declared or assumed.

    Motion shows one length of a mass, r + k^2 / r: r and k leave what is declared together.
    """

    def far(entry: int) -> float:
        found = found_of(problem, ended, entry)
        moved = [name for name in OF_THE_MASS if found(name)]
        return hypot(*(found(name) / problem.deviation_of(name)[entry] for name in moved))

    return [(entry, far(entry)) for entry in range(len(problem.recordings))]


def of_misplaced(problem: Problem, ended: SearchResult) -> list[str]:
    """Where each of the masses would hang that do not move as declared, and what to do."""
    said = []
    for entry, far in away(problem, ended):
        if far > UNUSUAL:
            each, whose = loaded(problem, entry)
            acts = f"it acts as one at {acting(each, found_of(problem, ended, entry))}"
            said.append(
                f"the declared distance of the added mass{whose} {AGREES[far > STRANGE]} how the "
                f"leg moves: {acts}. {MISSED if ended.disturbance.cause else MEASURE} The ratios "
                f"to J hold.{'' if far > STRANGE else HELD}"
            )
    return said


def of_under_load(problem: Problem, ended: SearchResult) -> list[str]:
    """Which legs are damped, or drawn back, clearly otherwise beside their mass than without."""
    said = []
    for name, words in zip(OF_THE_LOAD, ("damping", "stiffness"), strict=True):
        for entry in problem.estimated(name):
            share = found_of(problem, ended, entry)(name)
            usual = float(problem.deviation_of(name)[entry])
            if abs(share) > UNUSUAL * usual:
                said.append(
                    f"beside the added mass{loaded(problem, entry)[1]} the leg's {words} is "
                    f"{abs(share):.0%} {'higher' if share > 0 else 'lower'} than without it, where "
                    f"{usual:.2g} of 1 is believed: a hinge or a cuff rubs or squeezes there, or "
                    "the model misses something else. J is told by what is left without it."
                )
    return said


def loaded(problem: Problem, entry: int) -> tuple[Movement, str]:
    """The first movement of a recording with a mass, and whose that is, where there are several."""
    own = problem.recordings[entry]
    whose = f" of {own[0].source}" if len(problem.recordings) > 1 else ""
    return next(one for one in own if one.added_mass > 0), whose


def found_of(problem: Problem, ended: SearchResult, entry: int) -> Callable[[str], float]:
    """What the fit moves each number of a mounting by; 0 where it is none of its unknowns."""

    def found(name: str) -> float:
        estimated = problem.estimates(name, entry)
        return float(getattr(ended.point.mounting, name)[entry]) if estimated else 0.0

    return found


def acting(each: Movement, found: Callable[[str], float]) -> str:
    """Where a mass would act as it does by what was `found` of its mounting, beside where it is; by
    another radius of gyration where it swings as from there, and weighs as if it were elsewhere.
    """
    usual = each.systematics.expected_extent
    distance = each.added_mass_distance * exp(found("log_distance"))
    square = max(usual + found("extent"), 0.0)
    declared, at, extent = f"{each.added_mass_distance:.3g}", f"{distance:.3g}", sqrt(square)
    length = same_swing(distance, square, usual)
    swings, by = f"{length:.3g}", f"is the usual {sqrt(usual):.2g} m"
    as_declared = abs(length - each.added_mass_distance) < MEASURED
    if "extent" in each.systematics.declared:
        by = f"is the declared {sqrt(usual):.2g} m"
    if as_declared and swings != at:
        return (
            f"{at} m from the knee with a radius of gyration of {extent:.2g} m, where {declared} m "
            f"is declared, and that {by}"
        )
    said = f"{swings} m from the knee, where {declared} m is declared"
    if swings == at:
        return said
    return f"{said}, if its radius of gyration {by} (at {at} m it would be {extent:.2g} m)"
