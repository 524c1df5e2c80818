"""What every recording owned of sensors, seat, clock and added mass, with errors."""

import numpy as np

from exoid.fitting.model.coordinates import Coordinates, layout, quantities
from exoid.fitting.model.systematics import (
    LOOSE_CLOCK,
    OF_MASSES,
    OF_THE_GYRO,
    OF_THE_LOAD,
    OF_THE_MASS,
    OF_THE_REST,
    OWNED,
    SOMEWHERE,
)
from exoid.fitting.multistart.rare import undeclared
from exoid.fitting.multistart.search_result import SearchResult
from exoid.fitting.result.chief import WORDS
from exoid.fitting.result.estimates.basis import Basis
from exoid.fitting.result.estimates.estimate import Estimate
from exoid.fitting.result.estimates.moved import BEYOND, Moved
from exoid.fitting.result.estimates.owned import FIELDS, MOUNTING, in_no_unit
from exoid.fitting.result.fit_result import MountingFit
from exoid.fitting.result.remarks.added_mass_remarks import of_added_mass
from exoid.fitting.solve.problem import Problem

STEP = 1e-6  # of a coordinate, for the slope of what is told
LIKE_REST = (
    ", as it does where the thigh is tilted otherwise than is declared (thigh_angle_deg, 0 where "
    "nothing is said), where the spring is slack elsewhere than at full extension, where dry "
    "friction lets a leg come to rest beside its middle, or where the encoder or the gyro drifts"
)
MISSES = ", which may make up for what the model misses"
TOLD = 0.7  # of its prior's error: below it the recording has told something


def estimate_mountings(basis: Basis, moved: Moved) -> list[MountingFit]:
    """What every recording owned, where the recording tells more than was known before. Its error
    holds how far the fit may have `moved`.
    """
    problem, point = basis.problem, basis.ended.point
    laid = layout(point)

    def estimate(field: str, entry: int) -> Estimate | None:
        if not problem.estimates(field, entry) or in_no_unit(problem, field):
            return None
        at = int(getattr(laid.places.mounting, field)[entry])
        gradient = laid.units * (np.arange(laid.size) == at)
        error = float(np.hypot(basis.information.standard_error(gradient), moved.off(gradient)))
        unplaced = any(one.unplaced for one in problem.recordings[entry])
        always = field in OF_THE_GYRO or (field == "log_distance" and unplaced)
        if not (always or error < TOLD * problem.deviation_of(field)[entry]):
            return None
        here = float(getattr(point.mounting, field)[entry])
        below, value, above = outside(problem, field, entry, here + STEP * np.array([-1, 0, 1.0]))
        slope = (above - below) / (2 * STEP)
        return Estimate(
            *MOUNTING[FIELDS[field]],
            value=float(value),
            standard_error=float(error * slope) if np.isfinite(error) else None,
            shares=basis.information.shares(gradient),
        )

    found = [
        MountingFit(own[0].source, **{FIELDS[field]: estimate(field, entry) for field in OWNED})
        for entry, own in enumerate(problem.recordings)
    ]
    return [each for each in found if each.known]


def mountings_at(problem: Problem, point: Coordinates) -> dict[str, float]:
    """What every recording owns at a point, as it is told, by recording and name."""
    return {
        f"{own[0].source}.{FIELDS[field]}": float(
            outside(problem, field, entry, float(getattr(point.mounting, field)[entry]))
        )
        for field in problem.owned
        for entry, own in enumerate(problem.recordings)
        if problem.estimates(field, entry)
    }


def numbers_at(problem: Problem, point: Coordinates) -> dict[str, float]:
    """Of a point, by the names of a result; of voluntary segments the means, of what a recording
    owns with its name before it.
    """
    each = dict(zip(problem.quantities, quantities(point, np).tolist(), strict=True))
    for name in ("torque_amplitude", "torque_over_inertia"):
        own = [each[one] for one in problem.quantities_of(name)]
        each |= {name: float(np.mean(own))} if own else {}
    moment = {"gravity_moment": each["gravity_over_inertia"] * each["inertia"]}
    return each | moment | mountings_at(problem, point)


def beyond_belief(problem: Problem, ended: SearchResult, *, explained: bool) -> str | None:
    """Which recording the fit takes for what nobody declares, if it does; where the motion is
    `explained`, the ratios hold wherever a mass hangs. A clock as loose as many are is none, their
    errors hold what it does to them: there, or where no gyro is that a clock may make up for.
    """
    furthest, why = BEYOND, None
    let_go = any(each.kind == "passive" for each in problem.movements)
    misses = ended.disturbance.cause is not None
    loose = [] if any_gyro(problem) and not explained else undeclared(problem, "clock")
    for field in problem.owned:
        if field == "zero" and "gravity" in problem.absent:
            continue  # it is where the spring of a rig rests, which may be anywhere
        if field in (*OF_THE_LOAD, *OF_MASSES) or (field in OF_THE_MASS and explained):
            continue
        values, deviations = getattr(ended.point.mounting, field), problem.deviation_of(field)
        for entry in problem.estimated(field):
            usual = float(deviations[entry])
            if field == "clock" and entry in loose:
                usual = max(usual, LOOSE_CLOCK / BEYOND)
            away = abs(float(values[entry])) / usual
            if away > furthest:
                furthest = away
                size = (float(each[entry]) for each in (values, deviations))
                if field == "torque_zero" and not in_no_unit(problem, field):
                    size = (outside(problem, field, entry, each) for each in size)
                unit = "1" if in_no_unit(problem, field) else None
                why = off(field, *size, unit=unit) + made_up(field, let_go=let_go, misses=misses)
                if field in OF_THE_MASS:
                    why = of_added_mass(problem, ended, field, entry)
    return why


def any_gyro(problem: Problem) -> bool:
    return any(each.angular_velocity is not None for each in problem.movements)


def off(field: str, value: float, usual: float, unit: str | None = None) -> str:
    """What the fit takes it for, in the units of a coordinate; or in another `unit`."""
    said = f"it takes {WORDS[FIELDS[field]]} to be off by {told_as(field, value, unit)}"
    return f"{said}, where {told_as(field, usual, unit)} is usual"


def made_up(field: str, *, let_go: bool, misses: bool) -> str:
    """What else makes a fit take it for that, of a leg that was let go; of any that `misses`
    something.
    """
    if field in OF_THE_REST and let_go:
        return LIKE_REST
    return MISSES if misses else ""


def told_as(field: str, value: float, unit: str | None = None) -> str:
    """In a unit that people read."""
    unit = unit or MOUNTING[FIELDS[field]][2]
    if unit.startswith("rad"):
        return f"{np.degrees(value):.2g} {unit.replace('rad', 'deg')}"
    if unit == "N m":
        return f"{value:.2g} {unit}"
    return f"{100 * value:.2g} %"


def outside(problem: Problem, field: str, entry: int, at):
    """An entry of the mounting as it is told: the distance in m, the mass in kg."""
    if field == "torque_zero":
        return at * problem.recordings[entry][0].systematics.torque_reach
    if field not in OF_THE_MASS:
        return at
    each = next(one for one in problem.recordings[entry] if one.added_mass > 0)
    if field == "log_distance":
        return (SOMEWHERE if each.unplaced else each.added_mass_distance) * np.exp(at)
    if field == "log_added":
        return each.added_mass * np.exp(at)
    return np.sqrt(np.maximum(each.systematics.expected_extent + at, 0.0))
