"""The rows of a study's table of quantities that a result has."""

from collections.abc import Iterator
from dataclasses import dataclass
from math import isfinite, sqrt

from exoid.fitting.result.estimates.estimate import Estimate
from exoid.fitting.result.fit_result import FitResult
from exoid.fitting.result.segment_fit import SegmentFit
from exoid.mismatch.answer.diagnosis import Diagnosis
from exoid.pendulum.drop import Average, Drop, PendulumTest
from exoid.recordings.landmarks.measure import Measure

WHOLE = -1  # the number of no segment: of the whole recording
MEASURED = "recording"  # who determined what is read off without a model


@dataclass(frozen=True)
class Row:
    """One quantity, in SI units; `value` is None where nothing tells it, and `note` says why."""

    segment: int
    step: str
    quantity: str
    value: float | None = None
    standard_error: float | None = None
    unit: str = ""
    determined_by: str = ""
    note: str = ""
    if_slack: float | None = None  # error more, for a spring slack elsewhere than at full extension


def of_drops(test: PendulumTest) -> Iterator[Row]:
    """Every measure of every drop, and the means over drops."""
    for number, each in enumerate(test.drops):
        yield from of_drop(number, each)
    for name, mean in test.average.items():
        yield of_average(name, mean)


def of_drop(number: int, each: Drop) -> Iterator[Row]:
    if each.reason is not None:
        yield Row(number, "drops", "drop", note=each.reason)
    for name, one in each.measures.items():
        yield of_measure(number, name, one)


def of_measure(number: int, name: str, one: Measure) -> Row:
    known = "" if one.value is None else MEASURED
    value, error = number_or_none(one.value), number_or_none(one.standard_error)
    return Row(number, "drops", name, value, error, one.unit, known, one.reason or "")


def of_average(name: str, mean: Average) -> Row:
    count, scatter = len(mean.drops), mean.standard_deviation
    error = None if scatter is None else number_or_none(scatter / sqrt(count))
    said = f"mean of {count} drop{'s' if count > 1 else ''}"
    return Row(WHOLE, "drops", name, number_or_none(mean.mean), error, mean.unit, MEASURED, said)


def of_fit(result: FitResult) -> Iterator[Row]:
    """Ratios, parameters and terms, how well they fit, and what is to be said of it.

    Where the simulation does not follow the recording, no quantity has a value.
    """
    whole = {**result.ratios, **result.parameters, **result.of_terms}
    if result.torque_amplitude is not None:
        whole["torque_amplitude"] = result.torque_amplitude
    for name, each in whole.items():
        yield of_estimate(WHOLE, name, each, result)
    for one in result.segments:
        yield from of_segment(one, result)
    yield Row(WHOLE, "fit", "noise_scale", float(result.noise_scale), unit="1")
    for said in result.notes:
        yield Row(WHOLE, "fit", "note", note=said)


def of_segment(one: SegmentFit, result: FitResult) -> Iterator[Row]:
    number = int(one.name.partition("@")[0])
    if one.torque_amplitude is not None:
        yield of_estimate(number, "torque_amplitude", one.torque_amplitude, result)
    yield Row(number, "fit", "angle_rmse", float(one.angle_rmse), unit="rad")
    if one.velocity_rmse is not None:
        yield Row(number, "fit", "velocity_rmse", float(one.velocity_rmse), unit="rad/s")


def of_estimate(
    number: int, name: str, each: Estimate, result: FitResult, step: str = "fit"
) -> Row:
    if not result.follows:
        return Row(number, step, name, unit=each.unit, note=f"the fit is astray: {result.astray}")
    value, error = number_or_none(each.value), number_or_none(each.standard_error)
    said = each.unit, each.set_by or "", each.reason or ""
    return Row(number, step, name, value, error, *said, number_or_none(each.if_slack))


def of_diagnosis(found: Diagnosis) -> Iterator[Row]:
    """What physics is missing, by name; its sizes, and the leg's ratios with it, each by what
    determines it. Where that is open, there are none.
    """
    for cause in causes(found):
        yield Row(WHOLE, "diagnose", "missing_physics", note=cause)
    after = found.after if found.verdict == "mismatch" else None
    if after is None or not after.follows:
        return
    for name, each in {**after.ratios, **after.of_terms}.items():
        yield of_estimate(WHOLE, name, each, after, "diagnose")


def causes(found: Diagnosis) -> list[str]:
    if found.verdict == "mismatch":
        return [*found.selected, *(["a torque that the library does not know"] * found.novel)]
    return ["none" if found.verdict == "none" else "cannot tell"]


def number_or_none(value: float | None) -> float | None:
    """As a table has it: nothing where it is infinite or no number."""
    return float(value) if value is not None and isfinite(value) else None
