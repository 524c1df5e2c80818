"""That nothing is missing but where movements begin or end, and nobody can say why there."""

from exoid.fitting.data.movement import Movement
from exoid.fitting.hands.kept_back import NEXT, names, unlike, what

SOONER = "Record from 0.3 s before the release on."
LONGER = "Leave the leg alone until it hangs still."


def begins_and_ends(movements: list[Movement]) -> list[str]:
    """Why the begins and ends of movements may differ from the rest; none where none does."""
    late = [each for each in movements if each.late]
    slow = [each for each in movements if each.slow]
    kept = [each.name for each in movements if each.kept is not None]
    reasons = []
    if late:
        longest = max(float(each.segment.time[each.late]) for each in late)
        reasons.append(
            f"nothing is missing but in the first {longest:.2f} s of segment {names(late)}: the "
            "recording begins as the leg is let go, and a hand, soft cuffs and play all begin like "
            "this"
        )
    if slow:
        odd = unlike(slow)
        longest = max(each.slow for each in odd)
        reasons.append(
            f"nothing is missing but in the first {longest:.2f} s behind the release of segment "
            f"{names(odd)}: there {what(odd[0].kept_back)}"
        )
    if kept:
        reasons.append(
            f"nothing is missing but at the end of segment {', '.join(kept)}, where a hand may "
            "have stopped the leg, or friction"
        )
    return reasons


def what_next(movements: list[Movement]) -> list[str]:
    """What to record to see these begins and ends."""
    said = [SOONER for each in movements if each.late]
    said += [NEXT[each.kept_back] for each in unlike(movements)]
    said += [LONGER for each in movements if each.kept is not None]
    return list(dict.fromkeys(said))
