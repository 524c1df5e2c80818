"""The parameters of terms as estimates."""

from dataclasses import replace

from exoid.fitting.model.term_parameters import ratio_name, ratio_unit
from exoid.fitting.result.estimates.basis import Basis
from exoid.fitting.result.estimates.estimate import Estimate
from exoid.fitting.result.estimates.found import mean_of
from exoid.fitting.result.estimates.moved import Moved
from exoid.fitting.result.estimates.parameters import expectation, within
from exoid.fitting.result.estimates.scale import SCALE_FREE, UNTOLD, goes_with_scale, reason_of
from exoid.physics.parameter import Declaration, declarations
from exoid.physics.term import name_of


def estimate_terms(
    basis: Basis, at_bound: set[str], inertia: Estimate, moved: Moved
) -> dict[str, dict[str, Estimate]]:
    """Every term's parameters; of those that go with J also what motion alone tells. Their errors
    hold how far the fit may have `moved`.
    """

    def off(each: Estimate, name: str) -> Estimate:
        return moved.widen(each, mean_of(basis, [name], set()).gradient)

    found: dict[str, dict[str, Estimate]] = {}
    for term in basis.problem.terms:
        own = found.setdefault(name_of(term), {})
        for name, declared in declarations(term):
            called = f"{name_of(term)}.{name}"
            own[name] = off(term_parameter(called, declared, basis, at_bound), called)
            if declared.inertia_power:
                ratio = term_ratio(called, declared, basis, own[name], at_bound)
                ratio = off(ratio, ratio_name(called, declared))
                own[name] = goes_with_scale(own[name], ratio, inertia)
                own[ratio_name(name, declared)] = by_law(ratio, declared)
            own[name] = by_law(own[name], declared)
    rig = basis.problem.belief.rig
    return {
        term: {name: reason_of(each, rig) for name, each in own.items()}
        for term, own in found.items()
    }


def by_law(each: Estimate, declared: Declaration) -> Estimate:
    """With what is off where the leg follows another law than the term."""
    return each if each.value is None else each.widened(declared.law * abs(each.value))


def term_parameter(name: str, declared: Declaration, basis: Basis, at_bound: set[str]) -> Estimate:
    """One parameter of a term, with what determined it or why nothing did."""
    belief, ends = basis.problem.belief, basis.problem.limits_of_term(name)
    each = within(name, declared, belief, mean_of(basis, [name], at_bound), ends)
    expected, deviation = expectation(belief, name)
    lost = SCALE_FREE if declared.inertia_power else UNTOLD
    return replace(
        each,
        lower=ends[0],
        upper=ends[1],
        expected=expected,
        expected_deviation=deviation,
        reason=lost if each.shares is None else each.reason,
    )


def term_ratio(
    name: str, declared: Declaration, basis: Basis, own: Estimate, at_bound: set[str]
) -> Estimate:
    """What motion alone tells of a term's parameter that goes with J; on a bound other than zero
    its inertia may still be another.
    """
    found = mean_of(basis, [ratio_name(name, declared)], set())
    found = replace(found, held=name in at_bound and own.value == 0.0)
    sign, word = ("/", "over") if declared.inertia_power > 0 else ("*", "times")
    label = f"{declared.symbol} {sign} J", f"{declared.title}, {word} J", ratio_unit(declared)
    ratio = found.estimate(label, reason=found.untold(UNTOLD))
    return replace(ratio, value=0.0) if own.value == 0.0 else ratio
