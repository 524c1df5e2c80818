"""The node's filter of three states from its equations: constant acceleration, single precision.

x = (angle, rate, acceleration); F of a constant acceleration over one step; Q and R are diagonal;
angle and rate are taken in one after the other. The first sample is taken as it is.
"""

import numpy as np

STEP_NOISE = (1e-8, 1e-5, 0.6)  # Q per step
READING_NOISE = (8e-7, 1.2e-5)  # R: rad^2, (rad/s)^2
UNKNOWN = 100.0  # variance of the acceleration before anything was seen


def filtered(time: np.ndarray, angle: np.ndarray, rate: np.ndarray) -> np.ndarray:
    """Angle, rate and acceleration after each sample, (samples, 3)."""
    single = np.float32
    state = np.array([angle[0], rate[0], 0.0], single)
    spread = np.diag(np.array([*READING_NOISE, UNKNOWN], single))
    noise = np.diag(np.array(STEP_NOISE, single))
    out = [state]
    for k in range(1, time.size):
        h = single(time[k] - time[k - 1])
        onward = np.array([[1, h, h * h / single(2)], [0, 1, h], [0, 0, 1]], single)
        state, spread = onward @ state, onward @ spread @ onward.T + noise
        for row, reading in enumerate((angle[k], rate[k])):
            gain = spread[:, row] / (spread[row, row] + single(READING_NOISE[row]))
            state = state + gain * (single(reading) - state[row])
            spread = spread - np.outer(gain, spread[row])
        out.append(state)
    return np.array(out)
