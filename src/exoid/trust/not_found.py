"""Effects that a model has and its recording does not show: how large they may be."""

from collections.abc import Iterator

from scipy.special import ndtr, ndtri

from exoid.fitting.model.term_parameters import ratio_name
from exoid.fitting.result.estimates.estimate import Estimate
from exoid.fitting.result.fit_result import FitResult
from exoid.physics.parameter import Declaration, declarations
from exoid.physics.term import Term, name_of
from exoid.trust.limit import SURE, Limit

NEAR = 2.0  # standard errors from 0, within which an effect may as well be none


def not_found(result: FitResult) -> list[Limit]:
    """Every effect whose size over J, which cannot be negative, is 0 within its error."""
    return [limit for term in result.fitted_terms for limit in of_term(term, result)]


def of_term(term: Term, result: FitResult) -> Iterator[Limit]:
    """Those of one term."""
    name, own = name_of(type(term)), result.terms.get(name_of(type(term)), {})
    sizes = [each for each in declarations(type(term)) if is_size(each[1])]
    for field, declared in sizes:
        ratio = own.get(ratio_name(field, declared))
        if ratio is None or own[field].by_hand is not None or not none_of(ratio):
            continue
        part = f"{declared.title} of " if len(sizes) > 1 else ""
        inertia = 1.0 if result.leg is None else float(result.leg.inertia)
        most, size = upper(ratio), own[field]
        yield Limit(
            names=(f"{name}.{field}", f"{name}.{ratio_name(field, declared)}"),
            title=f"{part}{term.title}",
            symbol=ratio.symbol,
            unit=ratio.unit,
            most=most,
            most_of_leg=upper(size) if size.value and size.standard_error else most * inertia,
            unit_of_leg=declared.unit,
        )


def is_size(declared: Declaration) -> bool:
    """Does it go with J, and is 0 its least?"""
    return declared.inertia_power > 0 and declared.lower == 0.0


def none_of(each: Estimate) -> bool:
    """Is it 0 within its error? What may be the zero of a measured torque instead is not absent."""
    if each.value is None or not each.standard_error:
        return False
    other = 1 - (each.limited_by or {}).get("torque_zero", 0.0)
    return each.value < NEAR * each.standard_error * max(other, 0.0) ** 0.5


def upper(each: Estimate) -> float:
    """Below which it is with a chance of `SURE`, as of a normal that is cut off at 0."""
    value, error = each.value or 0.0, each.standard_error or 0.0
    return value + error * float(ndtri(1 - (1 - SURE) * ndtr(value / error)))
