"""What a recording tells of a leg, what only the prior or a bound does, and what nothing can.

From the Fisher information of a fit (exact sensitivities, widened for what the residual holds
besides noise): directions in which the parameters may move without any trace in the motion, those
in which they leave hardly any, and the combinations that are well determined.
"""

from dataclasses import replace

import numpy as np

from exoid.fitting.errors.profile import named, weights_of
from exoid.fitting.misfit.neighbourhood import columns
from exoid.fitting.misfit.uncertainty import HELD, Information, inverse_times
from exoid.fitting.result.estimates.basis import Basis
from exoid.fitting.result.estimates.estimate import RIVALS, Estimate
from exoid.fitting.result.estimates.scale import MISPLACED
from exoid.fitting.result.fit_result import FitResult
from exoid.fitting.solve.ask import take
from exoid.trust.directions import listed, null_directions, weak_directions
from exoid.trust.identifiability import Identifiability, Reversal
from exoid.trust.legs import strangers
from exoid.trust.not_found import not_found
from exoid.trust.open_scale import scale_remark
from exoid.trust.reversal import reversals

UNDAMPED = 0.1  # 1/s, d / J below which no relaxed leg lies (0.5 to 1.2 do)
ALIKE_OF_LEG = "a leg that loses no energy or that is moved by its muscles: was it really passive?"
ALIKE_OF_RIG = "a rig does that loses hardly any energy, or one that is driven: was it left alone?"
WHOLLY = 0.995  # share that is all
RESTING = 0.5  # share of a value from which on it rests on the voluntary segments


def identify(result: FitResult) -> Identifiability:
    """Ask a fit what it knows, and from whom.

    **Raises** `ValueError` for a result that has no one fit to ask (`fit_each`), or was saved.

    >>> told = exoid.identify(exoid.fit("drops.csv"))
    >>> len(told.segment_shares["damping_over_inertia"])  # a part of each segment
    2
    """
    if not isinstance(result, FitResult):
        raise ValueError(
            f"identify asks a fit, not a {type(result).__name__}: give what fit returned."
        )
    basis = result.basis_to("ask")
    data = basis.ended.local.data + basis.ended.local.declared
    alone = Information(data, np.zeros_like(data), np.zeros((0, data.shape[0])))
    symbols = {name: each.symbol for name, each in named(result)}
    weights = {name: weights_of(name, basis) for name in symbols}
    absolute = {name: row @ basis.ended.local.quantities for name, row in weights.items()}
    values = {name: float(row @ basis.ended.best.quantities[0]) for name, row in weights.items()}
    gradients = {name: absolute[name] / value for name, value in values.items() if value != 0}
    told = combinations(result, absolute, alone)
    exact = null_directions(gradients, alone, symbols)
    none = not_found(result)
    gone = {name for each in none for name in each.names}
    seen = {name: each for name, each in told.items() if name not in gone}
    weak = weak_directions(gradients, seen, alone, symbols)
    shares = segment_shares(basis, {name: absolute[name] for name in told}, alone)
    mirrored = reversals(basis.problem.movements)
    names, correlation = correlations(told | dict(named(result)), gradients, basis)
    apart = strangers(result)
    told_alone = bool(np.isfinite(alone.standard_error(absolute["inertia"])))
    weighed_off = result.parameters["inertia"].reason == MISPLACED  # which its notes tell
    return Identifiability(
        exact,
        weak,
        told,
        names,
        correlation,
        shares,
        mirrored,
        [
            *apart,
            *(each.words for each in exact),
            *(each.words for each in weak),
            *(each.words for each in none),
            *([] if weighed_off else scale_remark(basis, told_alone)),
            *torque_remarks(basis, shares, mirrored, symbols),
        ],
        apart,
        none,
    )


def combinations(
    result: FitResult, gradients: dict[str, np.ndarray], alone: Information
) -> dict[str, Estimate]:
    """The ratios, J, and what the terms have, where the data alone determine them."""
    told = {}
    known = {**result.ratios, "inertia": result.parameters["inertia"], **result.of_terms}
    for name, each in known.items():
        error = alone.standard_error(gradients[name])
        if each.value is not None and each.shares != HELD and np.isfinite(error):
            told[name] = replace(
                each, standard_error=float(np.hypot(error, rivalled(each))) or None
            )
    return told


def rivalled(each: Estimate) -> float:
    """The part of its error that is there because the model may lack something else."""
    share = (each.limited_by or {}).get(RIVALS, 0.0)
    return (each.standard_error or 0.0) * share**0.5


def segment_shares(
    basis: Basis, gradients: dict[str, np.ndarray], alone: Information
) -> dict[str, np.ndarray]:
    """What part of the data's information on every combination came from which segment."""
    best = take(basis.ended.best, 0)
    places = columns(best.coordinates, basis.problem.observation.owner)
    shares = {}
    for name, gradient in gradients.items():
        pull = inverse_times(alone.likelihood, gradient)
        told_by = zip(best.condensed.factor, places, strict=True)
        each = np.array([np.sum((factor @ pull[at]) ** 2) for factor, at in told_by])
        shares[name] = each / np.sum(each)
    return shares


def correlations(
    quantities: dict[str, Estimate], gradients: dict[str, np.ndarray], basis: Basis
) -> tuple[list[str], np.ndarray]:
    """Of the errors of everything that has one."""
    names = [name for name, each in quantities.items() if each.standard_error and name in gradients]
    information = basis.information
    rows = [information.free.T @ gradients[name] for name in names]
    if not rows:
        return [], np.zeros((0, 0))
    table = np.stack(rows)
    covariance = table @ np.stack([inverse_times(information.posterior, r) for r in rows], axis=1)
    size = np.sqrt(np.diag(covariance))
    return names, covariance / np.outer(size, size)


def torque_remarks(
    basis: Basis,
    shares: dict[str, np.ndarray],
    mirrored: list[Reversal],
    symbols: dict[str, str],
) -> list[str]:
    """Where the assumed form of the torque, and not the leg, made the numbers."""
    damping = float(basis.ended.best.coordinates.shared.damping[0])
    voluntary = np.array([each.voluntary for each in basis.problem.movements])
    resting = {
        name: float(each[voluntary].sum())
        for name, each in shares.items()
        if each[voluntary].sum() > RESTING and name != "torque_over_inertia"
    }
    said = []
    symmetric = [each for each in mirrored if each.mirrored]
    cycles = [each for each in symmetric if each.voluntary]
    if cycles and "damping_over_inertia" in resting and damping < UNDAMPED:
        said.append(
            f"{segments(cycles)} moved the same forwards and backwards in time, and so does the "
            "torque of Eq. 10: that is why d / J is near zero, and m l g / J then measures the "
            "duration, whatever the leg is. Do not use these numbers; record a drop."
        )
    elif resting:
        how = "entirely" if min(resting.values()) > WHOLLY else "mostly"
        names = [symbols[name] for name in resting]
        said.append(
            f"{listed(names)} rest {how} on voluntary segments, where the form of the muscle's "
            "torque (Eq. 10) is assumed: another form gives other values. A drop does not need it."
        )
    still = [each for each in symmetric if not each.voluntary]
    if still:
        said.append(
            f"{segments(still)} moved the same forwards and backwards in time, as "
            + (ALIKE_OF_RIG if basis.problem.belief.rig else ALIKE_OF_LEG)
        )
    return said


def segments(each: list[Reversal]) -> str:
    names = listed([one.segment for one in each])
    return f"segment {names}" if len(each) == 1 else f"segments {names}"
