"""Where torques are missing, over an inertia that nobody knows."""

from dataclasses import replace

from exoid.mismatch.answer.diagnosis import Diagnosis
from exoid.mismatch.answer.over_inertia import guessed
from exoid.mismatch.evidence.location import Location


def located(found: Diagnosis) -> Location:
    """Where torques are missing, in rad/s^2 over an inertia that nobody knows."""
    place = found.location
    if not guessed(found.fit):
        return place
    over = 1 / (place.inertia or found.inertia)
    missing = [each.times(over) for each in place.missing]
    regions = [each.times(over, "rad/s^2") for each in place.regions]
    return replace(place, missing=missing, regions=regions)
