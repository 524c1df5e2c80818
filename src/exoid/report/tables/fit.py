"""What a person reads after a fit: values with their errors and units, and what they rest on."""

from dataclasses import replace
from math import degrees

from rich.console import Console

from exoid.fitting.result.agreement import of_the_rest
from exoid.fitting.result.fit_result import Estimate, FitResult, SegmentFit
from exoid.fitting.result.limiting_systematics import chief
from exoid.report.tables.identifiability import print_told
from exoid.report.words.text import (
    AT_BOUND,
    aligned,
    capital,
    counted,
    heading,
    in_degrees,
    in_unit,
    say,
    shortened,
    table,
    width,
    with_error,
    written,
)
from exoid.trust.told import Identifiability

ALIKE = 0.2  # relative spread of amplitudes
BAR = 5  # blocks of a bar of shares
DATA, PRIOR, BOUND = "█", "▒", "░"
MOUNTED = {
    "added_mass_distance": "added mass at r",
    "added_mass": "added mass",
    "added_mass_gyration": "its radius of gyration",
    "zero": "encoder zero",
    "tilt": "tilt of the thigh",
    "gyro_scale": "gyro scale - 1",
    "gyro_bias": "gyro bias",
    "clock": "clock - 1",
}
SHORTEST_NAME = 16  # that still tells the segments of two recordings apart


def print_fit(result: FitResult, console: Console, told: Identifiability | None = None) -> None:
    """Print the whole fit, and what the recording told where that was asked; 80 columns do."""
    print_astray(result, console)
    print_parameters(result, console)
    print_ratios(result, console)
    print_terms(result, console)
    print_mountings(result, console)
    if told is not None:
        print_told(told, console)
    print_segments(result, console)
    print_quality(result, console)
    print_multistart(result, console)
    print_remarks(result, console)


def print_astray(result: FitResult, console: Console) -> None:
    """That the fit does not follow its recording, or some of it, before any number."""
    if not result.follows:
        heading(console, "This fit does not follow its recording")
        say(console, f"{capital(result.notes[0])}")
    for sentence in of_the_rest(result.segments, result.disturbance):
        heading(console, "This fit follows a part of its recording only")
        say(console, f"{capital(sentence)}")


def print_parameters(result: FitResult, console: Console) -> None:
    """(m, J, l, d, c) with what was expected, what was allowed and who decided."""
    each = list(result.parameters.values())
    columns = {
        "parameter": [f"{name} {one.symbol}" for name, one in result.parameters.items()],
        "value": [written(one) for one in each],
        "unit": [one.unit for one in each],
        "expected": [expectation(one) for one in each],
        "bounds": [bounds(one) for one in each],
        "set by": [set_by(one) for one in each],
    }
    if width(columns) > console.width:
        del columns["bounds"]
    if width(columns) > console.width:
        columns["parameter"] = list(result.parameters)
    heading(console, "Parameters")
    console.print(table(columns))
    say(
        console,
        f"± one standard error, made by the {DATA} data, the {PRIOR} prior, a {BOUND} bound.",
    )
    say(console, f"Prior: {result.prior}.")


def set_by(each: Estimate) -> str:
    """A bar of the shares, and the word for them: of data, the kind of segment that told it."""
    if each.shares is None:
        return ""
    data = round(BAR * each.shares.data)
    bound = round(BAR * each.shares.bound)
    bar = DATA * data + PRIOR * (BAR - data - bound) + BOUND * bound
    return f"{bar} {each.set_by}"


def print_ratios(result: FitResult, console: Console) -> None:
    """What the motion alone determines."""
    heading(console, "Ratios to the inertia, what motion can tell")
    each = list(result.ratios.values())
    columns = {
        "ratio": list(result.ratios),
        "": [one.symbol for one in each],
        "value": [written(one) for one in each],
        "unit": [one.unit for one in each],
        "set by": [set_by(one) for one in each],
        "limited by": [limited_by(one) for one in each],
    }
    if width(columns) > console.width:  # a note says it, too
        del columns["limited by"]
    console.print(table(columns))


def print_terms(result: FitResult, console: Console) -> None:
    """What the model has beside Eq. 9, and of it what motion alone tells."""
    rows = shown_terms(result)
    if not rows:
        return
    heading(console, "Terms, beside Eq. 9")
    columns = {
        "term": [term.replace("_", " ") for term, _ in rows],
        "": [one.title for _, one in rows],
        " ": [one.symbol for _, one in rows],
        "value": [written(one) for _, one in rows],
        "unit": [one.unit for _, one in rows],
        "set by": [set_by(one) for _, one in rows],
    }
    if width(columns) > console.width:
        del columns["set by"]
    if width(columns) > console.width:
        del columns[""]
    console.print(table(columns))


def shown_terms(result: FitResult) -> list[tuple[str, Estimate]]:
    """Every term's parameters with its name, angles in degrees."""
    return [
        (term, in_print(each))
        for term, parameters in result.terms.items()
        for each in parameters.values()
    ]


def in_print(each: Estimate) -> Estimate:
    """Angles and rates in degrees."""
    if each.unit not in ("rad", "rad/s"):
        return each
    return replace(in_unit(each, degrees(1)), unit=each.unit.replace("rad", "deg"))


def limited_by(each: Estimate) -> str:
    """What limits a number most, and its part of the variance."""
    most = chief(each) if each.standard_error else None
    return "" if most is None else f"{most[0].replace('_', ' ')} {most[1]:.0%}"


def print_mountings(result: FitResult, console: Console) -> None:
    """What every recording owned, where there was something to estimate."""
    rows = [
        (shortened(mounting.recording, 2 * SHORTEST_NAME), name, each)
        for mounting in result.mountings
        for name, each in mounting.known.items()
    ]
    if not rows:
        return
    shown = [in_unit(each, degrees(1)) if "rad" in each.unit else each for *_, each in rows]
    heading(console, "Mounting, of each recording")
    columns = {
        "recording": [recording for recording, *_ in rows],
        "": [MOUNTED[name] for _, name, _ in rows],
        "value": [written(each) for each in shown],
        "unit": [each.unit.replace("rad", "deg") for each in shown],
    }
    console.print(table(columns))


def print_segments(result: FitResult, console: Console) -> None:
    """One line per segment."""
    each = result.segments
    columns = {
        "kind": [one.kind for one in each],
        "from\n[s]": [f"{one.begins:.2f}" for one in each],
        "T [s]": ["" if one.period is None else f"{one.period:.4g}" for one in each],
        "tau [N m]": [torque(one) for one in each],
        "added\n[kg]": [f"{one.added_mass:.3g}" if one.added_mass else "" for one in each],
        "RMSE\n[deg]": [in_degrees(one.angle_rmse) for one in each],
        "noise\n[deg]": [in_degrees(one.angle_noise) for one in each],
    }
    room = max(SHORTEST_NAME, console.width - width(columns) - 2)
    names = {"segment": [shortened(one.name, room) for one in each]}
    heading(console, "Segments")
    console.print(table(names | columns))
    mean = result.torque_amplitude
    if mean is not None and mean.value is not None and alike(each):
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
    lines["samples"] = f"{result.samples} in {counted(len(result.segments), 'segment')}"
    if result.torque_frequency is not None:
        lines["torque frequency"] = reading(result)
    aligned(console, lines)


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


def print_remarks(result: FitResult, console: Console) -> None:
    """Why values or errors are missing, and the notes."""
    said = remarks(result)
    if said:
        heading(console, "Notes")
    for remark in said:
        say(console, f"- {remark}", hanging=2)


def remarks(result: FitResult) -> list[str]:
    """Why values or errors are missing, each reason once, and the notes."""
    reasons: dict[str, list[str]] = {}
    for name, each in {**result.parameters, **result.ratios, **result.of_terms}.items():
        if each.reason is not None:
            reasons.setdefault(each.reason, []).append(name)
    for each in result.segments:
        if each.torque_amplitude is not None and each.torque_amplitude.reason is not None:
            reasons.setdefault(each.torque_amplitude.reason, []).append(
                f"tau of segment {each.name}"
            )
    missing = [f"{', '.join(names)}: {reason}." for reason, names in reasons.items()]
    said = {*result.notes[: not result.follows], *of_the_rest(result.segments, result.disturbance)}
    return [*missing, *(note for note in result.notes if note not in said)]


def expectation(each: Estimate) -> str:
    """expected ± standard deviation."""
    if each.expected is None:
        return ""
    if each.expected_deviation is None:
        return f"{each.expected:.4g}"
    return with_error(each.expected, each.expected_deviation)


def bounds(each: Estimate) -> str:
    """lower..upper; one-sided where only one is known."""
    if each.lower is None:
        return "" if each.upper is None else f"≤ {each.upper:.4g}"
    return f"≥ {each.lower:.4g}" if each.upper is None else f"{each.lower:.4g}..{each.upper:.4g}"


def torque(each: SegmentFit) -> str:
    """The torque amplitude of a segment, empty where no voluntary torque acts."""
    return "" if each.torque_amplitude is None else written(each.torque_amplitude)
