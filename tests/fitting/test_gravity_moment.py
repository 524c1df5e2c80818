"""m l g in N m: what a clinician reads, of the leg that the ratios and J make together."""

from math import hypot

import numpy as np
import pytest

from exoid.fitting.apart.fit_each import fit_each
from exoid.fitting.estimate import fit
from exoid.physics.leg import GRAVITY
from exoid.recordings.declared.subject import Subject
from fit_cases import DROP, LOADED, leg, recorded

TRUE = float(leg().mass * leg().com_distance) * GRAVITY  # N m
LIKELY = 4.0  # standard errors: one in 16 000


def of(result):
    gravity, inertia = result.ratios["gravity_over_inertia"], result.parameters["inertia"]
    return result.gravity_moment, gravity, inertia


@pytest.fixture(scope="module")
def weighed():
    return fit(recorded(DROP, LOADED), multistart=4)


def test_a_known_mass_tells_the_moment_of_gravity_as_well_as_the_inertia(weighed):
    moment, gravity, inertia = of(weighed)
    assert abs(moment.value - TRUE) < LIKELY * moment.standard_error
    assert moment.value == pytest.approx(gravity.value * inertia.value, rel=1e-9)
    assert (moment.unit, moment.determined_by) == ("N m", "data")


def test_its_error_is_between_what_its_factors_allow(weighed):
    """|a - b| <= s <= a + b for any correlation of them."""
    moment, *factors = of(weighed)
    own = moment.standard_error / moment.value
    first, second = (each.standard_error / each.value for each in factors)
    assert abs(first - second) <= own <= first + second


def test_of_one_bare_drop_it_is_what_anatomy_says():
    for result in (fit(recorded(DROP), multistart=4), fit_each(recorded(DROP, DROP), multistart=4)):
        moment, gravity, inertia = of(result)
        assert moment.determined_by == inertia.determined_by == "prior"
        own = hypot(*(one.standard_error / one.value for one in (gravity, inertia)))
        assert moment.standard_error / moment.value == pytest.approx(own, rel=0.2)  # two a part


def test_where_nothing_tells_the_inertia_nothing_tells_it():
    moment, _, inertia = of(fit(recorded(DROP, subject=Subject(kind="leg")), multistart=4))
    assert moment.value is None
    assert moment.reason == inertia.reason is not None


def test_of_an_inertia_that_is_fixed_it_has_the_error_of_the_ratio():
    moment, gravity, _ = of(fit(recorded(DROP), multistart=4, fix={"inertia": 0.42}))
    own, ratio = (one.standard_error / one.value for one in (moment, gravity))
    assert own == pytest.approx(ratio, rel=1e-4)  # what is fixed is held to 1e-5
    assert np.isfinite(own)
