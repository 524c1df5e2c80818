"""What motion alone leaves untold: whatever goes with the scale of the leg, and why."""

from dataclasses import replace

from exoid.fitting.misfit.uncertainty import HELD
from exoid.fitting.result.estimates.estimate import Estimate

NO_GAIN = (
    "the sidecar says that the torque's gain is unknown (torque_known = false): only the ratios to "
    "J are told"
)
SCALE_FREE = (
    "motion alone fixes only the ratios to J: record a drop with a known mass, measure the torque, "
    "or give body mass and height"
)
SCALE_FREE_RIG = (
    "motion alone fixes only the ratios to J: record it with a known mass, or with a measured "
    "torque that varies"
)
UNTOLD = "nothing in this recording tells it"
MASS_AND_DISTANCE = "motion shows only the product m l; one of them must come from elsewhere"
MISPLACED = (
    "the distance of the added mass, by which the leg is weighed, does not agree with how it moves"
)
UNLIKE = (
    "no leg of this body, as the tables of anatomy have it, moves like this: a drop with a known "
    "mass on the leg tells it, or its own m and l where they are known (shank_foot_mass_kg and "
    "com_distance_m of [subject])"
)
UNLESS_BENT = (
    "a leg of this body, as the tables of anatomy have it, moves like this only with a spring that "
    "is slack in a bent position: 'exoid fit --with stiffness_rest_angle' takes it so, a drop with "
    "a known mass on the leg tells it"
)
UNLIKE_ITS_BODY = UNLIKE, UNLESS_BENT
NOTHING_TELLS = SCALE_FREE, SCALE_FREE_RIG, UNTOLD, MASS_AND_DISTANCE  # which the loss shows itself
TOGETHER = (
    "the same mass was on in every segment, and nothing tells what it changes: add a drop without "
    "it, or leave it out of the sidecar, and the ratios are of both together"
)


def goes_with_scale(own: Estimate, ratio: Estimate, inertia: Estimate) -> Estimate:
    """A quantity that is a told `ratio` times J^(1 or -1): where nothing tells J, nothing tells it.

    Near zero it would seem told: there J moves it little, but only as it was guessed.
    """
    if inertia.shares is not None or ratio.shares in (None, HELD):
        return own
    return goes_untold(own, SCALE_FREE)


def goes_with_mass(own: Estimate, mass: Estimate) -> Estimate:
    """The COM distance, which motion shows as m l alone: near zero, too, nothing tells it where
    nothing tells m.
    """
    return own if mass.shares is not None else goes_untold(own, MASS_AND_DISTANCE)


def goes_untold(own: Estimate, reason: str) -> Estimate:
    """Without its value, but where that is known from elsewhere than the motion."""
    if own.shares in (None, HELD) or own.by_hand in ("fix", "prior"):
        return own
    return without_value(own, reason)


def without_value(own: Estimate, reason: str) -> Estimate:
    """The quantity that nothing tells, and why."""
    return replace(own, value=None, standard_error=None, shares=None, reason=reason, limited_by={})


def hidden(own: Estimate) -> bool:
    """Has it no value though the loss shows one, in a unit that is none, or by what is in doubt?
    Then no interval and no draw of it is told, either.
    """
    return own.value is None and own.reason not in NOTHING_TELLS


def reason_of(each: Estimate, rig: bool) -> Estimate:
    """With the reason why a rig's scale is untold, which no body has."""
    return replace(each, reason=SCALE_FREE_RIG) if rig and each.reason == SCALE_FREE else each


def with_reasons(parameters: dict[str, Estimate], rig: bool) -> dict[str, Estimate]:
    """Say of every missing value why it is missing."""
    scale_known = parameters["inertia"].value is not None

    def missing(name: str) -> str:
        if scale_known and name in ("mass", "com_distance"):
            return MASS_AND_DISTANCE
        return SCALE_FREE_RIG if rig else SCALE_FREE

    return {
        name: replace(each, reason=missing(name)) if each.value is None else each
        for name, each in parameters.items()
    }
