"""A fit that the tests share: a bare drop, one with a known mass, and a voluntary cycle."""

import pytest

from exoid.fitting.estimate import fit
from exoid.physics.terms.tissue.quadratic_drag import QuadraticDrag
from fit_cases import CYCLE, DROP, LOADED, recorded


@pytest.fixture(scope="session")
def fitted():
    return fit(recorded(DROP, LOADED, CYCLE), terms=(QuadraticDrag,), multistart=2)
