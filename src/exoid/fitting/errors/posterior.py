"""Draws from what a recording, the prior and the limits leave open, in the fit's coordinates.

A standard error is the quadratic picture at the best fit; draws follow the curved misfit and stop
at the limits. NUTS (Hoffman & Gelman, JMLR 15, 2014) moves them by the exact gradient.
"""

import warnings
from dataclasses import dataclass
from functools import partial
from importlib.util import find_spec
from pathlib import Path

import jax
import numpy as np
from jaxtyping import Bool, Float

from exoid.files.extras import installing
from exoid.fitting.errors.nuts import move_chains
from exoid.fitting.errors.posterior_density import Target, points, posed
from exoid.fitting.errors.profile import named
from exoid.fitting.misfit.uncertainty import ON_BOUND
from exoid.fitting.model.constraint import violations_at
from exoid.fitting.model.coordinates import Coordinates, quantities
from exoid.fitting.model.term_parameters import parameters_of, ratio_name, ratio_unit
from exoid.fitting.model.user_values import DECLARED
from exoid.fitting.result.estimates.basis import Basis
from exoid.fitting.result.estimates.owned import FIELDS, MOUNTING, in_no_unit
from exoid.fitting.result.estimates.ratios import RATIOS
from exoid.fitting.result.estimates.scale import hidden
from exoid.fitting.result.fit_result import FitResult
from exoid.fitting.result.mountings import outside

PACKAGES = ("blackjax", "arviz", "h5netcdf")
MISSING = f"a posterior needs more packages: {installing('posterior')}"
CANDIDATES = 10_000  # from the quadratic picture, among which the chains begin


@dataclass(frozen=True, eq=False)
class Posterior:
    """Draws of every quantity that data, prior and limits determine.

    >>> drawn = exoid.sample(exoid.fit("drops.csv"), draws=20, warmup=20, chains=2)
    >>> drawn.samples["inertia"].shape, drawn.units["inertia"]
    ((2, 20), 'kg m^2')
    """

    samples: dict[str, Float[np.ndarray, "chain draw"]]
    units: dict[str, str]
    diverging: Bool[np.ndarray, "chain draw"]  # the step was too long; a limit met does not count
    acceptance: Float[np.ndarray, "chain draw"]  # mean probability along the trajectory

    @property
    def names(self) -> list[str]:
        return list(self.samples)


def sample(
    result: FitResult, *, draws: int = 1000, warmup: int = 500, chains: int = 4, seed: int = 0
) -> Posterior:
    """Draw from exp(-(data + prior) / 2) within the limits, a density in the prior's variables.

    The draws are made in the fit's coordinates, by `prior.log_jacobian`. Where the prior says
    nothing, the density is one in these coordinates: flat in log m and log J.

    `data` is the misfit over the least widening squared, taken at best + C (z - best) instead of z:
    C shrinks the directions that a disturbance widened more, so that `data` curves as the fit's
    information does, and its slope at the best fit is kept (Ribatet, Cooley & Davison, Statistica
    Sinica 22, 2012). C is 1 where only noise is in the residual. Where nobody says how level a seat
    is, every other leg has a foot that puts its line off, as for the errors of the fit. What
    nothing determines, as m of a rig, or what the fit holds back, is left out. `warmup` adapts the
    step alone.

    **Raises** `ValueError` for a result without one fit (`fit_each`) or that was saved, where
    packages are missing, or where the limits leave no room.

    >>> drawn = exoid.sample(exoid.fit("drops.csv"), draws=20, warmup=20, chains=2)
    >>> drawn.samples["damping_over_inertia"].shape
    (2, 20)
    """
    check_packages()
    basis = result.basis_to("draw around")
    target, undetermined = posed(basis)
    with jax.enable_x64(True):
        run = partial(move_chains, chain=basis.problem.chain, warmup=warmup, draws=draws)
        moved = run(target, begin(target, chains, seed), jax.random.key(seed))
        moved = jax.tree.map(np.asarray, moved)
    flat = moved.place.reshape(-1, moved.place.shape[-1])
    values, units = described(basis, points(target, flat), undetermined)
    held_back = {name for name, each in named(result) if hidden(each)}
    values = {name: row for name, row in values.items() if name.split("[")[0] not in held_back}
    return Posterior(
        samples={name: row.reshape(draws, chains).T.copy() for name, row in values.items()},
        units={name: units[name] for name in values},
        diverging=moved.diverging.T,
        acceptance=moved.acceptance.T,
    )


def check_packages() -> None:
    """Refuse where what sampling needs is not installed."""
    if not all(map(find_spec, PACKAGES)):
        raise ValueError(MISSING)


def begin(target: Target, chains: int, seed: int) -> np.ndarray:
    """Places within the limits, drawn from the quadratic picture: (chain, direction)."""
    generator = np.random.default_rng(seed)
    places = generator.normal(size=(CANDIDATES, target.spread.shape[1]))
    at = points(target, places)
    limit = violations_at(target.limits, at, np)
    good = np.flatnonzero(limit.max(axis=0) <= 0)
    if good.size < chains:
        raise ValueError("the limits leave no room around the fit to draw from: see its notes.")
    return places[good[:chains]]


def described(
    basis: Basis, at: Coordinates, undetermined: np.ndarray
) -> tuple[dict[str, np.ndarray], dict[str, str]]:
    """Values and units of all quantities that have no part in what nothing determines."""
    gradients, every = basis.ended.local.quantities, quantities(at, np)
    values, units = {}, {}
    for name, (row, unit) in numbered(basis).items():
        free = np.linalg.norm(gradients[row] @ undetermined)
        if free <= ON_BOUND * np.linalg.norm(gradients[row]):
            values[name], units[name] = every[row], unit
    owned, theirs = placed(basis, at)
    return values | owned, units | theirs


def numbered(basis: Basis) -> dict[str, tuple[int, str]]:
    """Which row of `coordinates.quantities` each is, and its unit."""
    unit = {name: declared.unit for name, declared in DECLARED.items()}
    unit |= {name: entry[2] for name, entry in RATIOS.items()}
    for name, own in (("torque_amplitude", "N m"), ("torque_over_inertia", "1/s^2")):
        unit |= dict.fromkeys(basis.problem.quantities_of(name), own)
    for name, declared in parameters_of(basis.problem.terms):
        unit |= {name: declared.unit, ratio_name(name, declared): ratio_unit(declared)}
    rows = enumerate(basis.problem.quantities)
    return {name: (row, unit[name]) for row, name in rows if name in unit}


def placed(basis: Basis, at: Coordinates) -> tuple[dict[str, np.ndarray], dict[str, str]]:
    """Values and units of what recordings own, by the recording's number."""
    values, units = {}, {}
    for field in basis.problem.owned:
        if in_no_unit(basis.problem, field):
            continue
        for entry in basis.problem.estimated(field):
            name, row = FIELDS[field], getattr(at.mounting, field)[entry]
            key = f"{name}[{basis.problem.recordings[entry][0].recording}]"
            values[key] = outside(basis.problem, field, entry, row)
            units[key] = MOUNTING[name][2]
    return values, units


def r_hat(posterior: Posterior) -> dict[str, float]:
    """Near 1 where the chains agree (rank-normalised, Vehtari et al., Bayesian Analysis 2021)."""
    return {name: float(quiet_arviz().rhat(each)) for name, each in posterior.samples.items()}


def quiet_arviz():
    """ArviZ, whose announcement of its next version is no concern of the user. It notes the day of
    that in a file, which fails where another process does so at the same moment.
    """
    with warnings.catch_warnings():
        warnings.filterwarnings("ignore", r"\s*ArviZ is undergoing", FutureWarning)
        try:
            import arviz
        except FileNotFoundError:
            import arviz
    return arviz


def to_netcdf(posterior: Posterior, path: str | Path) -> None:
    """Write the groups `posterior` and `sample_stats` as ArviZ reads them."""
    import xarray

    def group(each: dict[str, np.ndarray]) -> xarray.Dataset:
        return xarray.Dataset(
            {name: (("chain", "draw"), values) for name, values in each.items()},
            {axis: np.arange(n) for axis, n in zip(("chain", "draw"), shape, strict=True)},
        )

    shape = posterior.diverging.shape
    drawn = group(posterior.samples)
    for name, unit in posterior.units.items():
        drawn[name].attrs["units"] = unit
    seen = {"diverging": posterior.diverging, "acceptance_rate": posterior.acceptance}
    tree = xarray.DataTree.from_dict({"posterior": drawn, "sample_stats": group(seen)})
    tree.to_netcdf(path, engine="h5netcdf")
