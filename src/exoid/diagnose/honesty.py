"""When the right answer is that this recording cannot tell."""

import numpy as np

from exoid.diagnose.bench import Bench
from exoid.diagnose.proof import Proof
from exoid.diagnose.search import Found
from exoid.diagnose.settle import Settled
from exoid.physics.term import SensorTerm

SHORTEST = 1.5  # s of movement in all, about one swing of a leg
QUIETEST = np.radians(8.0)  # rad, of movement: less is within straps and skin
PERIODS = 3  # different cycles that a claim about the leg needs
APART = 0.03  # relative, by which periods are different


def too_little(bench: Bench, found: Found) -> list[str]:
    """Why hardly anything could be seen in this recording, in sentences; none where it could."""
    reasons = []
    duration = sum(each.segment.time[-1] for each in bench.problem.movements)
    if duration < SHORTEST:
        reasons.append(
            f"{duration:.1f} s of movement are too short: record drops until the leg rests"
        )
    low, high = bench.range
    if high - low < QUIETEST:
        reasons.append(
            f"the leg moves by {np.degrees(high - low):.0f} deg only: release it from higher up"
        )
    return reasons


def unsure(bench: Bench, best: Settled, proof: Proof) -> list[str]:
    """Why what was found must not be claimed."""
    reasons = []
    sensors_only = all(issubclass(term, SensorTerm) for term in best.candidate.terms)
    if not proof.holds:
        where = "the recording's own end" if proof.in_time else "held-out segments"
        reasons.append(f"it does not predict {where} better than the model without it")
    movements = bench.problem.movements
    if all(each.voluntary for each in movements) and not sensors_only:
        periods = np.sort([each.period for each in movements])
        different = 1 + int(np.sum(np.diff(periods) > APART * periods[:-1]))
        if different < PERIODS:
            reasons.append(
                f"voluntary cycles of {different} different speed{'s' * (different > 1)} cannot "
                "tell the leg from the muscles: add passive drops, or cycles of three speeds"
            )
    return reasons
