"""What is in the residual of a fit: the sensors' white noise, and what the model misses.

A torque that the model lacks moves the leg along with what its parameters do, so most of its
effect hides in the parameters and little is left in the residual: neither its size nor its
autocorrelation can tell how wrong they are. Here the missing torque, or a slow error of the
encoder, is a Gaussian process u(t) with a Matern covariance; its size and correlation time are
those of greatest restricted likelihood (Patterson & Thompson, Biometrika 58(3), 1971), which allows
for what the parameters absorbed. With the residual r = A dz + S u + e the estimates then scatter by

    H^-1 M H^-1,   H = A'A,   M = A'(s^2 I + S K S')A,

the sandwich form, and H M^-1 H is the information that the data really carry.
"""

from dataclasses import dataclass
from typing import Literal

import numpy as np
from jaxtyping import Float

from exoid.fit.condense import Sensed
from exoid.fit.observation import Observation
from exoid.physics.simulate import Drive

Cause = Literal["torque", "encoder"]
CAUSES: tuple[Cause, ...] = ("torque", "encoder")

SPACING = 0.125  # s between the nodes of u(t), which is linear between them
NODES = (16, 128)  # at least and at most
CORRELATED = (0.025, 0.05, 0.1, 0.2, 0.4, 0.8)  # s
SIZES = np.logspace(-7, 4, 67)  # of u's variance over that of the noise; a fifth of a decade apart
CLEAR = 4.0  # gain of log likelihood below which the noise alone explains the residual
ANGLE_UNIT = 1e-2  # of a weight, so that sizes of both causes lie in one range
ROUNDING = 1e-11  # relative eigenvalue that is none
JITTER = 1e-8  # of a unit variance, keeps a smooth covariance positive definite


@dataclass(frozen=True, eq=False)
class Disturbance:
    """What besides white noise is in the residual of a fit; `cause` is None where nothing is."""

    cause: Cause | None
    correlation_time: float  # s
    deviation: float  # of u: rad/s^2 (times J a torque), or rad
    noise: float  # s, over the declared noise
    information: Float[np.ndarray, "coordinate coordinate"]  # H M^-1 H
    widening: Float[np.ndarray, " direction"]  # of the errors, along what the data determine

    @property
    def scale(self) -> float:
        """By how much errors are wider in the mean than the declared noise makes them."""
        return float(np.exp(np.log(self.widening).mean()))


@dataclass(frozen=True, eq=False)
class Gram:
    """Inner products of one segment: sensitivities A and residual r, and the process' effect S."""

    place: np.ndarray  # coordinates of the segment's unknowns
    fitted: np.ndarray  # (A, r)'(A, r)
    cross: np.ndarray  # S'(A, r)
    process: np.ndarray  # S'S
    nodes: np.ndarray  # s, times of the nodes


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


def explain(
    sensed: Sensed, seen: Observation, durations: list[float], columns: np.ndarray, size: int
) -> Disturbance:
    """The noise and the process of greatest restricted likelihood, and the information left.

    `columns` places every segment's unknowns among the `size` coordinates of the fit.
    """
    grams = {
        cause: [
            gram(sensed, seen, number, duration, cause, columns[number])
            for number, duration in enumerate(durations)
        ]
        for cause in CAUSES
    }
    samples = int((seen.angle_weight > 0).sum() + (seen.velocity_weight > 0).sum())
    alone = likelihoods(grams["torque"], CORRELATED[0], np.zeros(1), samples, size)[0]
    best = alone + CLEAR
    found: tuple[Cause | None, float, float] = (None, CORRELATED[0], 0.0)
    for cause in CAUSES:
        for correlated in CORRELATED:
            values = likelihoods(grams[cause], correlated, SIZES, samples, size)
            top = int(np.argmax(values))
            if values[top] > best:
                best = values[top]
                found = (cause, correlated, float(SIZES[top]))
    return described(*found, grams[found[0] or "torque"], samples, size)


def left_to(
    segment: int, sensed: Sensed, seen: Observation, duration: float, found: Disturbance
) -> np.ndarray:
    """The information on its own unknowns that one segment keeps where `found` acts on it too."""
    size = sensed.columns.shape[1]
    cause = found.cause or "torque"
    one = gram(sensed, seen, segment, duration, cause, np.arange(size))
    unit = ANGLE_UNIT if cause == "encoder" else 1.0
    ratio = (found.deviation / unit / found.noise) ** 2
    samples = int((seen.angle_weight[segment] > 0).sum())
    spoiled = described(cause, found.correlation_time, ratio, [one], samples, size)
    return spoiled.information / found.noise**2


def gram(
    sensed: Sensed,
    seen: Observation,
    number: int,
    duration: float,
    cause: Cause,
    place: np.ndarray,
) -> Gram:
    """The inner products of one segment, for one cause."""
    used = (seen.angle_weight[number] > 0) | (seen.velocity_weight[number] > 0)
    fitted = np.concatenate([sensed.columns[number], sensed.residual[number][None]])[:, used]
    effect = sensed.responses[number][:, used]
    count = effect.shape[0]
    if cause == "encoder":
        shape = hats(seen.time[number][used], duration, count) * seen.angle_weight[number][used]
        effect = np.stack([ANGLE_UNIT * shape, np.zeros_like(shape)], axis=-1)
    rows, process = fitted.reshape(len(fitted), -1), effect.reshape(count, -1)
    nodes = node_times(duration, count)
    return Gram(place, rows @ rows.T, process @ rows.T, process @ process.T, nodes)


def matern(times: np.ndarray, correlated: float) -> np.ndarray:
    """Covariance of a twice differentiable process of unit variance (Matern 5/2)."""
    apart = np.sqrt(5) * np.abs(times[:, None] - times) / correlated
    return (1 + apart + apart**2 / 3) * np.exp(-apart)


def modes(each: Gram, correlated: float) -> tuple[np.ndarray, np.ndarray]:
    """Squared sizes of the process' independent effects, and their products with (A, r)."""
    covariance = matern(each.nodes, correlated)
    root = np.linalg.cholesky(covariance + JITTER * np.eye(each.nodes.size))
    sizes, axes = np.linalg.eigh(root.T @ each.process @ root)
    return np.maximum(sizes, 0.0), axes.T @ root.T @ each.cross


def likelihoods(
    grams: list[Gram], correlated: float, ratios: np.ndarray, samples: int, size: int
) -> np.ndarray:
    """The restricted log likelihood for every variance ratio, the noise at its best."""
    decomposed = [modes(each, correlated) for each in grams]
    total = np.zeros((ratios.size, size + 1, size + 1))
    spread = np.zeros(ratios.size)
    for each, (sizes, cross) in zip(grams, decomposed, strict=True):
        grown = 1 + ratios[:, None] * sizes
        taken = np.einsum("mi,rm,mj->rij", cross, ratios[:, None] / grown, cross, optimize=True)
        place = np.append(each.place, size)
        total[:, place[:, None], place] += each.fitted - taken
        spread += np.log(grown).sum(axis=1)
    unit = np.sqrt(np.diagonal(total[:, :size, :size], axis1=1, axis2=2))
    used = (unit > 0).all(axis=0)
    unit = unit[:, used]
    normal = total[:, :size, :size][:, used][:, :, used] / (unit[:, :, None] * unit[:, None, :])
    values, vectors = np.linalg.eigh(normal)
    known = values > ROUNDING
    values = np.where(known, values, 1.0)
    along = np.einsum("rij,ri->rj", vectors, total[:, :size, size][:, used] / unit)
    left = total[:, size, size] - np.sum(known * along**2 / values, axis=1)
    freedom = samples - known.sum(axis=1)
    absorbed = np.log(values).sum(axis=1) + 2 * np.log(unit).sum(axis=1)
    return -(spread + absorbed + freedom * np.log(left / freedom)) / 2


def described(
    cause: Cause | None,
    correlated: float,
    ratio: float,
    grams: list[Gram],
    samples: int,
    size: int,
) -> Disturbance:
    """The information under this noise and process."""
    white, excess, weighted = (np.zeros((size + 1, size + 1)) for _ in range(3))
    for each in grams:
        place = np.ix_(np.append(each.place, size), np.append(each.place, size))
        sizes, cross = modes(each, correlated)
        white[place] += each.fitted
        excess[place] += ratio * cross.T @ cross
        weighted[place] += each.fitted - cross.T @ ((ratio / (1 + ratio * sizes))[:, None] * cross)
    basis, unit = whitening(white[:size, :size])
    gradient = (weighted[:size, size] / unit) @ basis
    normal = basis.T @ (weighted[:size, :size] / np.outer(unit, unit)) @ basis
    left = weighted[size, size] - gradient @ np.linalg.solve(normal, gradient)
    variance = max(1.0, left / (samples - basis.shape[1]))  # sensors are no better than declared
    inside = basis.T @ (excess[:size, :size] / np.outer(unit, unit)) @ basis
    grown, axes = np.linalg.eigh(variance * (np.eye(basis.shape[1]) + inside))
    back = np.linalg.pinv(basis).T @ axes * unit[:, None]
    return Disturbance(
        cause=cause,
        correlation_time=correlated,
        deviation=float(np.sqrt(ratio * variance)) * (ANGLE_UNIT if cause == "encoder" else 1.0),
        noise=float(np.sqrt(variance)),
        information=(back / grown) @ back.T,
        widening=np.sqrt(grown),
    )


def whitening(normal: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Directions along which `normal` is the identity, over the units of its diagonal."""
    diagonal = np.sqrt(np.diag(normal))
    unit = np.where(diagonal > 0, diagonal, 1.0)
    values, vectors = np.linalg.eigh(normal / np.outer(unit, unit))
    known = values > ROUNDING
    return vectors[:, known] / np.sqrt(values[known]), unit
