"""Does a recording that `plan` proposes leave the error that was promised?

Every leg, sensor, seat, clock and weight is drawn anew, SciPy swings it, and what the plan proposes
is recorded and fitted. Errors reached over errors promised have a root mean square of one.
"""
