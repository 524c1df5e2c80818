"""The figures of many sessions: medians, what nine of ten stay below, the worst, failures."""

from collections.abc import Sequence

import numpy as np
from benchmarks.closed_loop.measure import Outcome

MOVES = {
    "off": "motor off",
    "frame": "the frame alone carried, by its own known weight",
    "anatomy": "leg and frame carried, J by anatomy",
    "weighed": "leg and frame carried, J by a known weight",
    "unnoticed": "another leg, of which nobody knows",
    "off again": "the other leg, motor off",
    "anatomy again": "the other leg learned and carried, J by anatomy",
    "weighed again": "the other leg learned and carried, J by a known weight",
}


def report(every: Sequence[Outcome]) -> str:
    return "\n".join([*torques(every), "", *weights(every), "", *courses(every)])


def torques(every: Sequence[Outcome]) -> list[str]:
    lines = [
        "| movement | people | residual rms [N m] | peak [N m] | muscle rms [N m] |",
        "|---|---|---|---|---|",
    ]
    for name, words in MOVES.items():
        efforts = [one.efforts[name] for one in every if name in one.efforts]
        mine = [one for one in efforts if one.carried or name.startswith("off")]
        if not mine:
            continue
        columns = [spread([getattr(one, what) for one in mine]) for what in TORQUES]
        lines.append(f"| {words} | {len(mine)} of {len(every)} | " + " | ".join(columns) + " |")
    return lines


TORQUES = "residual", "peak", "muscle"


def weights(every: Sequence[Outcome]) -> list[str]:
    lines = [
        "| weight that is taken off | error [N m] | of m l g [%] | J off by [%] |",
        "|---|---|---|---|",
    ]
    for name, words in MOVES.items():
        mine = [
            one.gravity[name] for one in every if name in one.gravity and one.efforts[name].carried
        ]
        if not mine:
            continue
        error = spread([one.error for one in mine])
        share = spread([100 * one.share for one in mine], ".1f")
        inertia = spread([100 * abs(one.inertia) for one in mine], ".1f")
        lines.append(f"| {words} | {error} | {share} | {inertia} |")
    return lines


def courses(every: Sequence[Outcome]) -> list[str]:
    """What became of the learning, and of the limits."""
    count = len(every)
    first = [one for one in every if one.first.seconds is not None]
    quick = [one for one in first if one.first.drops == 2]
    found = [one.found for one in every if one.found is not None]
    second = [one for one in every if one.second.seconds is not None]
    drops = spread([one.second.drops for one in second], ".0f") if second else "-"
    worst = {
        what: max(getattr(one.bounds, what) for one in every)
        for what in ("command", "rate", "motor")
    }
    return [
        f"- known after two drops (10 s): {len(quick)} of {count}; after six: {len(first)}",
        f"- one more drop of the same leg doubted: {sum(one.false_alarm for one in every)}",
        f"- another leg found: {len(found)}, after its release by {spread(found)} s",
        f"- the other leg known: {len(second)}, after {drops} drops",
        f"- the largest torque over its limit: command {worst['command']:.3f}, its rate "
        f"{worst['rate']:.3f}, motor {worst['motor']:.3f}",
    ]


def spread(values: Sequence[float], digits: str = ".2f") -> str:
    """Median, what nine of ten stay below, and the largest."""
    if not values:
        return "-"
    return " / ".join(format(each, digits) for each in np.quantile(values, [0.5, 0.9, 1.0]))
