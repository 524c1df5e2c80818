"""Which of the candidates that were looked at along the motion are worth a simulation."""

from collections.abc import Sequence

from exoid.mismatch.screen.hypothesis import Hypothesis, Optimum
from exoid.mismatch.screen.optimise import enough, settle, strikes
from exoid.mismatch.screen.prepared_recording import PreparedRecording
from exoid.mismatch.search.found import size
from exoid.physics.term import holds

SHORT = 4  # candidates that run free, by what they explain pinned
REACH = 3.0  # times the best, within which running free may change the order
WORSE = 0.1  # of the noise's square, by which what is true does not come short along the motion


def ordered(settled: list[Optimum]) -> list[Optimum]:
    """The sound ones, by what they leave."""
    return sorted((one for one in settled if one.sound), key=lambda one: one.square)


def shortlist(ranked: list[Optimum]) -> list[Optimum]:
    """Those of the best whose order may change running free. What is simpler than the best one is
    always among them: with more parameters a wrong cause comes near sooner.
    """
    first = ranked[:SHORT]
    return [
        one for one in first if one.square < REACH * first[0].square or size(one) < size(first[0])
    ]


def foremost(left: Sequence[float], numbers: Sequence[int], most: int) -> list[int]:
    """Which of those that would leave so much with so many numbers, the best first, are worth it:
    `most` of them, and the best of what has fewer numbers than any of these and comes near.
    """
    first, others = range(len(left))[:most], range(len(left))[most:]
    fewest = min((numbers[each] for each in first), default=0)
    near = [each for each in others if numbers[each] < fewest and left[each] < REACH * left[0]]
    return [*first, *near[:1]]


def likeliest(prepared: PreparedRecording, some: list[Optimum]) -> list[Optimum]:
    """Those that may be true: where some explain all but noise along the motion, brought to their
    end there, they and what is smeared there, as dry friction.
    """
    if len(some) < 2 or not enough(prepared, some[0].square):
        return some
    ended = ordered(settle(prepared, [one.candidate for one in some])) or some
    most = ended[0].square + WORSE * prepared.samples
    return [one for one in ended if one.square < most or smeared(one.candidate)]


def smeared(candidate: Hypothesis) -> bool:
    """Does one of its terms act in moments between samples?"""
    return strikes(candidate) or any(map(holds, candidate.terms))
