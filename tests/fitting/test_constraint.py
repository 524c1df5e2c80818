"""Every limit, at it, inside and beyond."""

from dataclasses import fields, replace

import jax
import numpy as np
import pytest

from exoid.fitting.model.constraint import NEVER, violations
from exoid.fitting.model.limits import constraint_names, paper_limits, rig_limits
from exoid.fitting.model.prior_and_limits import leg_limits
from exoid.physics.anatomy import reach
from exoid.physics.leg import LegParameters
from exoid.physics.parameter import declarations
from exoid.recordings.declared.subject import Subject
from fit_cases import leg

NAMES = [entry.name for entry in fields(LegParameters)]
LIMITS = replace(paper_limits(), reach=np.asarray(reach(1.80)))  # Eq. 13, and its subject's reach
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


def test_eq_13_as_printed_takes_the_papers_result_for_a_leg():
    """It knows no reach: `--bounds paper` brings it back."""
    paper = leg(mass=4.929, inertia=0.736, com_distance=0.221, damping=0.162, stiffness=2.127)
    assert max(exceeded(paper, limits=leg_limits(Subject(), "paper")).values()) < 0


@pytest.mark.parametrize(
    ("body", "parameters"),
    [
        ((4.0, 0.55), (0.22, 0.0017, 0.075, 0.003, 0.02)),  # an infant
        ((20.0, 1.12), (1.2, 0.045, 0.16, 0.04, 0.3)),  # a child of six
        ((77.0, 1.80), (4.5, 0.44, 0.265, 8.0, 60.0)),  # a stiff and spastic knee
        ((200.0, 1.70), (11.0, 0.95, 0.25, 1.0, 8.0)),
        ((None, None), (0.22, 0.0017, 0.075, 0.003, 0.02)),
        ((None, None), (14.0, 1.6, 0.28, 8.0, 200.0)),
    ],
)
def test_limits_leave_room_for_every_human(body, parameters):
    person = Subject(kind="leg", body_mass=body[0], height=body[1])
    found = exceeded(leg(*parameters), limits=leg_limits(person))
    assert max(found.values()) < 0


def test_d_and_c_are_not_made_small_by_a_leg_without_inertia():
    """At one d / J a hundredth of the inertia leaves the limit as far away, however small d is."""
    limits = replace(LIMITS, upper=replace(LIMITS.upper, damping=np.asarray(0.0)))
    whole, light = (
        exceeded(leg(inertia=j, damping=j), limits=limits)["damping+"] for j in (0.4, 0.004)
    )
    assert whole == pytest.approx(light)


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
