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
    "unknown": "by what may be a stretch reflex (spasticity), or a hand that lets go slowly or "
    "moves as it lets go: this recording cannot tell which",
}
UNFILTERED = "Give the angle as it was measured, and let go at once."
NEXT: dict[KeptBack, str] = {
    "hand": "Let go at once.",
    "speed": REFLEX,
    "filtered": UNFILTERED,
    "unknown": REFLEX,
}
