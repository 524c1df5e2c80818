"""What a person reads after a fit: values with their errors and units, and what they rest on."""

import numpy as np
from rich.console import Console

from exoid.files.counted import counted
from exoid.fitting.result.agreement import of_the_rest
from exoid.fitting.result.fit_result import FitResult
from exoid.fitting.result.refused.without_numbers import without_numbers
from exoid.fitting.result.remarks.anatomy_remarks import RARE
from exoid.fitting.result.remarks.scale_remarks import of_scale
from exoid.fitting.result.segment_fit import SegmentFit
from exoid.fitting.result.summary import quantities
from exoid.report.tables.leg import (
    BOUND,
    DATA,
    PRIOR,
    mountings,
    parameters,
    ratios,
    segments,
    terms,
)
from exoid.report.tables.table import print_table
from exoid.report.words.astray import astray
from exoid.report.words.estimate import AT_BOUND, written
from exoid.report.words.left_out import left_out
from exoid.report.words.text import aligned, by_reason, capital, heading, in_degrees, note, say
from exoid.trust.identifiability import Identifiability

ALIKE = 0.2  # relative spread of amplitudes
HOLE = 3.0  # usual steps without an angle that are worth a word


def print_fit(result: FitResult, console: Console, told: Identifiability | None = None) -> None:
    """Print the whole fit, and what the recording told where that was asked; 80 columns do. Of one
    that does not follow its recording: how far it misses it, and what may be behind that.
    """
    strangers = [] if told is None else told.strangers
    for sentence in strangers:
        heading(console, "These recordings are not of one leg as it was")
        say(console, capital(sentence))
    print_astray(result, console)
    for sentence in doubted(result):
        heading(console, "Check this before you use a mass or a torque")
        say(console, capital(sentence))
    strange = unlike_body(result)
    for sentence in strange:
        heading(console, "Check this before you use a number")
        say(console, capital(sentence))
    result = without_numbers(result)
    if result.follows:
        print_numbers(result, console)
    if told is not None and result.follows:
        gone = {name for each in told.not_found for name in each.names}
        seen = [each.symbol for name, each in told.combinations.items() if name not in gone]
        alone = ", ".join(seen)
        first = f"by itself, without prior and bounds: {alone or 'nothing'}."
        more = [each for each in told.sentences if each not in strangers]
        note(console, [first, *more], "What the recording tells")
    print_segments(result, console)
    print_quality(result, console)
    print_multistart(result, console)
    note(console, [each for each in remarks(result) if each not in strange])


def print_numbers(result: FitResult, console: Console) -> None:
    """All that the model tells of leg, seat and sensors."""
    print_parameters(result, console)
    print_table(ratios(result), console)
    if result.terms:
        print_table(terms(result), console)
    if result.mountings:
        print_table(mountings(result), console)


def print_astray(result: FitResult, console: Console) -> None:
    """That the fit does not follow its recording, or some of it, before any number."""
    if not result.follows:
        heading(console, "This fit does not follow its recording")
        say(console, astray(result))
        return
    for sentence in of_the_rest(result.segments, result.disturbance):
        heading(console, "This fit follows a part of its recording only")
        say(console, f"{capital(sentence)}")


def doubted(result: FitResult) -> list[str]:
    """That its masses are hardly those of this body."""
    return of_scale(result.parameters, result.segments) if result.follows else []


def unlike_body(result: FitResult) -> list[str]:
    """That hardly any leg of this body moves like this one."""
    return [each for each in result.notes if RARE in each] if result.follows else []


def print_parameters(result: FitResult, console: Console) -> None:
    """With the legend of their bars."""
    print_table(parameters(result.of_leg), console)
    say(
        console,
        f"± one standard error, made by the {DATA} data, the {PRIOR} prior, a {BOUND} bound.",
    )
    say(console, f"Prior: {result.prior}.")


def print_segments(result: FitResult, console: Console) -> None:
    """One line per segment."""
    print_table(segments(result.segments), console)
    mean = result.torque_amplitude
    if mean is not None and mean.value is not None and alike(result.segments):
        say(console, f"Mean torque amplitude tau = {written(mean)} {mean.unit}.")


def alike(segments: list[SegmentFit]) -> bool:
    """Do several cycles have so nearly one amplitude that a mean describes them?"""
    found = [one.torque_amplitude for one in segments if one.torque_amplitude is not None]
    values = [one.value for one in found if one.value is not None]
    return len(values) > 1 and max(values) - min(values) < ALIKE * abs(sum(values) / len(values))


def print_quality(result: FitResult, console: Console) -> None:
    """The misfit beside the noise, and the reading of Eq. 4."""
    heading(console, "Fit")
    noise, angle = result.angle_noise, result.angle_rmse
    lines = {
        "angle RMSE": f"{in_degrees(angle)} deg, {angle / noise:.3g} times the noise floor "
        f"of {in_degrees(noise)} deg",
    }
    if result.velocity_rmse is not None:
        lines["velocity RMSE"] = f"{in_degrees(result.velocity_rmse)} deg/s"
    lines["samples"] = amount(result)
    if without := left_out(result.segments):
        lines["left out"] = without
    if result.torque_frequency is not None:
        lines["torque frequency"] = reading(result)
    aligned(console, lines)


def amount(result: FitResult) -> str:
    """How many samples there are, how many of them hold an angle, and where none is for long."""
    said = f"{result.samples} in {counted(len(result.segments), 'segment')}"
    known = [each.time[np.isfinite(each.angle)] for each in result.segments]
    count = sum(each.size for each in known)
    said += f", {count} with an angle" if count < result.samples else ""
    steps = [np.diff(each) for each in known if each.size > 1]
    holes = [step for each in steps for step in each[each > HOLE * np.median(each)].tolist()]
    return said + (
        f"; {counted(len(holes), 'hole')} of {max(holes):.2g} s at most" if holes else ""
    )


def reading(result: FitResult) -> str:
    """Which f of Eq. 4 was taken, and what the other would have given."""
    chosen, other = result.torque_frequency, result.other_reading_rmse
    if other is None:
        return f"f = {chosen} (Eq. 4; no other was tried)"
    rival = {"1/T": "2/T", "2/T": "1/T"}.get(str(chosen), "the other")
    return (
        f"f = {chosen} (Eq. 4); {rival} gives {in_degrees(other)} deg, "
        f"{other / result.angle_rmse:.3g} times as much"
    )


def print_multistart(result: FitResult, console: Console) -> None:
    """Where the starts ended, and which other sets move the leg in the same way."""
    heading(console, "Multi-start")
    report = result.multistart
    lines = {
        "starts": f"{report.starts}: {report.succeeded} succeeded, {report.at_best} at the best "
        f"cost; {counted(report.distinct, 'distinct minimum', 'distinct minima')}",
    }
    if report.failures:
        lines["failed"] = "; ".join(
            f"{counted(count, 'start')}: {reason}" for reason, count in report.failures.items()
        )
    aligned(console, lines)
    if report.family:
        say(
            console,
            "The family: any set within these ranges that keeps the ratios above fits the motion "
            "equally well.",
        )
        aligned(console, {name: span(result, name) for name in report.family})


def span(result: FitResult, name: str) -> str:
    """The range of one parameter over all sets that fit equally well."""
    lower, upper = result.multistart.family[name]
    unit = result.parameters[name].unit
    if upper - lower <= AT_BOUND * abs(upper):
        return f"{upper:.4g} {unit}, the same in all"
    return f"{lower:.3g} to {upper:.3g} {unit}"


def remarks(result: FitResult) -> list[str]:
    """Why values or errors are missing, each reason once, and the notes."""
    reasons = [(name, each.reason) for name, each in quantities(result).items()]
    torques = [(each.name, each.torque_amplitude) for each in result.segments]
    reasons += [(f"tau of segment {name}", one.reason) for name, one in torques if one is not None]
    missing = [f"{', '.join(names)}: {reason}." for reason, names in by_reason(reasons).items()]
    missing = missing if result.follows else []  # one reason for all, which is said first
    first = {*result.notes[: not result.follows], *doubted(result)}
    said = first | {*of_the_rest(result.segments, result.disturbance)}
    return [*missing, *(note for note in result.notes if note not in said)]
