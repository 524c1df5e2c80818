"""What rubs where a leg bears a mass is not taken for inertia: drops by SciPy, bare and loaded."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from exoid.fitting.data.segment import movement
from exoid.fitting.estimate import fit
from exoid.fitting.model.systematics import DAMPING_UNDER_LOAD, is_exact
from exoid.fitting.movements import movements_of
from exoid.fitting.result.systematics.limiting import limiting
from exoid.recordings.declared.protocol import Protocol
from exoid.recordings.declared.subject import Subject
from exoid.recordings.measured.segment import Segment
from exoid.recordings.recording import Recording
from fit_cases import NOISE

# A leg as anatomy has it: kg m^2, N m, N m/rad, N m s/rad.
INERTIA, MOMENT, STIFFNESS, DAMPING = 0.40, 10.6, 1.2, 0.27
PERSON = Subject(kind="leg", body_mass=72.0, height=1.76)
TIME = np.arange(240) * 0.01  # s
STARTS = np.radians([-15.0, -28.0])
MASS, NEAR, ANKLE = 2.0, 0.18, 0.38  # kg, m
WITHIN = 2.5  # standard errors


def drop(rng, start, mass, distance, *, damped=0.0, friction=0.0):
    """Eq. 9 by LSODA, with damping [N m s/rad] and dry friction [N m] that only the load makes."""
    inertia, moment = INERTIA + mass * distance**2, MOMENT + mass * 9.81 * distance
    damper, rubs = DAMPING + damped * (mass > 0), friction * (mass > 0)

    def rate(_, at):
        rubbed = damper * at[1] + rubs * np.tanh(at[1] / 5e-3)
        return [at[1], -(moment * np.cos(at[0]) + STIFFNESS * at[0] + rubbed) / inertia]

    motion = solve_ivp(rate, (0, TIME[-1]), [start, 0.0], "LSODA", TIME, rtol=1e-9, atol=1e-11).y
    noise = rng.normal(size=(2, TIME.size)) * [[NOISE.angle_noise], [NOISE.velocity_noise]]
    return Segment(TIME, raw_angle=motion[0] + noise[0], raw_angular_velocity=motion[1] + noise[1])


def session(seed=0, masses=(0.0, 0.0, MASS, MASS), distance=ANKLE, subject=PERSON, **load):
    """Drops of one recording with these masses on the leg."""
    rng = np.random.default_rng(seed)
    each = zip(np.resize(STARTS, len(masses)), masses, strict=True)
    segments = tuple(drop(rng, start, mass, distance, **load) for start, mass in each)
    subject = replace(subject, added_mass=masses, added_mass_distance=(distance,) * len(masses))
    return Recording(segments, subject, Protocol(kind="passive"), NOISE)


def off(each, truth):
    """How far an estimate is off, in its standard errors."""
    return abs(each.value - truth) / each.standard_error


@pytest.mark.slow
@pytest.mark.parametrize("load", [{"damped": 0.012}, {"friction": 0.03}])
def test_what_only_the_load_rubs_leaves_the_inertia_within_its_error(load):
    """Were damping taken for the same, J would be 12 % too high, by five of its errors and more."""
    found = fit(session(**load), multistart=4)
    assert off(found.parameters["inertia"], INERTIA) < WITHIN
    assert off(found.ratios["damping_over_inertia"], DAMPING / INERTIA) < WITHIN
    assert found.mountings[0].damping_under_load is not None
    assert found.mountings[0].damping_under_load.value > 0.0


@pytest.mark.slow
def test_where_nobody_says_that_damping_stays_it_limits_the_inertia_and_a_way_out_is_told():
    found = fit(session(), multistart=4)
    inertia = found.parameters["inertia"]
    assert off(inertia, INERTIA) < WITHIN
    assert inertia.limited_by is not None
    assert inertia.limited_by["damping_under_load"] > 0.3
    said = next(each for each in limiting(found) if "damping stays the same under load" in each)
    # g / G is where the mass alone swings as fast as the leg: there it changes nothing of G.
    assert f"at {9.81 / (MOMENT / INERTIA):.2f} m not at all" in said
    (alone, *_) = limiting(found, inertia)  # as a plan asks
    assert alone.rpartition(":")[2] == said.rpartition(":")[2]


@pytest.mark.slow
def test_near_the_knee_a_compact_mass_tells_the_inertia_whatever_rubs():
    """By m l g / J, which a mass at the ankle hardly changes: it swings as fast as the leg."""
    point = replace(PERSON, added_mass_gyration=0.0)
    near, far = (fit(session(distance=at, subject=point), multistart=4) for at in (NEAR, ANKLE))
    each = [one.parameters["inertia"] for one in (near, far)]
    assert all(off(one, INERTIA) < WITHIN for one in each)
    assert each[0].standard_error < 0.8 * each[1].standard_error


@pytest.mark.slow
def test_what_is_said_of_damping_under_load_narrows_the_inertia():
    said = {f"{name}_under_load_uncertainty": 0.0 for name in ("damping", "stiffness")}
    steady = fit(session(subject=replace(PERSON, **said)), multistart=4)
    usual = fit(session(), multistart=4)
    each = [one.parameters["inertia"] for one in (steady, usual)]
    assert each[0].standard_error < 0.5 * each[1].standard_error
    assert all(off(one, INERTIA) < WITHIN for one in each)


def test_only_what_bears_more_than_the_lightest_may_be_damped_otherwise():
    bare, light, heavy = movements_of([("one", session(masses=(0.0, 0.5, 2.0)))])
    each = [bare, light, heavy]
    assert [is_exact(one, "damping_under_load", each) for one in each] == [True, False, False]
    alike = movements_of([("one", session(masses=(0.5, 0.5)))])
    assert all(is_exact(one, "damping_under_load", alike) for one in alike)


def test_a_rig_has_a_spring_that_no_load_changes():
    made = session(subject=Subject(kind="rig"))
    known = movement(made, 2, "rig 2").systematics
    assert known.stiffness_under_load == 0.0
    assert known.damping_under_load == DAMPING_UNDER_LOAD
