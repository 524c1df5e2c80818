"""A richer cause whose further numbers nothing tells is its simpler form."""

import jax.numpy as jnp
import numpy as np
import pytest
from diagnosis_cases import FRICTION, session
from found_by_hand import explaining

from exoid.fitting.estimate import fit
from exoid.mismatch.prepare import prepare
from exoid.mismatch.screen.hypothesis import Hypothesis
from exoid.mismatch.screen.optimise import settle_free
from exoid.mismatch.search.rank import fewest
from exoid.mismatch.search.variants import extras, in_simplest_form
from exoid.physics.terms.device.coulomb_friction import CoulombFriction
from exoid.physics.terms.device.stribeck_friction import StribeckFriction
from exoid.physics.terms.tissue.cubic_stiffness import CubicStiffness
from exoid.physics.terms.tissue.end_range_stiffening import EndRangeStiffening
from exoid.physics.terms.tissue.quadratic_drag import QuadraticDrag

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
    assert extras(one, [CoulombFriction]) == {CoulombFriction: [first]}
    assert extras(one, [CubicStiffness]) == {}


def test_of_sets_that_leave_as_much_the_one_with_fewest_numbers_is_made_plainer():
    rich = explaining(990.0, CoulombFriction, EndRangeStiffening)
    plain, worse = (explaining(left, CoulombFriction, QuadraticDrag) for left in (1000.0, 1010.0))
    assert fewest([rich, worse, plain]) == [plain]
    assert fewest([]) == []
