"""A torque that no term of the library describes: a formula for it, by sparse regression.

A few features of a dictionary are regressed on what the baseline lacks, best feature first, and
their shapes are refined after each; each must earn its place.
"""

import numpy as np
from scipy.optimize import least_squares

from exoid.mismatch.evidence.locate import averaged, lacking
from exoid.mismatch.evidence.location import Missing
from exoid.mismatch.novel.dictionary import OF_ANGLE, Feature, dictionary, reshaped
from exoid.mismatch.novel.formula import Formula
from exoid.mismatch.screen.hypothesis import Hypothesis
from exoid.mismatch.screen.prepared_recording import PreparedRecording

MOST = 3  # features of a formula
WORTH = 0.02  # share that a further feature must explain
INDEPENDENT = 0.05  # s, after which a missing torque is a new value
TRIES = 40  # steps of a refinement


def describe(prepared: PreparedRecording, base: Hypothesis) -> list[Formula]:
    """Formulas for what the baseline lacks, each with a feature more, up to the sparsest good one.

    Along a motion that the baseline has drifted from, a last feature may only mend the first.
    """
    rows = [lacking(prepared, base, number) for number in range(prepared.segments)]
    return formulas_beside(baseline(prepared, rows), rows)


def formulas_beside(known: np.ndarray, rows: list[Missing]) -> list[Formula]:
    """The same for what these segments lack beside the columns that are `known`."""
    basis = np.linalg.qr(known)[0]
    target = beside(basis, np.concatenate([each.torque for each in rows])[:, None])[:, 0]
    starts = [each for each in dictionary() if met(each, rows)]
    left = beside(basis, table(starts, rows))
    size = np.linalg.norm(left, axis=0)
    usable = np.isfinite(size) & (size > 1e-9 * np.nanmax(size))
    formulas: list[Formula] = []
    chosen: tuple[Feature, ...] = ()
    residual = target
    for _ in range(MOST):
        gain = np.where(usable, np.abs(left.T @ residual) / np.where(usable, size, 1.0), 0.0)
        chosen = refined((*chosen, starts[int(np.argmax(gain))]), rows, basis, target)
        columns = beside(basis, table(chosen, rows))
        coefficients = np.linalg.lstsq(columns, target, rcond=None)[0]
        residual = target - columns @ coefficients
        formulas.append(formula(chosen, coefficients, columns, residual, target))
    best = min(formulas, key=lambda each: cost(each, rows))
    enough = [each.explained > best.explained - WORTH for each in formulas]
    return formulas[: enough.index(True) + 1]


def formula(chosen, coefficients, columns, residual, target) -> Formula:
    sizes = np.abs(coefficients) * np.linalg.norm(columns, axis=0)
    known = float(sizes @ [each.family.known for each in chosen] / sizes.sum())
    explained = float(1 - residual @ residual / (target @ target))
    return Formula(chosen, coefficients, explained, known)


def cost(one: Formula, rows: list[Missing]) -> float:
    """Schwarz's criterion: what a formula leaves, and what its parameters cost."""
    count = sum(each.time[-1] - each.time[0] for each in rows) / INDEPENDENT
    parameters = sum(1 + len(each.shape) for each in one.features)
    return count * np.log(max(1 - one.explained, 1e-6)) + np.log(count) * parameters


def refined(features, rows, basis, target) -> tuple[Feature, ...]:
    """The features with the shapes at which they leave least."""
    begin = np.concatenate([np.asarray(each.shape, float) for each in features])
    if not begin.size:
        return features
    place = reached(rows)
    bounds = [
        (place, *each.family.bounds[1:]) if each.family.units == OF_ANGLE else each.family.bounds
        for each in features
    ]
    lower, upper = np.array([pair for each in bounds for pair in each]).T

    def left(values):
        columns = beside(basis, table(reshaped(features, values), rows))
        return target - columns @ np.linalg.lstsq(columns, target, rcond=None)[0]

    found = least_squares(
        left, np.clip(begin, lower, upper), bounds=(lower, upper), x_scale="jac", max_nfev=TRIES
    )
    return reshaped(features, found.x)


def met(feature: Feature, rows: list[Missing]) -> bool:
    """Does the leg come where the feature acts?"""
    low, high = reached(rows)
    return feature.family.units != OF_ANGLE or bool(low <= feature.shape[0] <= high)


def reached(rows: list[Missing]) -> tuple[float, float]:
    """Lowest and highest angle [rad]."""
    angles = np.concatenate([each.angle for each in rows])
    return float(angles.min()), float(angles.max())


def table(features, rows: list[Missing]) -> np.ndarray:
    """Every feature along all segments, averaged as the missing torque is."""
    columns = [
        [
            averaged(one.of(each.angle, each.angular_velocity, each.time, np), each.width)
            for each in rows
        ]
        for one in features
    ]
    return np.stack([np.concatenate(each) for each in columns], axis=1)


def baseline(prepared: PreparedRecording, rows: list[Missing]) -> np.ndarray:
    """What the leg's own parameters, and the voluntary torque of each segment, can take up."""
    legs, pushes = [], []
    for number, each in enumerate(rows):
        leg = (np.cos(each.angle), each.angle, each.angular_velocity)
        legs.append(np.stack([averaged(one, each.width) for one in leg], axis=1))
        shape = np.asarray(prepared.seen.cycle.begin[number])
        push = np.zeros((each.angle.size, len(rows)))
        push[:, number] = averaged(np.append(shape, shape[-1])[: each.angle.size], each.width)
        pushes.append(push)
    columns = np.concatenate([np.concatenate(legs), np.concatenate(pushes)], axis=1)
    return columns[:, np.abs(columns).max(axis=0) > 0]


def beside(basis: np.ndarray, columns: np.ndarray) -> np.ndarray:
    """What an orthonormal basis cannot take up."""
    return columns - basis @ (basis.T @ columns)
