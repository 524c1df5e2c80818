"""Ticks of many nodes: what the learner tells of them by NumPy, and files for the firmware's."""

from dataclasses import dataclass

import numpy as np
from float32_learned import learned
from float32_learner import Learner
from simulated_legs import Legs, Motion

from exoid.recordings.filter import learning

UNKNOWN, RATIOS = len(learning.UNKNOWNS), len(learning.RATIOS)
UPPER = UNKNOWN * (UNKNOWN - 1) // 2
SURE = 1.96  # standard errors that hold 95 of 100
EVERY = 10  # ticks between two times at which nodes tell
TOLD = np.dtype(
    [
        *((name, "<u4") for name in ("phase", "trust", "drops")),
        *(("mean", "<f4", UNKNOWN), ("variance", "<f4", UNKNOWN), ("upper", "<f4", UPPER)),
        *(("squares", "<f4"), ("counted", "<u4"), ("age", "<i4"), ("explained", "<u4")),
        *(("ratio", "<f4", RATIOS), ("error", "<f4", RATIOS), ("surprise", "<f4")),
    ]
)


@dataclass(frozen=True)
class Ticks:
    """What nodes see, by tick and node, in counts of EXO_FINE and of the gyro."""

    count: np.ndarray
    gyro: np.ndarray
    sees_angle: np.ndarray
    sees_rate: np.ndarray
    missed: np.ndarray

    @classmethod
    def sound(cls, count: np.ndarray, gyro: np.ndarray) -> "Ticks":
        """Of which none is lost; a whole number of times that nodes tell."""
        whole = len(count) // EVERY * EVERY
        seen = np.ones((whole, count.shape[1]), bool)
        return cls(count[:whole], gyro[:whole], seen, seen.copy(), np.zeros(seen.shape, int))

    def records(self) -> bytes:
        """For the firmware's programs: one node after the other, each forgetting the one before."""
        columns = [getattr(self, each).T for each in vars(self)]
        forget = np.zeros_like(columns[0])
        forget[:, 0] = 1
        return np.stack([*columns, forget], axis=-1).astype("<i4").tobytes()


def told_by_numpy(ticks: Ticks, every: int = EVERY) -> np.ndarray:
    """What the nodes tell, or would tell every so many ticks, by time and node."""
    size, nodes = ticks.count.shape
    told = np.zeros((size // every, nodes), TOLD)
    learner = Learner(nodes)
    columns = [each.astype(np.int32) for each in (ticks.count, ticks.gyro)]
    with np.errstate(all="ignore"):  # of a leg that is not moving nothing is used
        for tick in range(size):
            learner.take(
                columns[0][tick],
                columns[1][tick],
                ticks.sees_angle[tick],
                ticks.sees_rate[tick],
                ticks.missed[tick].astype(np.int32),
            )
            if tick % every == (every - 2) % every:
                tell(learner, told[tick // every])
    return told


def tell(learner: Learner, told: np.ndarray) -> None:
    found, now = learned(learner.said), learner.movement.now()
    values = {
        "phase": learner.phase,
        "trust": learner.trust(found),
        "drops": learner.drops,
        "mean": now.leg.mean.T,
        "variance": now.leg.variance.T,
        "upper": np.stack([now.leg.upper[row, k] for k in range(UNKNOWN) for row in range(k)], 1),
        "squares": now.squares,
        "counted": now.counted,
        "age": now.age,
        "explained": 1,
        "ratio": found.ratio.T,
        "error": found.error.T,
        "surprise": found.surprise,
    }
    for name, value in values.items():
        told[name] = value


def play(legs: Legs, motion: Motion, rng: np.random.Generator) -> np.ndarray:
    return told_by_numpy(Ticks.sound(*legs.sensed(motion, rng)))


def share_of_gravity(told: np.ndarray) -> np.ndarray:
    """The error of gravity by it."""
    return told["error"][..., 0] / told["ratio"][..., 0]


def covered(legs: Legs, told: np.ndarray) -> np.ndarray:
    """The share of the legs whose ratios are within 95 % intervals, ratio by ratio."""
    off = np.abs(told["ratio"].T - legs.ratios) / told["error"].T
    return (off < SURE).mean(axis=1)
