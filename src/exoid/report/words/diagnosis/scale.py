"""What of a diagnosis goes with an inertia that nobody knows: shown over it, or not at all."""

from dataclasses import replace

from exoid.fitting.result.fit_result import FitResult
from exoid.mismatch.answer.diagnosis import Booked, Diagnosis
from exoid.mismatch.answer.over_inertia import OVER, guessed
from exoid.mismatch.evidence.location import Location, Missing, Region


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


def located(found: Diagnosis) -> Location:
    """Where torques are missing, in rad/s^2 over an inertia that nobody knows."""
    place = found.location
    if not guessed(found.before):
        return place
    inertia = place.inertia or found.inertia
    missing = [over(each, inertia) for each in place.missing]
    return replace(
        place, missing=missing, regions=[region(each, inertia) for each in place.regions]
    )


def over(each: Missing, inertia: float) -> Missing:
    """A segment's torque over J [rad/s^2]."""
    modelled = None if each.modelled is None else each.modelled / inertia
    return replace(each, torque=each.torque / inertia, band=each.band / inertia, modelled=modelled)


def region(each: Region, inertia: float) -> Region:
    """A stretch with its torque over J [rad/s^2]."""
    torque = each.torque / inertia
    towards = "extension" if torque > 0 else "flexion"
    said = f"{abs(torque):.2g} rad/s^2 towards {towards} are missing at {each.region}"
    return replace(each, torque=torque, description=said)
