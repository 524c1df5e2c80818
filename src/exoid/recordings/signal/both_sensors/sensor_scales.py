"""How far a gyro's scale is usually off, and what a clock may be where the two disagree."""

GYRO_SCALE = 0.015  # LSM6DS3 data sheet: sensitivity within 1 %, and its change with temperature
DISAGREE = 5.0  # standard errors from which on encoder and gyro clearly disagree in scale
SCALED = 2e-3  # by which they disagree at least, for it to be worth a word
SUSPECTED = 0.6  # of a disagreement in scale: gyro, encoder's gain and clock may each hold it all
FARTHEST = 0.3  # of a rate: a polled loop, or a nominal rate that was taken for the true one


def suspected(off: float) -> float:
    """The standard deviation of a clock, as a share of 1, where it may be off by this or not."""
    return SUSPECTED * min(abs(off), FARTHEST)
