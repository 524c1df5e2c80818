"""What the noise, and what the model misses, leave of the information that the data carry.

With the residual r = A dz + S u + e of every segment, and its weight w, the estimates scatter by

    H^-1 M H^-1,   H = sum w A'A,   M = sum w^2 A'(s^2 I + S K S')A,

the sandwich form, and H M^-1 H is the information that the data really carry. Noise s and process u
belong to the kind of segment: how a leg was moved at will says nothing of how it swings by itself.
"""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from exoid.fitting.misfit.gram import Gram
from exoid.fitting.misfit.gram_matrices import covariance
from exoid.fitting.misfit.missed import KINDS, Disturbance, Missed
from exoid.fitting.misfit.uncertainty import ROUNDING, whitening


def spoiled(found: Disturbance, grams: list[Gram], kinds: Sequence[str], size: int) -> Disturbance:
    """The same disturbance, with the information that it leaves to these segments.

    Each gram is of the cause of its kind.
    """
    plain, white, excess = (np.zeros((size, size)) for _ in range(3))
    for each, kind in zip(grams, kinds, strict=True):
        missed, weight = found.kinds[kind], found.scales[kind] ** -2
        fitted, cross = each.fitted[:-1, :-1], each.effect.T @ each.inside[:, :-1]
        process = cross.T @ covariance(each, missed.correlation_time) @ cross
        place = np.ix_(each.place, each.place)
        plain[place] += weight * fitted
        white[place] += (weight * missed.noise) ** 2 * fitted
        excess[place] += (weight * missed.noise) ** 2 * missed.ratio * process
    basis, unit = whitening(plain)
    inside = basis.T @ ((white + excess) / np.outer(unit, unit)) @ basis
    grown, axes = np.linalg.eigh(inside)
    grown = np.maximum(grown, ROUNDING)
    back = np.linalg.pinv(basis).T @ axes * unit[:, None]
    information = (back / grown) @ back.T
    return replace(found, information=information, widening=np.sqrt(grown))


def common(missed: Missed, kinds: Sequence[str]) -> Disturbance:
    """One for all kinds, before it is known what it leaves."""
    each = [kind for kind in KINDS if kind in kinds]
    return Disturbance(
        dict.fromkeys(each, missed), dict.fromkeys(each, 1.0), np.zeros((0, 0)), np.ones(1)
    )
