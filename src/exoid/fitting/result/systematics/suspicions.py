"""What a recording's sensors and seat are suspected of."""

import re

import numpy as np

from exoid.fitting.misfit.missed import Disturbance
from exoid.fitting.multistart.search_result import SearchResult
from exoid.fitting.result.fit_result import MountingFit
from exoid.fitting.result.remarks.gyro_remarks import scale_of
from exoid.fitting.result.remarks.zero.far_zeros import either
from exoid.fitting.solve.problem import Problem
from exoid.recordings.signal.both_sensors.sensor_scales import SCALED

LOOK = "Look what the encoder shows with the knee extended, and give angle_zero_deg."
HALF = 0.5  # of a scale that a fit takes, that gyro and encoder show of each other
CLEAR = 4.0  # errors from which on a value is worth a sentence


def suspicions(problem: Problem, mountings: list[MountingFit], ended: SearchResult) -> list[str]:
    """What of a recording is not as it was declared, in sentences; what differs between several in
    its numbers alone once, with theirs.
    """
    said: dict[str, list[tuple[str, str]]] = {}
    found = ended.disturbance
    sources = [own[0].source for own in problem.recordings]
    for each in mountings:
        tilts = tilted(each, found)
        alike = either(problem, ended, sources.index(each.recording)) if tilts else None
        if alike:
            tilts = [f"{tilts[0]} {alike.sentence} {LOOK}"]
        doubts = (*tilts, *disagreeing(problem, each, found))
        for words in doubts:
            said.setdefault(re.sub(r"\d[\d.e]*", "", words), []).append((each.recording, words))
    if len(mountings) < 2:
        return [words for ((_, words),) in said.values()]
    return [together(each) for each in said.values()]


def together(each: list[tuple[str, str]]) -> str:
    """What is said of one recording by its name, of several with the numbers of the first."""
    names, words = [name for name, _ in each], each[0][1]
    if len(names) == 1:
        return f"{names[0]}: {words}"
    first = "" if len({words for _, words in each}) == 1 else f", by {names[0]}"
    return f"{len(names)} recordings ({', '.join(names)}){first}: {words}"


def tilted(each: MountingFit, found: Disturbance) -> list[str]:
    """A seat that is clearly tilted."""
    tilt = each.tilt
    if tilt is None or tilt.standard_error is None or tilt.value is None:
        return []
    if abs(tilt.value) < CLEAR * tilt.standard_error:
        return []
    value, error = np.degrees(tilt.value), np.degrees(tilt.standard_error)
    if found.cause is not None:
        return [
            f"the fit tilts the thigh by {value:.2g} ± {error:.1g} deg beyond what is declared. "
            "That may be what the model misses, as of a spring that is slack at another angle, or "
            "grows stiffer: hold a level to the thigh; 'exoid diagnose' asks what is missing."
        ]
    return [
        f"the thigh seems to be tilted by {value:.2g} ± {error:.1g} deg beyond what is declared, "
        "and the fit follows that: measure it, and give thigh_angle_deg. A thigh that gives way a "
        "little, or a spring that is slack at another angle or grows stiffer, looks alike: ± holds "
        "what m l g / J and c / J are on a level seat."
    ]


def disagreeing(problem: Problem, each: MountingFit, found: Disturbance) -> list[str]:
    """An encoder and a gyro that disagree in scale."""
    scale, clock = each.gyro_scale, problem.deviation_of("clock")
    if scale is None or scale.value is None or abs(scale.value) < SCALED:
        return []
    if not clock.max() > SCALED / CLEAR:
        return []
    if found.cause is not None:
        own = [one for one in problem.movements if one.source == each.recording]
        if abs(scale_of(own) or 0.0) < HALF * abs(scale.value):
            return []  # the two agree: it makes up for what the model misses
        return [
            f"gyro and encoder seem to disagree by {100 * scale.value:+.2g} % in scale, but that "
            "may be what the model misses: 'exoid diagnose' compares the two without a model."
        ]
    return [
        f"gyro and encoder disagree by {100 * scale.value:+.2g} % in scale. It may be the gyro, "
        "the encoder's gain or the clock, and no motion tells which. The gyro is taken, and ± "
        "allows for the clock, by whose square m l g / J, c / J and tau / J go: compare the clock "
        "with a true one and give clock_uncertainty."
    ]
