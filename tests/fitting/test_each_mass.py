"""Masses of one recording that do not hang alike: drops by SciPy."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from exoid.fitting.estimate import fit
from exoid.fitting.model.systematics import apart as place_among
from exoid.fitting.movements import movements_of
from exoid.recordings.declared.protocol import Protocol
from exoid.recordings.declared.subject import Subject
from exoid.recordings.measured.segment import Segment
from exoid.recordings.recording import Recording
from fit_cases import NOISE

# A leg as anatomy has it: kg m^2, N m, N m/rad, N m s/rad.
INERTIA, MOMENT, STIFFNESS, DAMPING = 0.40, 10.6, 1.2, 0.27
PERSON = Subject(kind="leg", body_mass=72.0, height=1.76)
TIME = np.arange(240) * 0.01  # s
MASSES, ANKLE = (0.0, 1.2, 2.4), 0.38  # kg, m
GYRATION = 0.05  # m, as it is expected


def drop(rng, mass, distance):
    """Eq. 9 by LSODA, with a mass at this distance."""
    inertia = INERTIA + mass * (distance**2 + GYRATION**2)
    moment = MOMENT + mass * 9.80665 * distance

    def rate(_, at):
        pull = moment * np.cos(at[0]) + STIFFNESS * at[0] + DAMPING * at[1]
        return [at[1], -pull / inertia]

    begin = [np.radians(-20.0), 0.0]
    motion = solve_ivp(rate, (0, TIME[-1]), begin, "LSODA", TIME, rtol=1e-9, atol=1e-11).y
    noise = rng.normal(size=(2, TIME.size)) * [[NOISE.angle_noise], [NOISE.velocity_noise]]
    return Segment(TIME, raw_angle=motion[0] + noise[0], raw_angular_velocity=motion[1] + noise[1])


def session(apart=0.0, masses=MASSES):
    """One drop with each mass: the lighter hangs lower by so much [m], the heavier higher."""
    rng, off = np.random.default_rng(0), (0.0, apart, -apart)
    each = zip(masses, off, strict=True)
    segments = tuple(drop(rng, mass, ANKLE + more) for mass, more in each)
    subject = replace(PERSON, added_mass=masses, added_mass_distance=(ANKLE,) * len(masses))
    return Recording(segments, subject, Protocol(kind="passive"), NOISE)


@pytest.mark.parametrize("apart", [0.005, -0.005])
def test_the_inertia_is_within_its_error(apart):
    """As far from each other as a tape may be wrong."""
    inertia = fit(session(apart), multistart=2).parameters["inertia"]
    assert abs(inertia.value - INERTIA) < 2 * inertia.standard_error
    assert inertia.standard_error < 0.05 * INERTIA


def test_one_mass_differs_from_no_other():
    problem = fit(session(masses=(0.0, 1.2, 1.2)), multistart=2).basis.problem
    assert not {"distance_apart", "extent_apart"} & {*problem.owned}
    several = movements_of([("one", session(masses=(0.0, 2.4, 1.2)))])
    assert [place_among(one, several) for one in several] == [0.0, 0.5, -0.5]
