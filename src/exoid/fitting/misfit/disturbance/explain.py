"""What is in the residual of a fit: the sensors' white noise, and what the model misses.

A torque that the model lacks moves the leg along with what its parameters do, so most of its
effect hides in the parameters and little is left in the residual: neither its size nor its
autocorrelation can tell how wrong they are. Here the missing torque, or a slow error of the
encoder, is a Gaussian process u(t) with a Matern covariance; its size and correlation time are
those of greatest restricted likelihood (Patterson & Thompson, Biometrika 58(3), 1971), which allows
for what the parameters absorbed.
"""

import numpy as np

from exoid.fitting.misfit.disturbance.likelihood import Likelihood
from exoid.fitting.misfit.gram import CAUSES, UNIT, Cause, Grams
from exoid.fitting.misfit.missed import Missed

CORRELATED = (0.025, 0.05, 0.1, 0.2, 0.4, 0.8)  # s
CLEAR = 4.0  # gain of log likelihood below which the noise alone explains the residual
# Gain at a decade's grid from which on it is worth to look closer: that shows about half of what is
# between its points, for however few or many nodes.
PROMISING = CLEAR / 4


def explain(grams: list[Grams], most: dict[Cause, float], samples: int, size: int) -> Missed:
    """The noise and the process of greatest restricted likelihood.

    The unknowns of the segments are among `size` coordinates. `most` bounds the deviation: what
    nearly hides in the parameters may else grow without limit.
    """

    each: dict[Cause, Likelihood] = {
        cause: Likelihood([one[cause] for one in grams], np.array(CORRELATED), samples, size)
        for cause in CAUSES
    }
    plain = float(each["torque"](np.zeros(1))[0, 0])
    found: tuple[Cause | None, int, float] = (None, 0, 0.0)
    best = plain + CLEAR
    for cause, likelihood in each.items():
        bound = (most[cause] / UNIT[cause]) ** 2
        ratios, values = likelihood.greatest(bound, plain + PROMISING)
        top = int(np.argmax(values))
        if values[top] > best:
            best = float(values[top])
            found = cause, top, float(ratios[top])
    cause, top, ratio = found
    noise = float(each[cause or "torque"].noise_beside(ratio)[top])
    return Missed(cause, CORRELATED[top], ratio, noise, best)
