"""What may keep the first swing of a drop back, in words, and what to record to tell it."""

from collections.abc import Sequence

from exoid.fitting.data.movement import KeptBack, Movement

REFLEX = (
    "To tell a stretch reflex from a hand or an obstacle: let go at once, touch nothing, from "
    "several angles, some too low for the leg to be fast; EMG of the quadriceps."
)
KEEPING: tuple[KeptBack, ...] = ("hand", "speed", "filtered", "unknown")  # the leg back
AS: dict[KeptBack, str] = {
    "hand": "as where a hand lets go slowly or moves as it lets go, or a muscle holds the leg",
    "speed": "by what begins only once the leg is fast: it may be a stretch reflex (spasticity), "
    "or something that the leg meets, but no hand that lets go slowly",
    "filtered": "as where a filter, which this angle went through, blurs the release, or a hand "
    "lets go slowly: this recording cannot tell which",
    "neither": "though no energy of its fall is missing that a hand which lets go slowly, or a "
    "muscle, would take: as where it is pushed, or a hand moves as it lets go, or as by an angle "
    "sensor that is not linear (a goniometer, an encoder off its axis, a camera), or a spring that "
    "grows stiffer or is slack in flexion, which show in the largest swing",
    "thrust": "as where it is pushed, a hand moves as it lets go, or a muscle twitches, but by no "
    "angle sensor and no spring: it passes the same angles in other swings without that",
    "thrust or spring": "as where it is pushed, a hand moves as it lets go, or a muscle twitches, "
    "or by a spring that is slack in flexion, or grows stiffer where only the largest swing comes, "
    "but by no angle sensor: the gyro agrees with it",
    "unknown": "by what may be a stretch reflex (spasticity), or a hand that lets go slowly or "
    "moves as it lets go: this recording cannot tell which",
}
EVEN = (
    "To tell which: hold the sensor to known angles, as 0, 45 and 90 deg, and let go at once, from "
    "several angles."
)
UNTOUCHED = "Let go at once, and touch nothing until the leg hangs still"
UNFILTERED = "Give the angle as it was measured, and let go at once."
NEXT: dict[KeptBack, str] = {
    "hand": "Let go at once.",
    "speed": REFLEX,
    "filtered": UNFILTERED,
    "neither": EVEN,
    "thrust": f"{UNTOUCHED}.",
    "thrust or spring": f"{UNTOUCHED}, from several angles.",
    "unknown": REFLEX,
}


def what(by: KeptBack) -> str:
    """What a leg does in the first swing, and why."""
    does = "is kept back" if by in KEEPING else "moves otherwise than in those behind it"
    return f"the leg {does}, {AS[by]}"


def unlike(movements: Sequence[Movement]) -> list[Movement]:
    """The drops whose first swings were left out for what they do; others began with them."""
    slow = [each for each in movements if each.slow]
    return [each for each in slow if each.kept_back != "alike"] or slow


def names(movements: Sequence[Movement]) -> str:
    return ", ".join(each.name for each in movements)
