"""A model that holds a formula comes back, though no class of that formula is in exoid."""

import subprocess
import sys
from dataclasses import replace
from typing import Any

import jax.numpy as jnp
import numpy as np
import pytest
from test_fit_json import fitted
from test_saved_result import plainly

from exoid.mismatch.novel.dictionary import Feature, dictionary
from exoid.mismatch.novel.formula import Formula, fitted_formula, term_of
from exoid.physics.leg import LegModel
from exoid.physics.motion.simulate import simulate
from exoid.physics.term import Term
from exoid.physics.torque import NoTorque
from exoid.report.saved.node import DocumentError
from exoid.report.saved.saved_result import load_result, save_result
from exoid.report.saved.unpack import class_of
from fit_cases import leg, state

BY_SPEED = next(each for each in dictionary() if each.family.words == "max(0, v)")
SHAPED = {each.family: each for each in dictionary()}.values()  # one of every family


def found(*features: Feature) -> Term:
    """A formula of these features, with values that no search begins at."""
    formula = Formula(features, np.linspace(-0.3, -0.2, len(features)), 0.97, 0.0)
    made: Any = term_of(formula)
    return made(*map(jnp.asarray, formula.values * (1 + 1e-9)))


def back(term: Term, path) -> Term:
    """The term, saved with a fit and loaded again."""
    save_result(replace(plainly(fitted()), fitted_terms=(term,)), path)
    (loaded,) = load_result(path).result.fitted_terms
    return loaded


@pytest.mark.parametrize("ending", [".nc", ".json"])
def test_every_feature_comes_back_with_its_values(tmp_path, ending):
    for each in SHAPED:
        term = found(each, BY_SPEED)
        again: Any = back(term, tmp_path / f"why{ending}")
        own: Any = type(again)
        assert own.formula.features == fitted_formula((term,)).features
        assert vars(again) == vars(term)


def test_a_leg_with_the_formula_of_a_saved_model_moves_alike(tmp_path):
    """Damping in extension alone, on a drop of 2 s: to the bit, it is the same function."""
    term = found(BY_SPEED)
    time, start = jnp.linspace(0.0, 2.0, 201), state(np.radians(-12))
    before, after = (
        simulate(LegModel(leg(), NoTorque(), jnp.zeros(()), (each,)), start, time).angle
        for each in (term, back(term, tmp_path / "why.nc"))
    )
    np.testing.assert_array_equal(before, after)


def test_a_class_that_spells_no_formula_is_refused():
    with pytest.raises(DocumentError, match="holds the class Formula, which exoid does not have"):
        class_of({"class": "Formula"}, [Term], ())


def test_a_torque_without_a_name_is_known_again_where_nobody_diagnoses():
    """As the numbers of a leg may be those beside a torque that fades."""
    asked = (
        "from exoid.physics.term import Term\n"
        "from exoid.report.saved.annotation import class_called\n"
        "print(class_called('FadingTorque', (Term,), ()).title)"
    )
    told = subprocess.run([sys.executable, "-c", asked], capture_output=True, text=True, check=True)
    assert told.stdout.strip() == "a torque that fades after the release"
