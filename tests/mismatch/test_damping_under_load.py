"""A diagnosis has damping and stiffness beside an added mass as the fit has them."""

from dataclasses import replace

import numpy as np

from exoid.fitting.data.observe import observe
from exoid.fitting.movements import movements_of
from exoid.mismatch.prepare import with_masses
from fit_cases import DROP, LOADED, UNMOVED, recorded


def test_what_a_load_rubs_is_no_missing_physics():
    seen = observe(movements_of([("one", recorded(DROP, LOADED))]), "1/T")
    found = {"damping_under_load": np.array([0.04]), "stiffness_under_load": np.array([-0.01])}
    told = with_masses(seen, replace(UNMOVED, **found), ())
    np.testing.assert_allclose(told.damped, [1.0, 1.04])
    np.testing.assert_allclose(told.stiffened, [1.0, 0.99])
