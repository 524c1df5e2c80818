"""Turns that an encoder leaves out: it shows 0 behind 359.9 deg, or -180 behind 179.9."""

import numpy as np
from numpy.typing import NDArray

from exoid.recordings.measured.samples import Samples

TURN = 2 * np.pi
QUICKEST = 20.0  # rad/s; a leg that falls makes 8
FASTER = 2.0  # times as fast as it is seen elsewhere, which a rig that spins may be at a jump
LEAST = np.radians(5.0)  # that noise and steps of an encoder make
AROUND = 0.25  # of a turn: what is left of a jump that is one


def turns_left_out(time: Samples, angle: Samples) -> NDArray[np.float64] | None:
    """What every sample of an angle [rad] lacks; None where it does not jump by turns, or also by
    anything else.
    """
    known = np.isfinite(angle)
    steps, lasted = np.diff(angle[known]), np.diff(time[known])
    jumps = np.round(steps / TURN)
    if not jumps.any() or np.ptp(angle[known]) > (1 + 1e-6) * TURN:
        return None
    moved = np.abs(steps - TURN * jumps)
    elsewhere = float(np.max(moved / lasted, where=jumps == 0, initial=0.0))
    quickest = max(QUICKEST, FASTER * elsewhere)
    sure = moved < np.minimum(LEAST + quickest * lasted, AROUND * TURN)
    if not sure.all():
        return None
    lacks = np.zeros(angle.size)
    lacks[np.flatnonzero(known)[1:]] = jumps
    return -TURN * np.cumsum(lacks)
