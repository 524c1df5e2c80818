"""Two saved results side by side, as a person reads them, and as JSON."""

from math import degrees
from pathlib import PurePath
from typing import Any

from rich.console import Console

from exoid.files.counted import counted
from exoid.fitting.result.estimates.estimate import Estimate
from exoid.fitting.result.remarks.zero.slack_angle import TOLD
from exoid.report.document.fit_json import entry
from exoid.report.document.plain_json import plain
from exoid.report.saved.saved_result import SavedResult
from exoid.report.tables.compare import HASHED, ComparedQuantity, Comparison
from exoid.report.tables.fit import unlike_body
from exoid.report.tables.leg import in_print
from exoid.report.tables.same_leg import strangers
from exoid.report.tables.table import Column, Table, print_table, with_unit
from exoid.report.tables.two_diagnoses import diagnosis_entry, side_by_side
from exoid.report.words.estimate import written
from exoid.report.words.person import person
from exoid.report.words.text import (
    aligned,
    capital,
    heading,
    in_degrees,
    in_words,
    say,
    shown_unit,
    with_error,
)

SIDES = ("first", "second")
SAME = f"{degrees(TOLD):.0f} deg"
CLEARLY = 3.0  # errors of a difference, from which on a value is a measure for it


def print_comparison(found: Comparison, sides: list[SavedResult], console: Console) -> None:
    """The quantities, what else the fits say of themselves, and what was asked of them."""
    print_table(quantities(found.quantities), console)
    say(
        console,
        "± one standard error. Second - first is told in % of the first, or in its unit where that "
        f"may be 0, for independent fits{of_slack(found.quantities)}.",
    )
    if found.same_recordings:
        why = "what was asked differently" if found.settings else "rounding, or where starts began"
        say(console, "Both rest on the same recordings, so they are not independent: a "
            f"difference comes from {why}.")  # fmt: skip
    assumed = [each.symbol for each in found.quantities if each.assumed]
    if assumed:
        say(
            console,
            f"{', '.join(assumed)} go with J, which neither recording tells, and are not compared: "
            "look at the ratios to J.",
        )
    for sentence in strangers(found, sides):
        say(console, sentence)
    if any(side.diagnosis for side in sides):
        print_table(side_by_side([side.diagnosis for side in sides]), console)
    for number, side in enumerate(sides):
        heading(console, f"The {SIDES[number]} fit")
        if not side.result.follows:
            say(console, capital(side.result.notes[0]))
        for sentence in unlike_body(side.result):
            say(console, capital(sentence))
        aligned(console, about(side))
    heading(console, "What was asked differently")
    if not found.settings:
        say(console, "Nothing: the settings are the same.")
    aligned(console, {name: f"{a} -> {b}" for name, (a, b) in found.settings.items()})


def of_slack(each: list[ComparedQuantity]) -> str:
    """What the errors of differences hold of where the spring is slack."""
    if not any(one.error is not None and any(one.slack) for one in each):
        return ""
    if each[0].one_leg:
        return f", of one leg whose spring is slack at the same angle in both, to {SAME}"
    return (
        ", and holds what 'if slack' leaves open as of two legs; of one leg it is less: give both "
        "sidecars the same [subject] id and side"
    )


def quantities(each: list[ComparedQuantity]) -> Table:
    """Both, and how far they are apart."""
    names = [f"{in_words(one.name)} {one.symbol}" for one in each]
    columns = {
        "quantity": Column(names, spare=1, brief=[one.symbol for one in each]),
        "first": [value(one.first) for one in each],
        "second": [value(one.second) for one in each],
        "unit": [shown_unit(printed(one).unit) for one in each],
        "second - first": [difference(one) for one in each],
        "in errors": Column([errors(one) for one in each], head="in\nerrors", spare=2),
    }
    return Table("", columns, "Parameters, torque and ratios of both")


def value(each: Estimate | None) -> str:
    return "" if each is None else written(in_print(each))


def difference(each: ComparedQuantity) -> str:
    """Second less first with its error, in % where the first is clearly not 0."""
    if each.difference is None or each.error is None:
        return ""
    first = each.values[0]
    if abs(first) > CLEARLY * each.error:
        percent = 100 / abs(first)
        return f"{signed(each.difference * percent, each.error * percent)} %"
    apart = printed(each, each.difference, each.error)
    return with_unit(signed(apart.value, apart.standard_error), apart.unit)


def printed(
    each: ComparedQuantity, value: float | None = None, error: float | None = None
) -> Estimate:
    """A value of this quantity in the units of a table."""
    return in_print(Estimate(each.symbol, each.name, each.unit, value, error))


def signed(value: float | None, error: float | None) -> str:
    """With a plus, too."""
    assert value is not None
    assert error is not None
    return f"{'+' if value > 0 else ''}{with_error(value, error)}"


def errors(each: ComparedQuantity) -> str:
    """The difference in standard errors, with its sign."""
    apart = each.standard_errors
    return "" if apart is None else f"{apart:+.1f}"


def about(side: SavedResult) -> dict[str, str]:
    """Recordings with the begin of their hash, misfit and starts."""
    result, report = side.result, side.result.multistart
    names = [
        f"{PurePath(str(each['path'])).name} ({str(each['sha256'])[:HASHED]})"
        for each in side.recordings
    ]
    who = dict.fromkeys(person(each.get("subject") or {}) for each in side.recordings)
    of = "; ".join(one for one in who if one)
    return {
        **({"subject": of} if of else {}),
        "recordings": ", ".join(names) or "not told",
        "segments": f"{len(result.segments)}, {counted(result.samples, 'sample')}",
        "angle RMSE": f"{in_degrees(result.angle_rmse)} deg, "
        f"{result.angle_rmse / result.angle_noise:.3g} times the noise floor",
        "starts": f"{report.starts}, {report.at_best} at the best cost",
    }


def comparison_document(found: Comparison, sides: list[SavedResult]) -> dict[str, Any]:
    """The comparison in SI units and radians; null where nothing is known."""
    return plain(
        {
            **{
                name: {
                    "exoid": side.version,
                    "recordings": side.recordings,
                    "settings": side.settings,
                    "follows_recording": side.result.follows,
                    "angle_rmse_rad": side.result.angle_rmse,
                    "diagnosis": diagnosis_entry(side.diagnosis),
                }
                for name, side in zip(SIDES, sides, strict=True)
            },
            "same_recordings": found.same_recordings,
            "strangers": strangers(found, sides),
            "settings_that_differ": found.settings,
            "quantities": {
                each.name: {
                    "symbol": each.symbol,
                    "unit": each.unit,
                    "first": None if each.first is None else entry(each.first),
                    "second": None if each.second is None else entry(each.second),
                    "difference": each.difference,
                    "difference_standard_error": each.error,
                    "standard_errors": each.standard_errors,
                }
                for each in found.quantities
            },
        }
    )
