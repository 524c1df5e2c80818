"""What the user should know of drops that something stops, or seems to stop."""

from collections.abc import Sequence

import numpy as np

from exoid.fitting.data.movement import Movement

SWING = 0.75  # s; a leg that is let go turns back after about half a second


def of_stopped(movements: Sequence[Movement]) -> list[str]:
    """That something stops the leg in every drop before it has swung to and fro."""
    ends = [each for each in movements if each.extent and each.extent.ended == "caught"]
    longest = max((float(each.segment.time[-1]) for each in ends), default=np.inf)
    if len(ends) < len(movements) or longest > SWING:
        return []
    places = np.degrees([each.angle[~np.isnan(each.angle)][-1] for each in ends])
    low, high = f"{places.min():.0f}", f"{places.max():.0f}"
    where = f"{low} deg" if low == high else f"{low} to {high} deg"
    return [
        f"every drop is stopped within {longest:.2g} s, at {where}, as by a hand, by what the leg "
        "meets there (a seat, a bench), or by dry friction (rigidity) that holds it, which is too "
        "short a swing to tell much of a leg. Touch nothing until it hangs still: if it stops "
        "there by itself and from wherever it is let go, it is friction"
    ]


def of_kept(movements: Sequence[Movement]) -> list[str]:
    """Which movements count only up to where a hand, or what the model lacks, seems to end them."""
    return [
        f"segment {each.name} counts only up to {each.segment.time[each.kept]:.2f} s after its "
        f"release: then it leaves the motion that all drops tell, as where {ending(each)}. Leave "
        "it alone until it hangs still."
        for each in movements
        if each.kept is not None
    ]


def ending(each: Movement) -> str:
    """Soft hands that its own motion does not show cannot be told from friction of another form."""
    if each.extent is not None and each.extent.ended == "caught":
        return "a hand stops the leg and keeps it"
    return "a hand stops the leg softly, or friction of another form than the model's holds it"
