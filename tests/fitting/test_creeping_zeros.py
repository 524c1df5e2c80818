"""What a fit tells of an encoder whose zero creeps, by SciPy."""

import numpy as np
from scipy.integrate import solve_ivp

from exoid.fitting.estimate import fit
from exoid.recordings.declared.protocol import Protocol
from exoid.recordings.declared.subject import Subject
from exoid.recordings.measured.segment import Segment
from exoid.recordings.recording import Recording

CREEP = 0.25  # deg/s


def creeping(start: float, rng) -> Segment:
    """A drop of 8 s, held for one before, whose angle creeps by 0 to 2 deg and whose gyro is
    right.
    """
    time = np.arange(900) / 100 - 1

    def slope(_, y):
        return y[1], -26.7 * np.cos(y[0]) - 6.0 * y[0] - 0.78 * y[1]

    leg = solve_ivp(slope, (0, 8.1), (np.radians(start), 0.0), rtol=1e-9, dense_output=True).sol
    angle, rate = leg(np.maximum(time, 0.0))
    seen = np.degrees(angle) + rng.normal(0, 0.1, time.size) + CREEP * np.maximum(time, 0.0)
    gyro = np.where(time < 0, 0.0, rate) + np.radians(rng.normal(0, 0.3, time.size))
    return Segment(time + 1, raw_angle=np.radians(seen), raw_angular_velocity=gyro)


def test_the_error_of_a_zero_holds_that_it_creeps():
    """Where a line is missing in the angle, tilt and zero make up for it."""
    rng = np.random.default_rng(2)
    drops = creeping(-15.0, rng), creeping(-40.0, rng)
    adult = Subject(kind="leg", body_mass=74.0, height=1.78)
    found = fit(Recording(drops, adult, Protocol(kind="passive")), multistart=2)
    for own in found.mountings:
        zero = own.known.get("zero")
        if zero is not None:
            assert abs(zero.value - np.radians(1.0)) < 2 * zero.standard_error
    (said,) = (each for each in found.notes if "with the knee extended, " in each)
    assert "or an angle that drifts looks alike" in said
