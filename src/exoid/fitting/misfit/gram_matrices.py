"""One segment's sensitivities, residual, and the effects of what may disturb it, as a triangle.

A disturbance u(t) is linear between nodes: a torque that the model lacks, or an error of the
encoder. All that its statistics need of the samples are the inner products of these columns.
"""

import numpy as np

from exoid.fitting.data.observation import Observation
from exoid.fitting.misfit.condensed import Condensed, Sensed
from exoid.fitting.misfit.gram import UNIT, Cause, Gram
from exoid.physics.motion.step import Drive

Times = np.ndarray | float  # s, of one process, or of several by a leading axis
SPACING = 0.125  # s between the nodes
NODES = (16, 128)  # at least and at most
JITTER = 1e-8  # of a unit variance, keeps a smooth covariance positive definite


def node_times(duration: float, count: int) -> np.ndarray:
    return np.linspace(0.0, duration, count)


def node_count(longest: float) -> int:
    """Enough nodes for the longest segment [s], in few different numbers."""
    wanted = -(-(longest / SPACING + 1) // NODES[0]) * NODES[0]
    return int(np.clip(wanted, *NODES))


def hats(time: np.ndarray, duration: float, count: int) -> np.ndarray:
    """Piecewise linear functions of `time`, one at every node: (node, time)."""
    spacing = duration / (count - 1)
    return np.maximum(0.0, 1 - np.abs(time - node_times(duration, count)[:, None]) / spacing)


def pushes(time: np.ndarray, durations: list[float]) -> Drive:
    """Unit torques at every node, at the stage times of every step; `time` is (segment, sample)."""
    count = node_count(max(durations))

    def at(times: np.ndarray) -> np.ndarray:
        return np.stack([hats(t, d, count) for t, d in zip(times, durations, strict=True)])

    return Drive(at(time[:, :-1]), at((time[:, :-1] + time[:, 1:]) / 2), at(time[:, 1:]))


def declared(residual: np.ndarray, derivative: np.ndarray) -> Gram:
    """What is declared of recordings, as if it were measured: nothing disturbs it."""
    rows = np.concatenate([derivative, residual[:, None]], axis=1)
    nothing = np.zeros((1, rows.shape[1]))
    return Gram(np.arange(derivative.shape[1]), np.zeros((1, 1)), nothing, rows, np.zeros(1))


def undisturbed(condensed: Condensed, number: int, scale: float, place: np.ndarray) -> Gram:
    """The triangle of one segment where no disturbance is asked for, from its residual over
    `scale`.
    """
    factor, projection = condensed.factor[number], condensed.projection[number]
    rows = np.zeros((len(place) + 1, len(place) + 1))
    rows[:-1, :-1], rows[:-1, -1], rows[-1, -1] = factor, projection, condensed.remainder[number]
    return Gram(place, np.zeros((1, 1)), np.zeros((1, len(rows))), scale * rows, np.zeros(1))


def gram(
    sensed: Sensed,
    seen: Observation,
    number: int,
    duration: float,
    cause: Cause,
    place: np.ndarray,
) -> Gram:
    """The triangle of one segment, for one cause."""
    used = (seen.angle_weight[number] > 0) | (seen.velocity_weight[number] > 0)
    fitted = np.concatenate([sensed.columns[number], sensed.residual[number][None]])[:, used]
    effect = sensed.responses[number][:, used]
    count = effect.shape[0]
    if cause == "encoder":
        shape = hats(seen.time[number][used], duration, count) * seen.angle_weight[number][used]
        effect = np.stack([UNIT[cause] * shape, np.zeros_like(shape)], axis=-1)
    columns = np.concatenate([effect.reshape(count, -1), fitted.reshape(len(fitted), -1)])
    triangle = np.asarray(np.linalg.qr(columns.T, mode="r"))
    inside = triangle[:count]
    nodes = node_times(duration, count)
    return Gram(place, inside[:, :count], inside[:, count:], triangle[count:, count:], nodes)


def matern(times: np.ndarray, correlated: Times) -> np.ndarray:
    """Covariance of a twice differentiable process of unit variance (Matern 5/2)."""
    between = np.abs(times[:, None] - times)
    apart = np.sqrt(5) * between / np.asarray(correlated)[..., None, None]
    return (1 + apart + apart**2 / 3) * np.exp(-apart)


def covariance(each: Gram, correlated: Times) -> np.ndarray:
    """Of the process at its nodes, for unit variance."""
    return matern(each.nodes, correlated) + JITTER * np.eye(each.nodes.size)


def modes(each: Gram, correlated: Times) -> tuple[np.ndarray, np.ndarray]:
    """Squared sizes of the process' independent effects, and the directions of each of them."""
    root = np.linalg.cholesky(covariance(each, correlated))
    axes, sizes, _ = np.linalg.svd(each.effect @ root)
    return sizes**2, axes
