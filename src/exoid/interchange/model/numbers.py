"""The numbers of a model with what a fit says of them."""

from collections.abc import Iterable
from dataclasses import fields

from exoid.fitting.result.fit_result import Estimate, FitResult, SegmentFit
from exoid.interchange.model.called import called
from exoid.interchange.model.joint import Number
from exoid.physics.leg import LegParameters
from exoid.physics.parameter import declarations
from exoid.physics.term import Term, name_of
from exoid.physics.torque import CycleTorque, Torque

DRIVE = ("amplitude", "period", "frequency", "onset")


def number_of(name: str, each: Estimate, value: float | None = None) -> Number:
    """An estimate, with the value that the model has where nothing tells one."""
    found = each.value if value is None else value
    assert found is not None
    by = each.set_by if each.value is not None else None
    return Number(name, each.title, each.symbol, each.unit, found, each.standard_error, by)


def leg_numbers(result: FitResult, leg: LegParameters) -> Iterable[Number]:
    for each in fields(leg):
        value = float(getattr(leg, each.name))
        yield number_of(each.name, result.parameters[each.name], value)


def term_numbers(term: Term, result: FitResult) -> tuple[Number, ...]:
    found, name = result.terms[name_of(type(term))], called(type(term))
    return tuple(
        number_of(f"{name}_{field}", found[field], float(getattr(term, field)))
        for field, _ in declarations(type(term))
    )


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
