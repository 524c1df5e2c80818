"""Profiles against what they must be: parabolas, one-sided where a bound is, flat where nothing."""

from dataclasses import replace

import numpy as np
import pytest

from exoid.fitting.errors.profile import RISE, crossing, cut, profiles
from exoid.fitting.estimate import fit
from fit_cases import BODY, DROP, LOADED, recorded


@pytest.fixture(scope="module")
def scaled_fit():
    return fit(recorded(DROP, LOADED), multistart=2)


@pytest.fixture(scope="module")
def found(scaled_fit):
    return profiles(scaled_fit)


RATIOS = ("gravity_over_inertia", "stiffness_over_inertia", "damping_over_inertia")


@pytest.mark.parametrize("name", ["inertia", "damping", "stiffness", *RATIOS])
def test_where_the_data_are_clear_the_profile_is_the_parabola_of_the_error(scaled_fit, found, name):
    """White noise and hundreds of samples: the quadratic picture holds to a few per cent."""
    each = {**scaled_fit.parameters, **scaled_fit.ratios}[name]
    profile = found[name]
    parabola = ((profile.value - each.value) / each.standard_error) ** 2
    assert np.abs(profile.rise - parabola).max() < 0.05 * parabola.max()
    assert profile.shape == "two-sided"
    for end, sign in ((profile.lower, -1), (profile.upper, 1)):
        expected = each.value + sign * np.sqrt(RISE) * each.standard_error
        assert end == pytest.approx(expected, abs=0.05 * each.standard_error)


def test_the_profile_of_the_mass_is_that_of_its_prior(scaled_fit, found):
    """m l and J are known, so a mass is as likely as it, its l and J / (m l) are before."""
    expected = scaled_fit.basis.problem.belief.expected
    chosen = scaled_fit.parameters
    moment = chosen["mass"].value * chosen["com_distance"].value
    radius = chosen["inertia"].value / moment
    expected_radius = expected.inertia.value / expected.mass.value / expected.com_distance.value
    profile = found["mass"]
    away = np.log(
        [
            profile.value / expected.mass.value,
            moment / profile.value / expected.com_distance.value,
            np.full(profile.value.size, radius / expected_radius),
        ]
    )
    square = np.sum(away * np.linalg.solve(np.array(expected.covariance), away), axis=0)
    square -= square.min()
    # The added mass is weighed to 0.5 %: m l and J are known to that, 0.6 % of the variance of m.
    assert np.abs(profile.rise - square).max() < 0.01 * square.max()


def test_at_a_bound_only_the_other_limit_is_known():
    """A leg that no prior holds and whose stiffness would be above its bound of 4 N m/rad."""
    stiff = recorded(DROP, LOADED, stiffness=4.4, inertia=0.44)
    profile = profiles(fit(stiff, multistart=2, prior="none", bounds="paper"))["stiffness"]
    assert profile.estimate.determined_by == "bound"
    assert profile.shape == "lower limit only"
    assert profile.value.max() < 4.0 + 1e-3
    assert profile.lower < 4.0


def test_what_nothing_tells_is_flat_within_its_limits():
    bare = recorded(DROP, subject=replace(BODY, body_mass=None, height=None))
    result = fit(bare, multistart=2)
    profile = profiles(result)["inertia"]
    assert result.parameters["inertia"].value is None
    assert profile.shape == "flat"
    assert profile.rise.max() < 0.01  # half of a bound's penalty at most
    assert profile.value.max() / profile.value.min() > 1.3


def test_a_crossing_lies_where_the_root_passes_the_limit():
    value = np.array([0.0, 1.0, 2.0, 3.0])
    assert crossing(value, value**2) == pytest.approx(np.sqrt(RISE))
    assert crossing(value, 0.1 * value**2) is None


def test_a_search_that_ended_early_does_not_narrow_an_interval():
    """What was reached farther out shows that the loss is no larger there."""
    value = np.linspace(0.0, 3.0, 13)
    stuck = value**2 + np.where(value == 1.0, 90.0, 0.0)
    assert crossing(value, stuck) == pytest.approx(np.sqrt(RISE))


def test_a_fit_of_every_segment_alone_has_no_profile(scaled_fit):
    with pytest.raises(ValueError, match="fitted alone"):
        profiles(replace(scaled_fit, basis=None, leg=None))


def test_a_saved_fit_has_no_profile_and_says_what_to_do(scaled_fit):
    with pytest.raises(ValueError, match="to profile, fit the recording again"):
        profiles(replace(scaled_fit, basis=None))


def test_a_profile_agrees_with_its_error_where_the_model_misses_something():
    """d of a bare drop, whose ratio the data tell and whose scale the prior does."""
    dry = recorded(DROP)
    angle = dry.segments[0].raw_angle
    time = dry.segments[0].time
    shaken = replace(dry.segments[0], raw_angle=angle + 0.004 * np.sin(9 * time + 3 * time**2))
    result = fit(replace(dry, segments=(shaken,)), multistart=2)
    assert result.disturbance.cause is not None
    for name in ("damping", "damping_over_inertia"):
        each = {**result.parameters, **result.ratios}[name]
        profile = profiles(result)[name]
        half = (profile.upper - profile.lower) / 2
        # An interval of a skewed profile is not symmetric, but as wide within a fifth.
        assert half == pytest.approx(np.sqrt(RISE) * each.standard_error, rel=0.2)


def test_a_curve_that_a_wider_error_stretches_ends_on_its_limits():
    """Of a parabola, whose root is linear, and which stays one."""
    value = np.linspace(-1.0, 3.0, 9)
    kept, rise = cut(value, (value - 1.0) ** 2, 4, (-0.3, 9.0))
    assert kept[0] == -0.3
    assert kept[-1] == 3.0
    np.testing.assert_allclose(rise, (kept - 1.0) ** 2, atol=1e-12)
    assert crossing(kept[kept <= 1.0][::-1], rise[kept <= 1.0][::-1]) is None
