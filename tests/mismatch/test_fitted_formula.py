"""A formula that was fitted, told with its own values."""

from typing import Any

import jax.numpy as jnp
import numpy as np
from diagnosis_cases import Detent

from exoid.fitting.solve.compiled.kept_program import own_sources
from exoid.mismatch.novel.dictionary import dictionary
from exoid.mismatch.novel.formula import Formula, fitted_formula, term_of
from exoid.physics.sensing.gyro_scale import GyroScale


def test_a_formula_is_found_behind_the_errors_of_sensors():
    """As of a spring that creeps, recorded with a gyro whose scale is 0.4 % off."""
    formula = Formula((next(iter(dictionary())),), np.array([1.0]), 0.97, 0.0)
    made: Any = term_of(formula)
    fitted = made(jnp.asarray(0.4), *map(jnp.asarray, formula.values[1:]))
    gyro: Any = GyroScale
    own = fitted_formula((gyro(jnp.asarray(0.004)), fitted))
    assert own.words.startswith("tau = 0.4 ")
    assert own.over(0.5).startswith("tau / J = 0.8 ")
    assert own.over(0.5).endswith(" rad/s^2")
    assert own.times(2.0).over(0.5).startswith("tau / J = 1.6 ")


def test_no_program_of_a_formula_is_kept_for_another_one():
    """All are classes of one name; a user's own term is known again by its file."""
    each = [term_of(Formula((one,), np.array([1.0]), 0.97, 0.0)) for one in [*dictionary()][:2]]
    assert [own_sources((one,)) for one in each] == [{None}, {None}]
    assert all(own_sources((Detent,)))
