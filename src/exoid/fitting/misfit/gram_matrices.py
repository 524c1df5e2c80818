"""One segment's sensitivities, residual, and the effects of what may disturb it, as a triangle.

A disturbance u(t) is linear between nodes: a torque that the model lacks, or an error of the
encoder. All that its statistics need of the samples are the inner products of these columns.
"""

from typing import Any

import numpy as np

from exoid.fitting.data.observation import Observation
from exoid.fitting.misfit.condensed import Condensed, Sensed, Triangles
from exoid.fitting.misfit.gram import UNIT, Cause, Gram
from exoid.physics.motion.step import Drive

Array = Any  # of NumPy or JAX
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


def nodes_of(durations: list[float]) -> np.ndarray:
    """The times of the nodes of every segment: (segment, node)."""
    count = node_count(max(durations))
    return np.stack([node_times(duration, count) for duration in durations])


def hats(time: Array, nodes: Array, xp: Any = np) -> Array:
    """Piecewise linear functions of `time`, one at every node, evenly apart: (node, time)."""
    spacing = nodes[-1] / (nodes.size - 1)
    return xp.maximum(0.0, 1 - xp.abs(time - nodes[:, None]) / spacing)


def pushes(time: Array, nodes: Array, xp: Any = np) -> Drive:
    """Unit torques at every node of a segment, at the stage times of every step."""
    before, after = time[:-1], time[1:]
    return Drive(*(hats(at, nodes, xp) for at in (before, (before + after) / 2, after)))


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


def gram(of: Triangles, number: int, cause: Cause, place: np.ndarray, nodes: np.ndarray) -> Gram:
    """What stands for one segment, for one cause."""
    inside, outside, count = of.inside[cause][number], of.outside[cause][number], nodes.size
    return Gram(place, inside[:, :count], inside[:, count:], outside, nodes)


def triangles(sensed: Sensed, seen: Observation, nodes: Array, xp: Any = np) -> Triangles:
    """The triangles of one segment. An error of the encoder is in the angle alone."""
    count = nodes.size
    fitted = xp.concatenate([sensed.columns, sensed.residual[None]])
    both = xp.concatenate([sensed.responses, fitted])
    by_torque = xp.linalg.qr(both.reshape(len(both), -1).T, mode="r")
    shape = UNIT["encoder"] * hats(seen.time, nodes, xp) * seen.angle_weight
    by_encoder = xp.linalg.qr(xp.concatenate([shape, fitted[..., 0]]).T, mode="r")
    rest = xp.concatenate([by_encoder[count:, count:], fitted[..., 1].T])
    return Triangles(
        inside={"torque": by_torque[:count], "encoder": by_encoder[:count]},
        outside={
            "torque": by_torque[count:, count:],
            "encoder": xp.linalg.qr(rest, mode="r"),
        },
    )


def matern(times: np.ndarray, correlated: Times) -> np.ndarray:
    """Covariance of a twice differentiable process of unit variance (Matern 5/2)."""
    between = np.abs(times[:, None] - times)
    apart = np.sqrt(5) * between / np.asarray(correlated)[..., None, None]
    return (1 + apart + apart**2 / 3) * np.exp(-apart)


def covariance(each: Gram, correlated: Times) -> np.ndarray:
    """Of the process at its nodes, for unit variance."""
    return matern(each.nodes, correlated) + JITTER * np.eye(each.nodes.size)
