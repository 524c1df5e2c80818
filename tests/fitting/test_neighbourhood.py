"""What is known around a point: derivatives that are written out, and where coordinates lie."""

from dataclasses import replace

import jax
import numpy as np

from exoid.fitting.data.conditioning_chain import Raw
from exoid.fitting.misfit.neighbourhood import declared_slopes, gradients
from exoid.fitting.model.coordinates import flattened, layout, take, typical, unflattened
from exoid.fitting.model.prior import mounting_residual
from exoid.fitting.model.prior_and_limits import believe
from exoid.fitting.movements import movements_of
from exoid.fitting.multistart.beginning.starts import coordinates, term_starts
from exoid.fitting.solve.pose import pose
from exoid.physics.terms.device.coulomb_friction import CoulombFriction
from fit_cases import BODY, DROP, recorded

LEG = np.array([[4.5, 0.42, 0.26, 0.33, 2.6, 0.0]])  # m, J, l, d, c, tau


def posed(*terms):
    movements = movements_of([("drop", recorded(DROP))])
    problem = pose(movements, believe(BODY), "1/T", Raw())
    starts = coordinates(LEG, movements, term_starts(terms, movements, 1))
    return problem, take(starts, 0)


def test_what_is_declared_tells_what_its_residual_says():
    """To rounding: both are exact."""
    problem, point = posed()
    prior = problem.belief.prior
    slopes = gradients(lambda at: mounting_residual(prior, at.mounting, np), point)
    assert slopes.shape[0] > 0
    np.testing.assert_allclose(declared_slopes(point, prior), slopes, rtol=1e-12)
    bare = replace(prior, mounting=None)
    assert declared_slopes(point, bare).shape == (0, slopes.shape[1])


def test_a_layout_is_that_of_the_structure_and_not_of_the_values():
    _, point = posed(CoulombFriction)
    laid, number = layout(point), np.arange(flattened(point).size)
    assert np.array_equal(flattened(laid.places), number)
    units = unflattened(laid.units, point)
    assert jax.tree.leaves(units.terms) == jax.tree.leaves(typical(point).terms)
    assert float(units.own.angle[0]) == float(typical(point).own.angle)
    assert layout(unflattened(2.0 * flattened(point), point)) is laid
    assert layout(posed()[1]) is not laid
