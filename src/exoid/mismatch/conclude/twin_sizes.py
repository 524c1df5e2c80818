"""How large what was found is by the name of its exact twin, by the fit that has it."""

from collections.abc import Iterator, Sequence
from dataclasses import replace

import jax
import numpy as np

from exoid.fitting.misfit.uncertainty import Information
from exoid.fitting.model.term_parameters import ratio_name, ratio_unit
from exoid.fitting.result.estimates.basis import Basis
from exoid.fitting.result.estimates.found import Found, mean_of
from exoid.fitting.result.fit_result import FitResult
from exoid.mismatch.answer.diagnosis import Parameter, Suspect
from exoid.mismatch.answer.over_inertia import times_inertia
from exoid.physics.library import library
from exoid.physics.parameter import Declaration, declarations
from exoid.physics.term import Term, name_of


def twin_sizes(after: FitResult, equivalent: list[str], inertia: float) -> list[Parameter]:
    """The sizes of those exact twins that are named as `equivalent`; of a torque also over J."""
    named = {name for each in equivalent for name in each.split(" + ")}
    known = {name_of(term): term for term in library() if name_of(term) in named}
    found: list[Parameter] = []
    if after.basis is None:
        return found
    for term in map(type, after.fitted_terms):
        if term.same_torque in known:
            found += of_same_torque(after, after.basis, term, known[term.same_torque], inertia)
        if term.twin in known:
            found.append(of_twin(after, term, known[term.twin]))
    return found


def of_twin(after: FitResult, term: type[Term], twin: type[Term]) -> Parameter:
    """What shows the same, with an error that grows as its size does."""
    name, _ = first_of(term)
    called, declared = first_of(twin)
    own = after.of_terms[name]
    value = own.value or 0.0
    slope = abs(float(jax.grad(term.as_twin)(value)))
    error = None if own.standard_error is None else slope * own.standard_error
    return Parameter(called, float(term.as_twin(value)), declared.unit, error)


def of_same_torque(
    after: FitResult, basis: Basis, term: type[Term], twin: type[Term], inertia: float
) -> Iterator[Parameter]:
    """What pushes as much, by the size over J and by c / J; a torque for this inertia."""
    name, own = first_of(term)
    called, declared = first_of(twin)
    by_motion = ratio_name(name, own) if own.inertia_power else name
    factors = [mean_of(basis, [each], set()) for each in (by_motion, "stiffness_over_inertia")]
    size = joined(term.as_same_torque, factors, basis.information)
    if not declared.inertia_power:
        yield parameter(called, declared.unit, size)
        return
    known = after.parameters["inertia"].value is not None
    scaled = joined(np.multiply, [size, mean_of(basis, ["inertia"], set())], basis.information)
    whole = parameter(called, declared.unit, scaled)
    ratio = parameter(ratio_name(called, declared), ratio_unit(declared), size)
    error = ratio.standard_error and ratio.standard_error * inertia
    yield whole if known else Parameter(called, size.value * inertia, declared.unit, error)
    yield ratio


def joined(size_of, factors: Sequence[Found], information: Information) -> Found:
    """A quantity of two, with the gradient that it has by both."""
    values = [each.value for each in factors]
    slopes = [
        (size_of(*(values + step)) - size_of(*(values - step))) / (2 * step.sum())
        for step in np.diag(1e-6 * np.maximum(np.abs(values), 1e-3))
    ]
    gradient = sum(
        (slope * each.gradient for slope, each in zip(slopes, factors, strict=True)),
        np.zeros_like(factors[0].gradient),
    )
    return Found(float(size_of(*values)), gradient, information, held=False)


def parameter(name: str, unit: str, found: Found) -> Parameter:
    error = None if found.shares is None else found.information.standard_error(found.gradient)
    return Parameter(name, found.value, unit, error)


def first_of(term: type[Term]) -> tuple[str, Declaration]:
    """The size of a term, as coulomb_friction.level."""
    name, declared = next(declarations(term))
    return f"{name_of(term)}.{name}", declared


def as_fitted(
    one: Suspect, terms: list[str], known: list[Parameter], larger: float, doubt: float = 0.0
) -> Suspect:
    """A suspect that is what was found, or its twin, with the numbers that the fit has of it; any
    other one for the fit's J, so many times as large as that of the search, and as open.
    """
    sizes = {each.name: each for each in known}
    same = len(one.terms) == len(terms) and all(each.name in sizes for each in one.parameters)
    own = [sizes[e.name] if same else times_inertia(e, larger, doubt) for e in one.parameters]
    return replace(one, parameters=own)
