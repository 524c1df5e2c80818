"""What remains in a few segments alone: a hand touched the leg there, or only they come so far."""

import numpy as np
from jaxtyping import Float

from exoid.fitting.data.observation import Observation
from exoid.mismatch.evidence.yardstick import UNEXPLAINED
from exoid.mismatch.screen.hypothesis import Optimum
from exoid.mismatch.screen.optimise import FEWER_ROUNDS, FLOOR, settle_free
from exoid.mismatch.screen.prepared_recording import PreparedRecording

FEW = 1 / 3  # of the segments, in which something may have happened once
# Of the others' range, by which a segment goes beyond it: drops that begin within 3 deg of each
# other do by 0.02 at most, one that begins 14 deg and more above the others by 0.12 at least.
BEYOND = 0.04
TOUCHED = (
    "and physics of the leg acts in all of them: a hand may have touched it there. Leave it out, "
    "or record it again"
)
ONLY_THEN = (
    "what acts only then looks like that, as would a hand. Record the same movement again: what is "
    "of the leg comes back, what a hand did does not"
)


def once(prepared: PreparedRecording, best: Optimum) -> list[str]:
    """That the best explains all but a few segments: what happened there is no physics of the leg,
    which acts in all of them, where others come as far, as fast and with the same mass.
    """
    seen = prepared.seen
    counts = (seen.angle_weight > 0).sum(axis=1) + (seen.velocity_weight > 0).sum(axis=1)
    excess = best.products.each[:, -1, -1] - counts
    few, others = np.split(np.argsort(-excess), [int(FEW * counts.size)])
    if not few.size:
        return []
    kept = np.isin(np.arange(counts.size), others)
    left = settle_free(
        prepared, best.candidate, seen.weighed(kept[:, None]), rounds=FEWER_ROUNDS
    ).square
    if left > FLOOR * counts[others].sum():
        return []
    odd = [int(k) for k in sorted(few) if excess[k] > (UNEXPLAINED - 1) * counts[k]]
    if not odd:
        return []
    names = ", ".join(prepared.problem.movements[k].name for k in odd)
    alone = [how for k in odd for how in alone_in(seen, k, others.tolist())]
    return [f"what remains lies in segment {names} alone, {why(alone)}"]


def why(alone: list[str]) -> str:
    """What it may be, where these segments are alone in what they do, or in nothing."""
    if not alone:
        return TOUCHED
    how = " and ".join(dict.fromkeys(alone))
    return f"which {how} than the others: {ONLY_THEN}"


def alone_in(seen: Observation, number: int, others: list[int]) -> list[str]:
    """What a segment does that none of the others does, in words: they say nothing of that."""
    alike = [k for k in others if loaded(seen, k) == loaded(seen, number)]
    if not alike:
        return ["carries another mass"]
    reach, theirs = reach_of(seen, [number]), reach_of(seen, alike)
    room = BEYOND * (theirs[1] - theirs[0])
    beyond = (reach[0] < theirs[0] - room) | (reach[1] > theirs[1] + room)
    words = ("goes farther", "moves faster")
    return [word for word, more in zip(words, beyond, strict=True) if more]


def loaded(seen: Observation, number: int) -> tuple[float, float]:
    """The mass that a segment carries, and how far out."""
    return float(seen.added_mass[number]), float(seen.added_mass_distance[number])


def reach_of(seen: Observation, some: list[int]) -> Float[np.ndarray, "end channel"]:
    """The least and the largest angle [rad] and rate [rad/s] that these segments show."""
    each = []
    for shown, weight in (
        (seen.angle, seen.angle_weight),
        (seen.angular_velocity, seen.velocity_weight),
    ):
        values = np.asarray(shown)[some][np.asarray(weight)[some] > 0]
        each.append((values.min(), values.max()) if values.size else (0.0, 0.0))
    return np.transpose(each)
