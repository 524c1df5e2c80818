"""One sample into a belief, against the equations of the textbook on dense matrices."""

import jax
import jax.numpy as jnp
import numpy as np
import pytest

import exoid
from exoid.online.filter.absorb import ROUGHNESS, TICK, absorb, carried, correct
from exoid.online.filter.gaussian import Gaussian
from exoid.online.filter.loosen import loosened
from exoid.online.filter.motion import Span, advance, view
from exoid.online.filter.prior import prior_of
from exoid.online.filter.sensor_noise import SensorNoise
from exoid.online.model.model import Model, Node
from exoid.online.model.sample import Sample
from exoid.online.model.unknowns import AT
from exoid.physics.leg import LegModel, LegParameters
from exoid.physics.motion.simulate import simulate
from exoid.physics.state import LegState
from exoid.physics.torque import NoTorque

MODEL = Model()
NOISE = SensorNoise(*map(jnp.asarray, (7e-7, 7e-6, 3e-4, 2e-4, 40.0)))
DELAY = AT["gyro_delay"]
STEP = jnp.asarray(0.01)
SPAN = Span(STEP, jnp.zeros(()))
LEG = LegParameters(*map(jnp.asarray, (4.5, 0.42, 0.26, 0.33, 2.6)))


@pytest.fixture(scope="module")
def belief():
    """Of a leg that moves, with every entry tied to every other."""
    prior = prior_of(exoid.expected_leg(77.0, 1.80), MODEL)
    root = np.tril(prior.root + 1e-3 * np.random.default_rng(0).standard_normal(prior.root.shape))
    root[-2:] *= 0.01
    return Gaussian(jnp.asarray(prior.mean).at[-2:].set([-0.6, -2.0]), jnp.asarray(root))


def sample(angle=-0.619, rate=-2.1):
    return Sample(*map(jnp.asarray, (0.5, angle, rate, 0.0, 0.0, 0.0)))


def textbook(belief, given):
    """P = F P F' + Q; K = P H' (H P H' + R)^-1; x + K (z - h), P - K H P."""

    def reached(row):
        return jnp.concatenate([row[:-2], advance(MODEL.unknowns, row, given, SPAN).state])

    def shown(row):
        return view(MODEL.unknowns, row, given).shown

    mean, carry = reached(belief.mean), jax.jacfwd(reached)(belief.mean)
    acceleration = view(MODEL.unknowns, mean, given).acceleration
    covariance = carry @ belief.root @ belief.root.T @ carry.T
    covariance = covariance.at[-1, -1].add(ROUGHNESS**2 * STEP / TICK)
    covariance = covariance.at[DELAY, DELAY].add(NOISE.drift**2 * STEP)
    measured = jnp.stack([given.angle, given.angular_velocity])
    known = ~jnp.isnan(measured)
    looking, off = jax.jacfwd(shown)(mean)[known], (measured - shown(mean))[known]
    spread = looking @ covariance @ looking.T + jnp.diag(NOISE.variance(acceleration)[known])
    gain = jnp.linalg.solve(spread, looking @ covariance).T
    return mean + gain @ off, covariance - gain @ looking @ covariance, off, spread


@pytest.mark.parametrize("lost", [(), ("angle",), ("rate",)])
def test_it_is_the_kalman_filter_of_the_textbook(belief, lost):
    given = sample(**dict.fromkeys(lost, np.nan))
    after, innovation = absorb(MODEL, belief, given, SPAN, NOISE)
    mean, covariance, off, spread = textbook(belief, given)
    scale = np.sqrt(np.diag(covariance))
    # What rounding leaves of what cancels in the textbook's form, and does not in the triangle.
    assert np.abs(after.mean - mean) / scale == pytest.approx(0, abs=1e-6)
    apart = (after.root @ after.root.T - covariance) / np.outer(scale, scale)
    assert np.abs(apart) == pytest.approx(0, abs=1e-6)
    likelihood = -(off @ jnp.linalg.solve(spread, off) + jnp.log(jnp.linalg.det(spread))) / 2
    assert float(innovation.log_likelihood) == pytest.approx(float(likelihood), rel=1e-8)
    assert float(innovation.far) == pytest.approx(
        float(off @ jnp.linalg.solve(spread, off)), rel=1e-8
    )


def test_a_sample_without_numbers_is_a_step_alone(belief):
    after, innovation = absorb(MODEL, belief, sample(np.nan, np.nan), SPAN, NOISE)
    # But for the age that drifts, the last of what stays: nothing before it is touched.
    assert np.array_equal(after.root[:DELAY], belief.root[:DELAY])
    assert np.array_equal(after.mean[:-2], belief.mean[:-2])
    assert float(innovation.far) == 0.0
    assert not innovation.used.any()


def test_a_rate_that_no_gyro_shows_goes_on_as_all_the_legs_that_are_believed():
    """Faster where damping is less: the mean over 100 000 of them, to 4.5 of its errors, is 0.03
    rad/s off that of the leg in their middle.
    """
    prior = prior_of(exoid.expected_leg(77.0, 1.80), MODEL)
    root = np.array(prior.root)
    root[-1, AT["damping"]] = root[-1, -1] = 0.7
    root[-2, -2] = 0.01
    legs = np.array(prior.mean) + np.random.default_rng(2).standard_normal((100_000, len(root))) @ (
        root.T
    )
    blind = sample(np.nan, np.nan)

    def reached(row):
        return advance(MODEL.unknowns, row, blind, SPAN).state[1]

    rates = np.asarray(jax.jit(jax.vmap(reached))(jnp.asarray(legs)))
    by_angle = Model(node=Node(gyro=False))
    after, _ = absorb(
        by_angle, Gaussian(jnp.asarray(prior.mean), jnp.asarray(root)), blind, SPAN, NOISE
    )
    error = rates.std() / np.sqrt(len(rates))
    assert float(after.mean[-1]) == pytest.approx(rates.mean(), abs=4.5 * error)
    assert abs(float(reached(jnp.asarray(prior.mean))) - rates.mean()) > 4.5 * error


def test_a_sample_that_is_no_legs_is_not_believed(belief):
    after, innovation = absorb(MODEL, belief, sample(angle=2.0), SPAN, NOISE)
    assert float(innovation.far) > 40.0
    assert np.array_equal(after.mean[:-2], belief.mean[:-2])


def test_the_step_is_the_one_of_a_simulation(belief):
    """The encoder's zero, the tilted seat and the offset are another way to write the same leg."""
    zero, start = 0.05, LegState(jnp.asarray(-0.5), jnp.asarray(-1.0))
    ratios = LegModel(LEG, NoTorque()).ratios()
    gravity, stiffness = float(ratios.gravity), float(ratios.stiffness)
    row = np.zeros(MODEL.unknowns.size)
    row[:6] = [
        gravity * np.cos(zero), gravity * np.sin(zero), stiffness,
        stiffness * zero, float(ratios.damping), np.log(0.42),
    ]  # fmt: skip
    row[-2:] = start.angle + zero, start.angular_velocity
    end = advance(MODEL.unknowns, jnp.asarray(row), sample(), SPAN)
    time = jnp.arange(3) * 0.005  # s: a step goes in two parts
    motion = simulate(LegModel(LEG, NoTorque()), start, time)
    assert float(end.state[0]) == pytest.approx(float(motion.angle[-1]) + zero, abs=1e-12)
    assert float(end.state[1]) == pytest.approx(float(motion.angular_velocity[-1]), abs=1e-12)


def test_a_triangle_stays_one_and_keeps_its_covariance():
    rows = jnp.asarray(np.random.default_rng(1).standard_normal((2, 5)))
    found = carried(rows, 0.3)
    assert float(found[0, -1]) == 0.0
    assert found @ found.T == pytest.approx(
        np.asarray(rows @ rows.T) + np.diag([0, 0.3]), abs=1e-12
    )


@pytest.mark.parametrize("at", [0, 2, 4])
def test_what_wanders_has_so_much_more_variance_and_nothing_else_changes(at):
    root = jnp.asarray(np.tril(np.random.default_rng(3).standard_normal((5, 5))))
    found = loosened(root, at, 0.3)
    wanted = np.array(root @ root.T)
    wanted[at, at] += 0.3**2
    assert found @ found.T == pytest.approx(wanted, abs=1e-12)
    assert np.triu(found, 1) == pytest.approx(0, abs=1e-15)


def test_no_measurement_however_good_makes_a_variance_negative():
    """Of a million times less noise than spread; P - K H P has lost all digits by then."""
    table = jnp.asarray(np.tril(np.random.default_rng(2).standard_normal((6, 6))))
    for row in range(6):
        table, _, _ = correct(table, table[row], 1e-18)
    assert (np.diag(table) ** 2 > 0).all()
    assert np.array_equal(table, np.tril(table))
