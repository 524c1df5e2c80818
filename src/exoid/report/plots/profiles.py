"""Profiles of a fit: how much worse it gets where one quantity is held elsewhere."""

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import SubFigure

from exoid.fitting.errors.profile import RISE, Profile
from exoid.fitting.result.estimates import RATIOS
from exoid.report.plots.axis import Range, Scale, readable, tick, view
from exoid.report.plots.style import (
    EXPECTED,
    INTERVAL,
    LEVEL,
    PARABOLA,
    PROFILE,
    head,
    in_words,
    name_all,
)
from exoid.report.words.keyboard_text import tidy
from exoid.report.words.text import MOST_DECIMALS, NOT_DETERMINED, exponent, written
from exoid.report.words.typeset import mathtext

MOST = 6  # panels side by side
TOP = 9.5  # of the rise: three standard errors, and a little
FOOT = -3.0  # room for the expectation below the curve
EXPECTED_AT = -1.1  # rise at which the expectation is marked


def rows_of(profiles: dict[str, Profile]) -> list[list[Profile]]:
    """Parameters in the first row, ratios in the next."""
    parameters = [each for each in profiles.values() if each.name not in RATIOS]
    ratios = [each for each in profiles.values() if each.name in RATIOS]
    return [row[:MOST] for row in (parameters, ratios) if row]


def draw_profiles(figure: SubFigure, rows: list[list[Profile]]) -> None:
    """One panel per quantity, on one scale of the rise."""
    head(figure, "How far each quantity can move before the fit gets worse")
    panels = figure.subplots(len(rows), max(map(len, rows)), squeeze=False)
    for row, axes in zip(rows, panels, strict=True):
        for profile, panel in zip(row, axes, strict=False):
            draw_profile(panel, profile)
        for panel in axes[len(row) :]:
            panel.set_axis_off()
        for panel in axes[1:]:
            panel.tick_params(labelleft=False)
        axes[0].set_ylabel("rise of 2 x loss [-]")
    name_all(figure, list(panels.flat), "outside lower center", 5)


def draw_profile(axes: Axes, profile: Profile) -> None:
    """The curve, its 95 % interval, what the standard error alone would say, the expectation."""
    seen = seen_of(profile)
    value = profile.estimate.value
    scale = readable(seen, best(profile) if value is None else value)
    axes.axvspan(*scale.of(interval(profile)), **INTERVAL)
    axes.axhline(RISE, **LEVEL)
    draw_parabola(axes, profile, scale, seen)
    axes.plot(scale.of(profile.value), profile.rise, **PROFILE)
    mark_expected(axes, profile, scale, seen)
    across = np.clip((best(profile) - seen[0]) / (seen[1] - seen[0]), 0.15, 0.85)
    axes.text(across, RISE, "95 %", ha="center", va="bottom", transform=axes.get_yaxis_transform())
    axes.set(xlim=tuple(scale.of(seen)), ylim=(FOOT, TOP), yticks=[0, 3, 6, 9])
    axes.set_xlabel(scale.label(mathtext(profile.estimate.symbol), tidy(profile.estimate.unit)))
    axes.set_title(title(profile), loc="left")
    tick(axes.xaxis, 4)


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


def draw_parabola(axes: Axes, profile: Profile, scale: Scale, seen: Range) -> None:
    """((x - value) / standard error)^2, where there is one."""
    value, error = profile.estimate.value, profile.estimate.standard_error
    if value is not None and error:
        across = np.linspace(*seen, 101)
        axes.plot(scale.of(across), ((across - value) / error) ** 2, **PARABOLA)


def mark_expected(axes: Axes, profile: Profile, scale: Scale, seen: Range) -> None:
    """What the prior expects, with its deviation; in words where it lies outside the view."""
    expected, deviation = profile.estimate.expected, profile.estimate.expected_deviation
    if expected is None:
        return
    bar = None if deviation is None else deviation / 10.0**scale.power
    axes.errorbar(float(scale.of(expected)), EXPECTED_AT, xerr=bar, elinewidth=1, **EXPECTED)
    if not seen[0] <= expected <= seen[1]:
        right = expected > seen[1]
        words = f"expected {expected:.3g} →" if right else f"← expected {expected:.3g}"
        axes.text(
            0.98 if right else 0.02,
            EXPECTED_AT - 0.2,
            words,
            ha="right" if right else "left",
            va="top",
            color=EXPECTED["color"],
            transform=axes.get_yaxis_transform(),
        )


def title(profile: Profile) -> str:
    """Name, value with its error, and the 95 % interval or what is there instead."""
    each = profile.estimate
    value = NOT_DETERMINED if each.value is None else f"{written(each)} {tidy(each.unit)}"
    symbol = mathtext(each.symbol)
    name = symbol if profile.name in RATIOS else f"{in_words(profile.name)} {symbol}"
    return f"{name}\n{value}\n{limits(profile)}"


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
