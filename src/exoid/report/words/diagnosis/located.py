"""Where torques are missing, over an inertia that nobody knows."""

from dataclasses import replace

from exoid.mismatch.answer.diagnosis import Diagnosis
from exoid.mismatch.answer.over_inertia import guessed
from exoid.mismatch.evidence.location import Location, Missing, Region


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
