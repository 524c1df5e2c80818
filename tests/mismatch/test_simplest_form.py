"""A richer cause whose further numbers nothing tells is its simpler form."""

from dataclasses import replace
from unittest.mock import Mock

import equinox as eqx
import jax.numpy as jnp
import numpy as np
import pytest
from diagnosis_cases import FRICTION, session
from found_by_hand import explaining

from exoid.fitting.estimate import fit
from exoid.interchange.model.formulas import some_moment
from exoid.mismatch.prepare import prepare
from exoid.mismatch.screen.hypothesis import Hypothesis
from exoid.mismatch.screen.optimise import settle_free
from exoid.mismatch.screen.prepared_recording import PreparedRecording
from exoid.mismatch.search import found
from exoid.mismatch.search.rank import fewest
from exoid.mismatch.search.variants import extras, in_simplest_form
from exoid.physics.parameter import declarations
from exoid.physics.terms.device.coulomb_friction import CoulombFriction
from exoid.physics.terms.device.shaped_hysteresis import ShapedHysteresis
from exoid.physics.terms.device.stribeck_friction import StribeckFriction
from exoid.physics.terms.tissue.cubic_stiffness import CubicStiffness
from exoid.physics.terms.tissue.end_range_stiffening import EndRangeStiffening
from exoid.physics.terms.tissue.hysteresis import Hysteresis
from exoid.physics.terms.tissue.power_drag import PowerDrag
from exoid.physics.terms.tissue.quadratic_drag import QuadraticDrag
from exoid.physics.terms.tissue.slack_cubic_stiffness import SlackCubicStiffness

FALLING = StribeckFriction(*map(jnp.asarray, (0.15, 0.08, 0.4)))


def settled(friction, excess):
    """Drops of a leg with a brake and this friction, explained by both; the friction as one that
    falls with speed, sought from an excess [N m] near its own.
    """
    recordings = [("drops", session(friction, QuadraticDrag(np.array(0.05))))]
    prepared, base = prepare(fit(recordings, multistart=8), recordings, ())
    values = np.array([excess, 0.08, 0.4]), np.array([0.05])
    both = Hypothesis((StribeckFriction, QuadraticDrag), values, base.candidate.point)
    return prepared, settle_free(prepared, both)


def having(term, values):
    """The term with these values."""
    one = explaining(1000.0, term)
    return replace(one, candidate=replace(one.candidate, values=(np.asarray(values),)))


@pytest.mark.slow
@pytest.mark.parametrize(
    ("friction", "excess", "simple"), [(FRICTION, 0.01, True), (FALLING, 0.1, False)]
)
def test_friction_that_falls_by_nothing_is_coulombs_in_every_set(friction, excess, simple):
    prepared, found = settled(friction, excess)
    ended = in_simplest_form(prepared, found, [CoulombFriction, QuadraticDrag])
    first = CoulombFriction if simple else StribeckFriction
    assert ended.candidate.terms == (first, QuadraticDrag)


def test_what_a_simpler_form_has_not_and_may_be_none_is_found_behind_the_leg_and_other_causes():
    one = explaining(1000.0, QuadraticDrag, StribeckFriction)
    first = one.candidate.point.size + one.candidate.zero.size + 1
    assert extras(one, [CoulombFriction]) == {CoulombFriction: {first: 0.0}}
    assert extras(one, [CubicStiffness]) == {}


@pytest.mark.parametrize(("power", "error", "unsure"), [(1.6, 0.1, []), (1.6, 0.4, [PowerDrag])])
def test_drag_that_may_grow_as_speed_does_is_not_sure_to_be_drag(power, error, unsure, monkeypatch):
    one = having(PowerDrag, [0.05, power])
    size = one.candidate.unknowns.size
    variance = np.diag([0.0] * (size - 1) + [error**2])
    monkeypatch.setattr(found, "unscaled_covariance", lambda *_: variance)
    assert found.blurred(Mock(spec=PreparedRecording), one, 1.0) == unsure
    assert found.blurred(Mock(spec=PreparedRecording), one, 0.01) == []


@pytest.mark.parametrize(
    ("rich", "simple", "where"),
    [
        (PowerDrag, QuadraticDrag, {1: 2.0}),
        (ShapedHysteresis, Hysteresis, {2: 1.0, 3: 0.0}),
        (SlackCubicStiffness, CubicStiffness, {1: 0.0}),
    ],
)
def test_a_richer_cause_pushes_as_its_simpler_form_does_where_it_is_said_to(rich, simple, where):
    one = having(rich, np.full(len(dict(declarations(rich))), 1.6))
    first = one.candidate.point.size + one.candidate.zero.size
    plain = extras(one, [simple])[simple]
    assert plain == {first + at: value for at, value in where.items()}
    values = dict(zip(dict(declarations(simple)), (0.3, 0.1), strict=False))
    names = [name for name, _ in declarations(rich)]
    both = {names[at - first]: value for at, value in plain.items()} | values
    held = rich(**{name: jnp.asarray(value) for name, value in both.items()})
    few = simple(**{name: jnp.asarray(value) for name, value in values.items()})
    now, memory = some_moment(), jnp.full(rich.memory_size, 0.4)
    assert held.torque(now, memory) == pytest.approx(float(few.torque(now, memory)), rel=1e-6)
    grown = [each.memory_rate(now, memory) for each in (held, few)]
    assert eqx.tree_equal(*grown, rtol=1e-12)


@pytest.mark.slow
@pytest.mark.parametrize(("power", "named"), [(2.0, QuadraticDrag), (1.6, PowerDrag)])
def test_drag_whose_power_is_two_but_for_noise_is_quadratic_beside_another_cause(power, named):
    drag = PowerDrag(*map(jnp.asarray, (0.08, power)))
    recordings = [("drops", session(FRICTION, drag))]
    prepared, base = prepare(fit(recordings, multistart=8), recordings, ())
    values = np.array([0.1]), np.array([0.08, 1.9])
    both = Hypothesis((CoulombFriction, PowerDrag), values, base.candidate.point)
    ended = in_simplest_form(prepared, settle_free(prepared, both), [QuadraticDrag])
    assert ended.candidate.terms == (CoulombFriction, named)


def test_of_sets_that_leave_as_much_the_one_with_fewest_numbers_is_made_plainer():
    rich = explaining(990.0, CoulombFriction, EndRangeStiffening)
    plain, worse = (explaining(left, CoulombFriction, QuadraticDrag) for left in (1000.0, 1010.0))
    assert fewest([rich, worse, plain]) == [plain]
    assert fewest([]) == []
