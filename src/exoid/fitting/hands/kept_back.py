"""What may keep the first swing of a drop back, in words, and what to record to tell it."""

from exoid.fitting.data.movement import KeptBack

REFLEX = (
    "To tell a stretch reflex from a hand or an obstacle: let go at once, touch nothing, from "
    "several angles, some too low for the leg to be fast; EMG of the quadriceps."
)
AS: dict[KeptBack, str] = {
    "hand": "as where a hand lets go slowly or moves as it lets go, or a muscle holds the leg",
    "speed": "by what begins only once the leg is fast: it may be a stretch reflex (spasticity), "
    "or something that the leg meets, but no hand that lets go slowly",
    "filtered": "as where a filter, which this angle went through, blurs the release, or a hand "
    "lets go slowly: this recording cannot tell which",
    "neither": "though no energy of its fall is missing that a hand which lets go slowly, or a "
    "muscle, would take: as by an angle sensor that is not linear (a goniometer, an encoder off "
    "its axis, a camera), or a spring that grows stiffer, which both show in the largest swing",
    "unknown": "by what may be a stretch reflex (spasticity), or a hand that lets go slowly or "
    "moves as it lets go: this recording cannot tell which",
}
EVEN = (
    "To tell which: hold the sensor to known angles, as 0, 45 and 90 deg, and let go at once, from "
    "several angles."
)
UNFILTERED = "Give the angle as it was measured, and let go at once."
NEXT: dict[KeptBack, str] = {
    "hand": "Let go at once.",
    "speed": REFLEX,
    "filtered": UNFILTERED,
    "neither": EVEN,
    "unknown": REFLEX,
}


def what(by: KeptBack) -> str:
    """What a leg does in the first swing, and why."""
    does = "is kept back" if by != "neither" else "moves otherwise than in those behind it"
    return f"the leg {does}, {AS[by]}"
