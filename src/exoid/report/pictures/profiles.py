"""Profiles of a fit: how much worse it gets where one quantity is held elsewhere."""

import numpy as np

from exoid.fitting.errors.profile import RISE, Profile
from exoid.fitting.result.estimates.ratios import RATIOS
from exoid.report.pictures.axis import Scale, readable, view
from exoid.report.pictures.panel import Axis, Band, Line, Mark, Note, Panel, Points, Range, Rule
from exoid.report.pictures.role import Role
from exoid.report.words.estimate import if_slack, written
from exoid.report.words.text import (
    DIMENSIONLESS,
    MOST_DECIMALS,
    NOT_DETERMINED,
    exponent,
    quantity_words,
)

MOST = 6  # panels side by side
TOP = 9.5  # of the rise: three standard errors, and a little
FOOT = -3.0  # room for the expectation below the curve
EXPECTED_AT = -1.1  # rise at which the expectation is marked
BESIDE = -2.1  # rise at which words stand instead
RISES = tuple((rise, f"{rise:.0f}") for rise in (0.0, 3.0, 6.0, 9.0))


def rows_of(profiles: dict[str, Profile]) -> list[list[Profile]]:
    """Parameters in the first row, ratios in the next, what terms have in the last."""
    rows: list[list[Profile]] = [[], [], []]
    for name, each in profiles.items():
        rows[1 if name in RATIOS else 2 * ("." in name)].append(each)
    return [row[:MOST] for row in rows if row]


def profile_of(profile: Profile) -> Panel:
    """The curve, its 95 % interval, what the standard error alone would say, the expectation."""
    each, seen = profile.estimate, seen_of(profile)
    scale = readable(seen, best(profile) if each.value is None else each.value)
    across = np.clip((best(profile) - seen[0]) / (seen[1] - seen[0]), 0.15, 0.85)
    marks = (
        Band(Role.INTERVAL, *scale.of(interval(profile)).tolist(), upright=True),
        Rule(Role.LEVEL, RISE),
        *parabola(profile, scale, seen),
        Line(Role.PROFILE, scale.of(profile.value), profile.rise),
        *expectation(profile, scale, seen),
        Note("95 %", float(across), RISE),
    )
    return Panel(
        scale.axis(f"`{each.symbol}`", each.unit, seen),
        Axis("rise of 2 x loss", "-", (FOOT, TOP), ticks=RISES),
        marks,
        title(profile),
    )


def best(profile: Profile) -> float:
    """The value of the least loss."""
    return float(profile.value[np.argmin(profile.rise)])


def seen_of(profile: Profile) -> Range:
    """The points up to the first beyond the top; the interval; the expectation if it is near."""
    low = np.flatnonzero(profile.rise < TOP)
    kept = profile.value[max(low[0] - 1, 0) : low[-1] + 2]
    expected = profile.estimate.expected
    near = view([float(kept[0]), float(kept[-1])], np.array([] if expected is None else [expected]))
    inside = expected is None or near[0] <= expected <= near[1]
    return near if inside else view([float(kept[0]), float(kept[-1])], np.zeros(0))


def interval(profile: Profile) -> Range:
    """What the 95 % interval does not exclude, of the values that were looked at."""
    lower, upper = profile.lower, profile.upper
    return (
        float(profile.value[0]) if lower is None else lower,
        float(profile.value[-1]) if upper is None else upper,
    )


def parabola(profile: Profile, scale: Scale, seen: Range) -> tuple[Mark, ...]:
    """((x - value) / standard error)^2, where there is one."""
    value, error = profile.estimate.value, profile.estimate.standard_error
    if value is None or not error:
        return ()
    across = np.linspace(*seen, 101)
    return (Line(Role.PARABOLA, scale.of(across), ((across - value) / error) ** 2),)


def expectation(profile: Profile, scale: Scale, seen: Range) -> tuple[Mark, ...]:
    """What the prior expects, with its deviation; in words where it lies outside the view."""
    expected, deviation = profile.estimate.expected, profile.estimate.expected_deviation
    if expected is None:
        return ()
    if not seen[0] <= expected <= seen[1]:
        right = expected > seen[1]
        words = f"expected {expected:.3g} →" if right else f"← expected {expected:.3g}"
        return (Note(words, 0.98 if right else 0.02, BESIDE),)
    error = None if deviation is None else deviation / 10.0**scale.power
    place = np.atleast_1d(scale.of(expected)), np.array([EXPECTED_AT])
    return (Points(Role.EXPECTED, *place, error),)


def title(profile: Profile) -> str:
    """Name, value with its error, the 95 % interval or what is there instead, and what is open
    beside for where the spring is slack.
    """
    each = profile.estimate
    unit = "" if each.unit in DIMENSIONLESS else f" {each.unit}"
    value = NOT_DETERMINED if each.value is None else f"{written(each)}{unit}"
    name = "" if profile.name in RATIOS else f"{quantity_words(profile.name)} "
    more = f"\nif slack: {if_slack(each)} more" if each.if_slack else ""
    return f"{name}`{each.symbol}`\n{value}\n{limits(profile)}{more}"


def limits(profile: Profile) -> str:
    """The 95 % interval, or which end nothing tells."""
    lower, upper = profile.lower, profile.upper
    if lower is None and upper is None:
        looked = profile.estimate.standard_error is not None
        return "flat as far as was looked" if looked else "flat: nothing tells"
    if lower is not None and upper is not None:
        half = (upper - lower) / 2
        return f"95 %: {digits(lower, half)} to {digits(upper, half)}"
    end = next(each for each in (lower, upper) if each is not None)
    return f"{profile.shape}: {digits(end, abs(end - best(profile)) / 2)}"


def digits(end: float, width: float) -> str:
    """An end of an interval, to the second digit of the interval's width."""
    decimals = max(1 - exponent(width), 0)
    if decimals <= MOST_DECIMALS:
        return f"{end:.{decimals}f}"
    return f"{end:.{max(exponent(end) - exponent(width), 0) + 2}g}"
