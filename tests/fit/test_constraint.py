"""Every limit, at it, inside and beyond."""

from dataclasses import fields, replace

import jax
import numpy as np
import pytest

from exoid.fit.belief import leg_limits, rig_limits
from exoid.fit.constraint import NEVER, constraint_names, violations
from exoid.physics.leg import LegParameters
from exoid.physics.parameter import declarations
from fit_cases import leg

NAMES = [entry.name for entry in fields(LegParameters)]
LIMITS = leg_limits(1.80)
NO_TORQUE = np.zeros(1)


def exceeded(parameters, torque=NO_TORQUE, limits=LIMITS):
    """g by name; a parameter's lower bound comes first, its upper one has a `+`."""
    names = constraint_names(torque.size)
    upper = [*(["", "+"][n >= len(NAMES)] for n in range(2 * len(NAMES))), "", ""]
    upper += [*["+"] * torque.size, *["-"] * torque.size]
    found = np.asarray(violations(limits, parameters, torque))
    return dict(zip((n + sign for n, sign in zip(names, upper, strict=True)), found, strict=True))


def test_a_leg_of_the_tables_meets_every_limit():
    assert max(exceeded(leg()).values()) < 0


@pytest.mark.parametrize(("name", "said"), list(declarations(LegParameters)))
def test_a_parameter_is_limited_to_its_declared_range(name, said):
    for sign, bound, inwards in (("", said.lower, 1), ("+", said.upper, -1)):
        at, inside, beyond = (
            exceeded(replace(leg(), **{name: np.asarray(bound + inwards * step)}))[name + sign]
            for step in (0.0, 0.01, -0.01)
        )
        assert at == 0
        assert inside < 0 < beyond


def test_eq_12_and_the_reach_limit_the_inertia_from_both_sides():
    moment, reach = 4.5 * 0.26, float(LIMITS.reach)
    for name, edge, inwards in (
        ("m l^2 <= J", moment * 0.26, 1),
        ("J <= reach m l", reach * moment, -1),
    ):
        at, inside, beyond = (
            exceeded(leg(inertia=edge + inwards * step))[name] for step in (0.0, 0.01, -0.01)
        )
        assert abs(at) < 1e-14
        assert inside < 0 < beyond


def test_the_papers_result_is_no_leg():
    """m 4.929, J 0.736, l 0.221 (Eq. 15) needs mass 0.68 m from the knee."""
    paper = leg(mass=4.929, inertia=0.736, com_distance=0.221, stiffness=1.6)
    assert exceeded(paper)["J <= reach m l"] > 0
    assert exceeded(paper)["m l^2 <= J"] < 0


def test_a_torque_is_limited_either_way_in_every_segment():
    found = exceeded(leg(), np.array([260.0, -260.0, 3.0]))
    beyond = {name for name, value in found.items() if value > 0}
    assert beyond == {"torque_amplitude[0]+", "torque_amplitude[1]-"}


def test_a_rig_may_be_anything_that_makes_no_energy():
    strange = leg(mass=0.2, inertia=3.0, com_distance=-0.1, stiffness=-2.0, damping=-0.1)
    found = exceeded(strange, np.array([900.0]), rig_limits())
    assert {name for name, value in found.items() if value != NEVER} == {"damping"}
    assert found["damping"] > 0


def test_numpy_and_jax_agree():
    with_jax = violations(LIMITS, leg(), NO_TORQUE)
    plain = jax.tree.map(np.asarray, leg())
    assert np.array_equal(violations(LIMITS, plain, NO_TORQUE, np), with_jax)
