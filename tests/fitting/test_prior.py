"""The prior: anatomy, and of a knee nothing that moves it."""

from dataclasses import replace

import jax
import jax.numpy as jnp
import numpy as np
import pytest
from scipy.stats import multivariate_normal

from exoid.fitting.estimate import fit
from exoid.fitting.model.assumptions import Assumptions
from exoid.fitting.model.belief import NAMES
from exoid.fitting.model.prior import joint_prior, log_jacobian, prior_residual, with_own
from exoid.fitting.model.prior_and_limits import believe
from exoid.fitting.model.user_values import ByHand
from exoid.physics.anatomy import expected_leg, known_leg
from exoid.physics.leg import GRAVITY, LegParameters
from fit_cases import BODY, DROP, leg, recorded

EXPECTED = expected_leg(74.0, 1.78)
KNEES = [(0.1, 0.5), (0.33, 2.6), (3.0, 2.9), (3.0, 40.0), (0.0, 0.0)]  # d, c


def drawn(logarithms) -> LegParameters:
    """The leg of log m, log l, log J / (m l) beside those expected, with a relaxed knee."""
    mass, distance, radius = np.exp(logarithms)
    one = [getattr(EXPECTED, name).value for name in NAMES]
    values = (one[0] * mass, one[1] * mass * distance * radius, one[2] * distance)
    knee = one[3] / one[1] * values[1], one[4] / one[1] * values[1]
    return LegParameters(*map(np.asarray, (*values, *knee)))


def test_it_is_the_joint_normal_of_the_logarithms():
    """Within a thousandth: a logarithm is a line below a hundredth of what is expected."""
    prior, covariance = joint_prior(EXPECTED, 1.0), np.array(EXPECTED.covariance)
    density = multivariate_normal(np.zeros(3), covariance)
    for at in np.random.default_rng(0).multivariate_normal(np.zeros(3), covariance, 20):
        square = np.sum(prior_residual(prior, drawn(at), np) ** 2)
        assert square == pytest.approx(2 * (density.logpdf(np.zeros(3)) - density.logpdf(at)), 2e-3)


def of_draws(row):
    """The leg of log m, log J, m l g / J, d / J, c / J, in which a posterior is drawn."""
    mass, inertia = jnp.exp(row[0]), jnp.exp(row[1])
    distance = row[2] * inertia / (mass * GRAVITY)
    return LegParameters(mass, inertia, distance, row[3] * inertia, row[4] * inertia)


def test_draws_are_weighed_by_the_jacobian_of_the_priors_own_variables():
    """A density in log m, log l, log J / (m l), d / J and c / J, as one of what is drawn."""
    prior = joint_prior(EXPECTED, 1.0)
    slopes = jax.jacfwd(lambda row: prior_residual(prior, of_draws(row))[:5])
    legs = np.random.default_rng(0).uniform((0.5, -2.0, 15, 0.2, 1), (2.5, 0.0, 40, 3, 20), (20, 5))
    true = np.array([np.linalg.slogdet(slopes(jnp.asarray(row)))[1] for row in legs])
    said = np.array([float(log_jacobian(prior, of_draws(row))) for row in legs])
    np.testing.assert_allclose(
        said - said[0], true - true[0], atol=0.01
    )  # of m, l: lines below TINY
    assert np.ptp(true) > 1  # without it legs would count several times as much as others


@pytest.mark.parametrize("knee", KNEES)
def test_no_knee_pulls_at_m_l_and_j_where_motion_tells_its_ratios(knee):
    """d / J and c / J held: the slope along log J must not change by the knee."""
    prior = joint_prior(EXPECTED, 1.0)

    def square(log_inertia, damping, stiffness):
        inertia = jnp.exp(log_inertia)
        one = LegParameters(
            jnp.asarray(4.4), inertia, jnp.asarray(0.25), damping * inertia, stiffness * inertia
        )
        return jnp.sum(prior_residual(prior, one) ** 2)

    slope = jax.grad(square)
    relaxed = slope(jnp.log(0.42), 0.8, 6.0)
    slopes = slope(jnp.log(0.42), knee[0] / 0.42, knee[1] / 0.42)
    assert float(slopes) == pytest.approx(float(relaxed), abs=1e-9)


@pytest.mark.proof
@pytest.mark.parametrize("knee", KNEES)
def test_a_knee_moves_no_mass_by_a_tenth_of_its_scatter(knee):
    """The same drop with and without the prior of d and c."""
    damping, stiffness = knee
    recording = recorded(DROP, damping=damping, stiffness=stiffness)
    result = fit(recording, multistart=4)
    problem = result.basis.problem
    assert float(problem.belief.prior.knee[0]) > 0
    for name in ("mass", "inertia", "com_distance"):
        each = result.parameters[name]
        scatter = getattr(EXPECTED, name).standard_deviation
        alone = without_knee(result)[name]
        assert abs(each.value - alone) < 0.1 * scatter


def without_knee(result):
    """m, l and J at the fit's ratios if d and c had no prior: exact, for a normal of logarithms."""
    covariance = np.array(EXPECTED.covariance)
    ratio = result.ratios["gravity_over_inertia"].value
    one = {name: getattr(EXPECTED, name).value for name in NAMES}
    radius = np.log(9.81 / ratio / (one["inertia"] / one["mass"] / one["com_distance"]))
    shift = covariance[:, 2] / covariance[2, 2] * radius
    return {
        "mass": one["mass"] * np.exp(shift[0]),
        "com_distance": one["com_distance"] * np.exp(shift[1]),
        "inertia": one["inertia"] * np.exp(shift.sum()),
    }


def test_your_mass_leaves_what_the_tables_say_of_the_rest_given_it():
    """p(m, l, J) / p(m) times yours: its covariance by the rules of normals."""
    covariance = np.array(EXPECTED.covariance)
    prior = with_own(joint_prior(EXPECTED, 1.0), {"mass": (EXPECTED.mass.value, 1e-3)}, 1.0)
    precision = prior.whitening.T @ prior.whitening
    whole = np.linalg.inv(covariance)
    assert precision[1:, 1:] == pytest.approx(whole[1:, 1:])
    assert np.linalg.eigvalsh(precision)[0] == pytest.approx(0.0, abs=1e-6)


def test_no_damping_at_all_is_no_surprise():
    """The prior of d and c is proper and finite at zero."""
    prior = joint_prior(EXPECTED, 1.0)
    none = replace(drawn(np.zeros(3)), damping=np.asarray(0.0), stiffness=np.asarray(0.0))
    assert np.all(np.abs(prior_residual(prior, none, np)) < 2)


def test_the_papers_prior_is_weighed_in_own_units():
    belief = believe(BODY, Assumptions(prior="paper"))
    at = leg()
    found = prior_residual(belief.prior, at, np)
    by_hand = [getattr(at, name) - getattr(belief.expected, name).value for name in NAMES]
    assert np.sum(found**2) == pytest.approx(np.sum(np.square(by_hand)))


@pytest.mark.parametrize(("radius", "strange"), [(1.0, False), (0.95, False), (0.78, True)])
def test_a_leg_that_moves_as_none_of_its_body_is_told(radius, strange):
    """J / (m l) is what motion tells at once; tables know it to 3.5 %: 22 % is no scatter."""
    one = {name: getattr(EXPECTED, name).value for name in NAMES}
    result = fit(recorded(DROP, **{**one, "inertia": radius * one["inertia"]}), multistart=2)
    found = [each for each in result.notes if "J / (m l) =" in each]
    assert bool(found) == strange
    if strange:
        told = one["inertia"] / (one["mass"] * one["com_distance"])
        assert f"= {radius * told:.3f} m, and anatomy expects {told:.3f} ±" in found[0]


STUMP = {"mass": 1.75, "com_distance": 0.088}
OF_STUMP = 0.0215  # kg m^2, of a transtibial stump of that mass and COM distance: 1.59 m l^2


@pytest.mark.parametrize("by", ["fix", "expect", "sidecar"])
def test_what_is_said_of_mass_and_distance_decides_what_the_inertia_can_be(by):
    """A whole leg of this body has at least 0.07 kg m^2."""
    person, hand = BODY, ByHand()
    if by == "fix":
        hand = ByHand(fix=STUMP)
    elif by == "expect":
        hand = ByHand(prior={name: (value, 0.05 * value) for name, value in STUMP.items()})
    else:
        person = replace(BODY, shank_foot_mass=1.75, com_distance=0.088)
    found = believe(person, Assumptions(by_hand=hand))
    assert float(found.limits.lower.inertia) < OF_STUMP / 2
    assert found.expected is not None
    assert found.expected.inertia.value == pytest.approx(OF_STUMP, rel=0.15)
    assert float(believe(BODY).limits.lower.inertia) > OF_STUMP


def test_of_a_known_distance_alone_the_mass_is_the_tables():
    usual, bent = expected_leg(75.0, 1.75), known_leg(expected_leg(75.0, 1.75), None, 0.2)
    assert bent.mass.value == pytest.approx(usual.mass.value)
    assert bent.com_distance.value == pytest.approx(0.2)
    assert known_leg(usual, None, None) == usual
