"""A joint that yields by Dahl's law, made by SciPy, fitted by the law of Bouc and Wen."""

import numpy as np
from scipy.integrate import solve_ivp

from exoid.fitting.estimate import fit
from exoid.physics.terms.tissue.hysteresis import Hysteresis
from exoid.recordings.measured.segment import Segment
from legs import recording

GRAVITY, STIFFNESS, DAMPING, LEVEL, YIELD = 25.0, 3.0, 0.4, 0.35, np.radians(2.0)


def swung(start: float, seed: int) -> Segment:
    """z' = phi' (1 - z sgn phi') / phi_y (Dahl, 1968)."""

    def slope(_, state):
        angle, speed, bent = state
        pull = GRAVITY * np.cos(angle) + STIFFNESS * angle + DAMPING * speed + LEVEL * bent
        return speed, -pull, speed * (1 - bent * np.sign(speed)) / YIELD

    time, random = np.arange(0.0, 5.0, 0.01), np.random.default_rng(seed)
    found = solve_ivp(
        slope, (0.0, 5.0), (start, 0.0, 0.0), t_eval=time, rtol=1e-8, atol=1e-9, max_step=2e-3
    ).y
    return Segment(
        time,
        raw_angle=found[0] + 8e-4 * random.standard_normal(time.size),
        raw_angular_velocity=found[1] + 3e-3 * random.standard_normal(time.size),
    )


def test_errors_of_level_and_yield_angle_hold_that_a_joint_may_yield_by_another_law():
    """Without that they miss by 10 errors and more: the law leaves hardly more than noise."""
    drops = recording(swung(-0.2, 0), swung(-0.7, 1))
    found = fit(drops, multistart=2, terms=(Hysteresis,))
    assert found.follows
    known = found.of_terms
    for name, truth in (("level_over_inertia", LEVEL), ("yield_angle", YIELD)):
        one = known[f"hysteresis.{name}"]
        assert abs(one.value - truth) < 2 * one.standard_error
        assert one.standard_error < 0.3 * truth
