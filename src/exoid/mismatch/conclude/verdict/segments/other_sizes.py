"""That every segment by itself is followed, and not all of them together: what acts there has
another size in each, as dry friction of a joint that warms up, or a muscle's tone.
"""

from collections.abc import Iterator

import numpy as np

from exoid.fitting.model.term_parameters import ratio_unit
from exoid.mismatch.conclude.numbers import leg_of
from exoid.mismatch.screen.hypothesis import Hypothesis, Optimum
from exoid.mismatch.screen.optimise import FLOOR, settle_free
from exoid.mismatch.screen.prepared_recording import PreparedRecording
from exoid.mismatch.search.found import Found, names, unscaled_covariance, words
from exoid.physics.parameter import declarations
from exoid.physics.term import name_of

MOST = 8  # segments that are asked one by one
FIRST = 3  # single causes that are, the best first
APART, SURELY = 0.05, 4.0  # relative, and errors, by which a number of the segments differs
LEGS = "a muscle that is not relaxed alike, a joint that warms up, or a seat or a sensor that moved"
RIGS = "friction that changes as a bearing warms up, or a sensor that moved"
EACH = "Every segment by itself, with what it is said to have: exoid fit --each{}."


def of_other_sizes(found: Found, best: Optimum) -> tuple[list[str], list[str]]:
    """Why nothing is claimed of all segments where Eq. 9, or one cause beside it, follows each by
    itself down to the noise, in a sentence, and what to ask.
    """
    prepared = found.prepared
    if not 1 < prepared.segments <= MOST or found.yardstick.explains(best.square):
        return [], []
    for one in (found.base, *found.singles[:FIRST]):
        each = each_by_itself(prepared, one)
        if each is None:
            continue
        if differing := list(told_by_each(found, each)):
            return [sentence(prepared, one, differing)], [EACH.format(option(one))]
    return [], []


def each_by_itself(prepared: PreparedRecording, one: Optimum) -> list[Optimum] | None:
    """The same explanation, fitted to each segment alone; None where one remains unexplained."""
    seen = prepared.seen
    counts = (seen.angle_weight > 0).sum(axis=1) + (seen.velocity_weight > 0).sum(axis=1)
    found = []
    for alone, count in zip(np.eye(prepared.segments), counts, strict=True):
        found.append(settle_free(prepared, one.candidate, seen.weighed(alone[:, None])))
        if not found[-1].square < FLOOR * count:
            return None
    return found


def told_by_each(found: Found, each: list[Optimum]) -> Iterator[str]:
    """What differs of the leg and of the size of the cause, over J, in words."""
    prepared, shared = found.prepared, found.prepared.numbers.shared
    candidates = [one.candidate for one in each]
    errors = [np.sqrt(np.diag(unscaled_covariance(prepared, one))) for one in each]
    inertia = np.exp([float(leg_of(found, one).log_inertia) for one in each])
    at = candidates[0].point.size + candidates[0].zero.size
    for term, value in zip(candidates[0].terms, candidates[0].values, strict=True):
        name, declared = next(declarations(term))
        over, unit = (
            (" / J", ratio_unit(declared)) if declared.inertia_power else ("", declared.unit)
        )
        scale = inertia**-declared.inertia_power
        called = f"{words([name_of(term)])}: {name.replace('_', ' ')}{over}"
        yield from apart(called, unit, *sizes(candidates, errors, at, scale))
        at += value.size
    ratios = [("d / J", shared.damping, "1/s")]
    if not prepared.rig:
        own = ("m l g / J", shared.gravity, "1/s^2"), ("c / J", shared.stiffness, "1/s^2")
        ratios = [*own, *ratios]
    for symbol, number, unit in ratios:
        scale = np.full(len(each), prepared.units[number])
        yield from apart(symbol, unit, *sizes(candidates, errors, int(number), scale))


def sizes(
    candidates: list[Hypothesis], errors: list[np.ndarray], at: int, scale: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """What each segment has for one unknown, and its error."""
    values = np.array([one.unknowns[at] for one in candidates])
    return values * scale, np.array([error[at] for error in errors]) * scale


def apart(called: str, unit: str, values: np.ndarray, errors: np.ndarray) -> Iterator[str]:
    """What each segment says, where that differs by more than noise and by enough to matter."""
    least, most = int(np.argmin(values)), int(np.argmax(values))
    error = float(np.hypot(errors[least], errors[most]))
    if values[most] - values[least] > max(SURELY * error, APART * np.abs(values).max()):
        yield f"{called} {', '.join(f'{value:.3g}' for value in values)} {unit}"


def sentence(prepared: PreparedRecording, one: Optimum, differing: list[str]) -> str:
    """What follows each segment, and what differs between them."""
    beside = f" with {words(names(one))}" if names(one) else ""
    segments = ", ".join(movement.name for movement in prepared.problem.movements)
    return (
        f"Eq. 9{beside} follows each segment by itself down to the noise, and not all of them "
        f"together: {'; '.join(differing)} in segments {segments}. Every model here has one size "
        f"for all: {RIGS if prepared.rig else LEGS} look like this"
    )


def option(one: Optimum) -> str:
    """How a fit of each has it."""
    return "".join(f" --with {name}" for name in names(one))
