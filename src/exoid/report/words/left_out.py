"""Which part of the drops a fit left out, in seconds and swings."""

from collections.abc import Sequence

import numpy as np

from exoid.fitting.result.segment_fit import SegmentFit

TURNING = 0.5  # of a segment's greatest speed, below which it begins at a turn
TO_BACK = "the first swing, to and fro"
TO_TURN = "the first flexion, half a swing"
TO_FASTEST = "the first flexion up to its greatest speed, a quarter of a swing"


def left_out(segments: Sequence[SegmentFit]) -> str:
    """What was not fitted: first flexions, and what a hand did; empty where all was."""
    return "; ".join(filter(None, [first_flexions(segments), behind_hands(segments)]))


def behind_hands(segments: Sequence[SegmentFit]) -> str:
    """The drops that a hand or a muscle ended, or seems to where samples are lost."""
    names = [each.name for each in segments if each.caught is not None]
    segment = f"segment {', '.join(names)}"
    behind = f"{segment} from where a hand, muscle or lost samples end it"
    return behind if names else ""


def first_flexions(segments: Sequence[SegmentFit]) -> str:
    """Those that were not fitted; empty where all were."""
    short = [each for each in segments if each.left_out > 0]
    if not short:
        return ""
    names, longest = ", ".join(each.name for each in short), max(each.left_out for each in short)
    parts = {part(each) for each in short}
    least = next(one for one in (TO_FASTEST, TO_TURN, TO_BACK) if one in parts)
    return f"the first {longest:.2f} s behind the release of segment {names} ({least})"


def part(each: SegmentFit) -> str:
    """Up to where it was left out: it is fast at first, or turns up or down there."""
    speed = np.abs(each.simulated_velocity)
    fast = int(np.argmax(speed >= TURNING * np.nanmax(speed)))
    if fast == 0:
        return TO_FASTEST
    return TO_TURN if each.simulated_velocity[fast] > 0 else TO_BACK
