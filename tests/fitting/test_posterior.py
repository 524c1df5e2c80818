"""Draws against what is known of the density: its derivatives, its moments, its walls."""

from dataclasses import replace
from functools import partial

import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np
import pytest

from exoid.fitting.errors import posterior as module
from exoid.fitting.errors.posterior import Posterior, quiet_arviz, r_hat, sample, to_netcdf
from exoid.fitting.errors.posterior_density import log_density, posed
from exoid.fitting.estimate import fit
from exoid.fitting.misfit.uncertainty import whitening
from exoid.fitting.model.systematics import TILT, WEIGHED
from exoid.physics.leg import GRAVITY
from exoid.recordings.declared.subject import Subject
from fit_cases import CYCLE, DROP, LOADED, recorded

pytest.importorskip("blackjax")
pytest.importorskip("h5netcdf")
try:
    arviz = quiet_arviz()
except ImportError:
    pytest.skip("needs arviz", allow_module_level=True)

FEW = {"draws": 200, "warmup": 60}  # one compilation serves both legs
CHANCE = 4.0  # standard errors of a Monte Carlo mean: passed by one of 16 000
STEP = 1e-4  # of a central difference, in standard deviations: its error is about STEP^2
DETERMINED = ("inertia", "damping", "stiffness")
RATIOS = ("gravity_over_inertia", "stiffness_over_inertia", "damping_over_inertia")


def session(said: float | None):
    """Two drops, one with a known mass, of a leg of which anatomy is known; and how surely its
    seat is said to be level [rad].
    """
    seen = recorded(DROP, LOADED)
    return replace(seen, protocol=replace(seen.protocol, thigh_angle_uncertainty=said))


@pytest.fixture(scope="module")
def fitted():
    return fit(session(float(TILT)), multistart=8)


@pytest.fixture(scope="module")
def drawn(fitted):
    return sample(fitted, **FEW)


@pytest.fixture(scope="module")
def hidden(fitted):
    """The same fit, had a disturbance hidden from some directions and widened others."""
    basis = fitted.basis
    white, unit = whitening(basis.ended.local.data)
    back = np.linalg.pinv(white).T * unit[:, None]
    grown = np.linspace(1.0, 9.0, white.shape[1])
    disturbance = replace(basis.ended.disturbance, widening=np.sqrt(grown))
    local = replace(basis.ended.local, data=(back / grown) @ back.T)
    rescale = basis.ended.disturbance.scale / disturbance.scale  # what is condensed counts 1 / it
    condensed = jax.tree.map(lambda each: rescale * each, basis.ended.best.condensed)
    best = eqx.tree_at(lambda at: at.condensed, basis.ended.best, condensed)
    ended = replace(basis.ended, disturbance=disturbance, local=local, best=best)
    return replace(basis, ended=ended)


@partial(jax.jit, static_argnames="chain")
def scored(target, places, chain):
    """The log density and its gradient at places in unit scale."""
    return jax.lax.map(jax.value_and_grad(partial(log_density, target, chain)), places)


def score(basis, places):
    return scored(posed(basis)[0], jnp.asarray(places), basis.problem.chain)


def monte_carlo(draws: np.ndarray) -> tuple[float, float, float]:
    """Mean, standard deviation and how many independent draws would tell as much."""
    return float(draws.mean()), float(draws.std()), float(arviz.ess(draws))


@pytest.mark.proof
def test_mean_and_deviation_are_the_fits_value_and_standard_error(fitted, drawn):
    """Of data that determine their quantities to 1e-3, where the density is nearly Gaussian."""
    for name in (*DETERMINED, *RATIOS):
        each = (fitted.parameters | fitted.ratios)[name]
        mean, deviation, count = monte_carlo(drawn.samples[name])
        assert abs(mean - each.value) < CHANCE * each.standard_error / np.sqrt(count)
        # A standard deviation is known to 1 / sqrt(2 n) of itself. Draws that alternate around the
        # mean tell it better than as many independent ones, and the deviation no better.
        spread = float(arviz.ess(drawn.samples[name], method="sd"))
        assert deviation == pytest.approx(each.standard_error, rel=CHANCE / np.sqrt(2 * spread))


@pytest.mark.proof
def test_a_foot_that_nobody_ruled_out_is_in_the_draws_as_in_the_errors(drawn):
    """The fit's are the mean square of a leg with one and of one without, by their odds."""
    footed = fit(session(None), multistart=8)
    loose = sample(footed, draws=500, warmup=100).samples
    for name in RATIOS:
        each, draws = footed.ratios[name], loose[name]
        assert abs(draws.mean() - each.value) < 0.5 * each.standard_error
        assert draws.std() == pytest.approx(each.standard_error, rel=0.25)
    assert loose[RATIOS[0]].std() > 1.2 * drawn.samples[RATIOS[0]].std()


def test_the_chains_agree(drawn):
    """The greatest was 1.020 to 1.034 over seeds and compilers; with 1000 draws, below 1.005."""
    assert max(r_hat(drawn).values()) < 1.05
    assert min(float(arviz.ess(each)) for each in drawn.samples.values()) > 100
    assert not drawn.diverging.any()


def test_mass_and_distance_stay_within_their_limits_and_agree_in_their_product(fitted, drawn):
    """Anatomy tells m to about 4 %, two drops m l as well as the added mass is weighed."""
    mass, distance = drawn.samples["mass"], drawn.samples["com_distance"]
    for name, draws in (("mass", mass), ("com_distance", distance)):
        each = fitted.parameters[name]
        assert draws.min() >= each.lower
        assert draws.max() <= each.upper
    moment = mass * distance
    assert moment.mean() == pytest.approx(4.5 * 0.26, rel=0.01)
    # Every other systematic has less than a tenth of the variance of what goes by the scale.
    assert moment.std() / moment.mean() == pytest.approx(WEIGHED, rel=0.1)
    assert moment.std() / moment.mean() < 0.2 * mass.std() / mass.mean()
    expected = drawn.samples["gravity_over_inertia"] * drawn.samples["inertia"] / GRAVITY
    assert np.allclose(moment, expected, rtol=1e-12)


@pytest.fixture(scope="module")
def without_prior():
    return sample(fit(recorded(DROP, LOADED), multistart=8, prior="none", bounds="paper"), **FEW)


@pytest.mark.proof
def test_where_only_limits_tell_the_mass_its_logarithm_is_uniform_between_them(without_prior):
    """m l and J are known, so m l^2 <= J is m >= (m l)^2 / J; the other end is 6 kg (Eq. 13)."""
    samples = without_prior.samples
    moment = (samples["mass"] * samples["com_distance"]).mean()
    lowest, highest = np.log(moment**2 / samples["inertia"].mean()), np.log(6.0)
    draws = np.log(samples["mass"])
    mean, deviation, count = monte_carlo(draws)
    uniform = (highest - lowest) / np.sqrt(12)
    assert abs(mean - (lowest + highest) / 2) < CHANCE * uniform / np.sqrt(count)
    # A uniform density's variance scatters by sqrt(0.8 / n), its deviation by half of that.
    assert deviation == pytest.approx(uniform, rel=CHANCE * np.sqrt(0.8 / count) / 2)
    # By how far the lower end itself scatters, with the weight and the place of the added mass.
    ends = 2 * np.log(samples["mass"] * samples["com_distance"]) - np.log(samples["inertia"])
    edge = 4 * ends.std()
    assert lowest - edge < draws.min() < lowest + 0.1 * (highest - lowest)
    assert highest - 0.1 * (highest - lowest) < draws.max() <= highest


@pytest.mark.proof
def test_walls_that_chains_meet_are_no_divergences(without_prior):
    assert without_prior.diverging.mean() < 0.01


@pytest.mark.parametrize("hides", [False, True])
def test_the_gradient_is_that_of_finite_differences(fitted, hidden, hides):
    basis = hidden if hides else fitted.basis
    size = posed(basis)[0].spread.shape[1]
    place = np.random.default_rng(1).normal(size=size)
    steps = np.concatenate([np.zeros((1, size)), STEP * np.eye(size), -STEP * np.eye(size)])
    density, gradient = score(basis, place + steps)
    differences = (density[1 : size + 1] - density[size + 1 :]) / (2 * STEP)
    # The density's own rounding, 1e-13 at its size of 1e3, is divided by STEP: 1e-9.
    np.testing.assert_allclose(gradient[0], differences, atol=1e-6)


@pytest.mark.parametrize("hides", [False, True])
def test_the_density_curves_as_the_fits_information(fitted, hidden, hides):
    """Whatever a disturbance widened: in unit scale that is -1 in every direction."""
    basis = hidden if hides else fitted.basis
    size = posed(basis)[0].spread.shape[1]
    steps = np.concatenate([STEP * np.eye(size), -STEP * np.eye(size), np.zeros((1, size))])
    _, gradient = score(basis, steps)
    curvature = (gradient[:size] - gradient[size:-1]) / (2 * STEP)
    # Gauss-Newton leaves out the residual times its second derivative.
    np.testing.assert_allclose(curvature, -np.eye(size), atol=0.05)


def test_the_fit_is_the_mode(fitted):
    """No limit holds there, so the fit is the mode, to the solver's tolerance of 1e-3 units."""
    size = posed(fitted.basis)[0].spread.shape[1]
    _, gradient = score(fitted.basis, np.zeros((2 * size + 1, size)))
    assert np.abs(gradient).max() < 0.05


@pytest.mark.proof
def test_the_same_seed_gives_the_same_draws_and_another_gives_others(fitted, drawn):
    again, other = sample(fitted, **FEW), sample(fitted, **FEW, seed=1)
    for name in drawn.names:
        np.testing.assert_array_equal(again.samples[name], drawn.samples[name])
    assert not np.array_equal(other.samples["inertia"], drawn.samples["inertia"])


def test_arviz_reads_what_was_written(drawn, tmp_path):
    to_netcdf(drawn, tmp_path / "posterior.nc")
    read = arviz.from_netcdf(tmp_path / "posterior.nc")
    assert list(read.posterior.data_vars) == drawn.names
    for name in drawn.names:
        entry = read.posterior[name]
        assert entry.dims == ("chain", "draw")
        assert entry.attrs["units"] == drawn.units[name]
        np.testing.assert_array_equal(entry.values, drawn.samples[name])
    np.testing.assert_array_equal(read.sample_stats["diverging"].values, drawn.diverging)
    np.testing.assert_array_equal(read.sample_stats["acceptance_rate"].values, drawn.acceptance)
    assert read.posterior["inertia"].attrs["units"] == "kg m^2"


@pytest.mark.proof
@pytest.mark.parametrize(
    ("movement", "names"),
    [
        (DROP, RATIOS),
        pytest.param(LOADED, (*DETERMINED, *RATIOS), marks=pytest.mark.slow),
    ],
)
def test_of_a_rigs_leg_only_what_motion_determines_is_reported(movement, names):
    """What the recording owns is determined by what is known of sensors and seats."""
    rig = recorded(DROP, movement, subject=Subject(kind="rig"))
    drawn = sample(fit(rig, multistart=8), draws=5, warmup=5)
    assert sorted(name for name in drawn.names if "[" not in name) == sorted(names)
    assert sorted(drawn.units) == sorted(drawn.names)


@pytest.mark.proof
def test_torques_and_mountings_have_a_name_for_every_segment_and_recording():
    first, second = recorded(DROP, CYCLE), recorded(DROP, seed=1)
    drawn = sample(fit([("a", first), ("b", second)], multistart=8), draws=5, warmup=5)
    owned = {"zero": "rad", "tilt": "rad", "gyro_scale": "1", "gyro_bias": "rad/s", "clock": "1"}
    units = {f"{name}[{number}]": unit for name, unit in owned.items() for number in (0, 1)}
    units |= {"torque_amplitude[1]": "N m", "torque_over_inertia[1]": "1/s^2"}
    assert drawn.units.items() >= units.items()
    ratio = drawn.samples["torque_over_inertia[1]"]
    np.testing.assert_allclose(ratio, -4.0 / 0.42, rtol=0.01)  # its error is 2e-4 of it


def test_segments_that_were_fitted_alone_have_no_posterior(fitted):
    """`fit_each` gives a result without a basis."""
    with pytest.raises(ValueError, match="no one fit to draw around"):
        sample(replace(fitted, basis=None, leg=None))


def test_packages_that_are_missing_are_named(fitted, monkeypatch):
    monkeypatch.setattr(module, "find_spec", lambda name: None)
    with pytest.raises(ValueError, match=r"install '\.\[posterior\]'"):
        sample(fitted)


def test_names_follow_the_samples():
    nothing = np.zeros((1, 1))
    assert Posterior({"a": nothing}, {"a": "m"}, nothing > 0, nothing).names == ["a"]
