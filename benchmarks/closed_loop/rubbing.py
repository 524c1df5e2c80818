"""How much dry friction of the frame each learner bears: legs that are known after two drops."""

from dataclasses import replace

import numpy as np
from benchmarks.closed_loop.learners import Learner
from benchmarks.closed_loop.people import draw_case
from benchmarks.closed_loop.script import Script

LEVELS = 0.0, 0.003, 0.01, 0.03, 0.1, 0.3  # N m


def rubbing(people: int, seed: int, learner: type[Learner]) -> str:
    """A row for each level: how many are known, and how far their m l g / J is off."""
    lines = ["| dry friction [N m] | known after two drops | m l g / J off, median [%] |"]
    lines.append("|---|---|---|")
    for level in LEVELS:
        every = [learned(number, seed, level, learner) for number in range(people)]
        known = [one for one in every if one is not None]
        median = f"{100 * np.median(known):.2f}" if known else "-"
        lines.append(f"| {level:g} | {len(known)} of {people} | {median} |")
    return "\n".join(lines)


def learned(number: int, seed: int, level: float, learner: type[Learner]) -> float | None:
    """The relative error of m l g / J of somebody's leg; None where it is not known."""
    rng = np.random.default_rng([seed, number])
    case = draw_case(rng, 0.0)
    case = replace(case, frame=replace(case.frame, friction=level))
    script = Script(rng, case, learner(case.body, case.frame))
    for _ in range(2):
        script.drop()
    script.lay()
    leg, frame = case.body.leg, case.frame
    truth = (leg.weight + frame.weight) / (leg.inertia + frame.inertia)
    found = script.session.learner
    return abs(found.leg().gravity / truth - 1) if found.knows else None
