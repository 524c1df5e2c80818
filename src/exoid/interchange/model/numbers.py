"""The numbers of a model with what a fit says of them."""

from collections.abc import Iterable
from dataclasses import fields, replace

from exoid.fitting.result.estimates.estimate import Estimate
from exoid.fitting.result.estimates.ratios import MOMENT
from exoid.fitting.result.fit_result import FitResult
from exoid.fitting.result.segment_fit import SegmentFit
from exoid.interchange.model.called import called
from exoid.interchange.model.joint import Number
from exoid.physics.leg import GRAVITY, LegParameters
from exoid.physics.parameter import declarations
from exoid.physics.term import Term, name_of
from exoid.physics.torque import CycleTorque, Torque
from exoid.trust.limit import Limit
from exoid.trust.not_found import is_size, not_found

LEG_RATIOS = ("gravity_over_inertia", "stiffness_over_inertia", "damping_over_inertia")
DRIVE = ("amplitude", "period", "frequency", "onset")


def number_of(name: str, each: Estimate, value: float | None = None) -> Number:
    """An estimate, with the value that the model has where nothing tells one."""
    found = each.value if value is None else value
    assert found is not None
    by = each.set_by if each.value is not None else None
    label = name, each.title, each.symbol, each.unit
    return Number(*label, found, each.standard_error, by, each.if_slack)


def leg_numbers(result: FitResult, leg: LegParameters) -> Iterable[Number]:
    """With a mass on it J is known to the same share: what tells J is the weight of that mass."""
    for each in fields(leg):
        value = float(getattr(leg, each.name))
        found = number_of(each.name, result.parameters[each.name], value)
        if each.name == "inertia":
            assert result.leg is not None
            found = with_errors(found, value / float(result.leg.inertia))
        yield found


def gravity_number(result: FitResult, leg: LegParameters) -> Number:
    """m l g, known better than m and l; with a mass on the leg to the same share."""
    assert result.leg is not None
    moment, bare = (float(each.mass) * float(each.com_distance) for each in (leg, result.leg))
    each = result.gravity_moment or Estimate(*MOMENT, value=None, standard_error=None)
    found = number_of("gravity", each, moment * GRAVITY)
    return with_errors(found, moment / bare) if bare else found


def with_errors(each: Number, times: float) -> Number:
    """The number, its errors so many times as large."""
    error, more = (None if one is None else one * times for one in (each.error, each.if_slack))
    return replace(each, error=error, if_slack=more)


def ratio_numbers(result: FitResult, leg: LegParameters) -> Iterable[Number]:
    """What motion alone tells of this leg and its terms. With a mass on it the ratios are others,
    of which the fit tells no error.
    """
    assert result.leg is not None
    loaded = float(leg.inertia) / float(result.leg.inertia)
    moment = float(leg.mass * leg.com_distance) / float(result.leg.mass * result.leg.com_distance)
    for name in LEG_RATIOS:
        each = result.ratios.get(name)
        if each is not None and each.value:
            times = (moment if name == LEG_RATIOS[0] else 1.0) / loaded
            yield as_loaded(number_of(name, each), times)
    none = {each.names[1]: f"none found, {each.over_inertia}" for each in not_found(result)}
    for term, own in result.terms.items():
        for name, each in own.items():
            over = name.endswith("_over_inertia")
            if each.value and (over or name.endswith("_times_inertia")):
                number = number_of(f"{term}_{name}", each)
                if f"{term}.{name}" in none:
                    number = replace(number, by=none[f"{term}.{name}"])
                yield as_loaded(number, 1 / loaded if over else loaded)


def as_loaded(each: Number, times: float) -> Number:
    if times == 1.0:
        return each
    value = times * each.value
    return replace(each, value=value, error=None, if_slack=None, by="with the added mass")


def term_numbers(term: Term, result: FitResult) -> tuple[Number, ...]:
    found, name = result.terms[name_of(type(term))], called(type(term))
    none = {each.names[0]: f"none found, {each.of_leg}" for each in not_found(result)}

    def number(field: str) -> Number:
        own = number_of(f"{name}_{field}", found[field], float(getattr(term, field)))
        said = none.get(f"{name_of(type(term))}.{field}")
        return own if said is None else replace(own, by=said)

    return tuple(number(field) for field, _ in declarations(type(term)))


def effects_not_found(result: FitResult) -> dict[str, Limit]:
    """By what an exported file calls their terms, those of which the recording shows nothing at
    all.
    """
    none = {each.names[0]: each for each in not_found(result)}
    found = {}
    for term in map(type, result.fitted_terms):
        sizes = [f"{name_of(term)}.{name}" for name, one in declarations(term) if is_size(one)]
        if sizes and all(each in none for each in sizes):
            found[called(term)] = none[sizes[0]]
    return found


def drive_numbers(drive: Torque, each: SegmentFit) -> tuple[Number, ...]:
    """Those of Eq. 10, as far as it acts."""
    if not isinstance(drive, CycleTorque):
        return ()
    error = each.torque_amplitude.standard_error if each.torque_amplitude else None
    by = each.torque_amplitude.set_by if each.torque_amplitude else None
    said = dict(declarations(CycleTorque))
    return tuple(
        Number(
            f"drive_{name}",
            said[name].title,
            said[name].symbol,
            said[name].unit,
            float(getattr(drive, name)),
            error if name == "amplitude" else None,
            by if name == "amplitude" else "the recording",
        )
        for name in DRIVE
    )
