"""What is shown of a fit that does not follow its recording: no number that its model made."""

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

REFUSED = "the fit does not follow its recording: none of its numbers is to be used"


def without_numbers(result: Any) -> Any:
    """The fit as tables, figures, pages and documents show it: one that follows as it is.

    Of one that does not, the numbers of leg, torque, seat and sensors follow from a model that the
    recording refuses, and so do the other sets that would move it alike. How far each segment is
    missed stays, and what was fixed by the user.
    """
    if result.follows:
        return result
    torque, moment = result.torque_amplitude, result.gravity_moment
    return replace(
        result,
        parameters=of_each(result.parameters),
        ratios=of_each(result.ratios),
        terms={term: of_each(own) for term, own in result.terms.items()},
        torque_amplitude=torque and refused(torque),
        gravity_moment=moment and refused(moment),
        segments=[of_segment(each) for each in result.segments],
        mountings=[],
        multistart=replace(result.multistart, family={}, members={}),
    )


def of_each(known: Mapping[str, Any]) -> dict[str, Any]:
    return {name: refused(each) for name, each in known.items()}


def of_segment(each: Any) -> Any:
    """Without the torque that the model took for its drive."""
    torque = each.torque_amplitude
    return replace(each, torque_amplitude=torque and refused(torque))


def refused(each: Any) -> Any:
    """An estimate without its value, and why; one that the user fixed as it is."""
    if each.by_hand == "fix":
        return each
    return replace(
        each,
        value=None,
        standard_error=None,
        shares=None,
        reason=REFUSED,
        limited_by={},
        if_slack=None,
    )
