"""Which systematic limits a number most, and what would narrow it."""

import re
from collections.abc import Callable, Collection
from dataclasses import replace

import numpy as np

from exoid.fitting.data.movement import Movement
from exoid.fitting.misfit.missed import Disturbance
from exoid.fitting.model.systematics import OF_THE_TORQUE, SLANT
from exoid.fitting.multistart.search_result import SearchResult
from exoid.fitting.result.estimates.estimate import Estimate
from exoid.fitting.result.fit_result import FitResult, MountingFit
from exoid.fitting.result.remarks.gyro_remarks import scale_of
from exoid.fitting.result.remarks.zero.far_zeros import either
from exoid.fitting.solve.problem import Problem

TAPE = 5e-4  # m, to which a tape's millimetres are read
WORTH = 0.3  # of a variance, from which on a systematic is named
WORDS = {
    "zero": "the encoder's zero",
    "tilt": "the seat's tilt, or a foot before the leg's line,",
    "gyro_scale": "the gyro's scale",
    "gyro_bias": "the gyro's bias",
    "clock": "the clock",
    "torque_zero": "the torque sensor's zero",
    "torque_gain": "the torque sensor's gain",
    "added_mass": "the weight of the added mass",
    "added_mass_distance": "the distance of the added mass",
    "added_mass_gyration": "the extent of the added mass",
}
DECLARED_AS = {  # by `Systematics`, where it has another name there
    "added_mass": "log_added",
    "added_mass_distance": "distance",
    "added_mass_gyration": "extent",
}
ADVICE = {
    "zero": "say how well the encoder's zero is known (angle_zero_uncertainty_deg)",
    "tilt": "hold a level to the thigh and give thigh_angle_uncertainty_deg, with what the foot "
    "makes of it",
    "gyro_scale": "turn the node by a known angle and give gyro_scale_uncertainty",
    "gyro_bias": "keep the node still for a while before the release",
    "clock": "compare the clock with a true one and give clock_uncertainty",
    "torque_zero": "take off what it reads with nothing on it, say how well that is known "
    "(torque_zero_uncertainty_nm), or record drops beside it, its motor taken off",
    "torque_gain": "compare it with a known weight on a lever and give torque_gain_uncertainty",
    "added_mass": "weigh the added mass to 0.1 % and give added_mass_uncertainty_kg",
    "added_mass_distance": "measure where it sits and give added_mass_distance_uncertainty_m",
    "added_mass_gyration": "give added_mass_gyration_m, or use a compact weight",
}
GRANTED: tuple[tuple[str, str, Callable[[float], str]], ...] = (
    ("torque_zero", WORDS["torque_zero"], lambda newton_metre: f"{newton_metre:.2g} N m"),
    ("torque_gain", WORDS["torque_gain"], lambda share: f"{100 * share:.2g} %"),
    ("zero", "the encoder's zero", lambda rad: f"{np.degrees(rad):.2g} deg"),
    ("tilt", "the seat's level", lambda rad: f"{np.degrees(rad):.2g} deg"),
    ("gyro_scale", "the gyro's scale", lambda share: f"{100 * share:.2g} %"),
    ("log_added", "the weight of the added mass", lambda share: f"{100 * share:.2g} %"),
    ("distance", "its distance from the knee", lambda off: f"{1e3 * off:.2g} mm"),
    ("clock", "times", lambda share: f"{100 * share:.2g} %"),
)
BY_SCALE = (
    " All that is in N m goes with the weight of the added mass, which no motion shows wrong, and "
    "with its distance, which a mass of another extent hides."
)
AMISS = (
    " Times by a camera or a node without a crystal may be percents off: d / J goes with them, "
    "m l g / J and c / J with their square (clock_uncertainty)."
)
BY_A_FOOT = (
    f"in one leg of two {np.degrees(SLANT):.2g} deg, for its foot puts the centre of mass beside "
    "the shank's line"
)
LOOK = "Look what the encoder shows with the knee extended, and give angle_zero_deg."
HALF = 0.5  # of a scale that a fit takes, that gyro and encoder show of each other
CLEAR = 4.0  # errors from which on a value is worth a sentence
SCALED = 2e-3  # relative disagreement of encoder and gyro below which it is none worth a word


def chief(each: Estimate) -> tuple[str, float] | None:
    """What limits a number most, and its part of the variance; None where nothing stands out."""
    shares = each.limited_by or {}
    name = max(shares, key=shares.__getitem__, default=None)
    return (name, shares[name]) if name is not None and shares[name] >= WORTH else None


def limiting(result: FitResult) -> list[str]:
    """One sentence for each systematic that limits something: what, and what to do. What else
    limits a number has a note of its own.
    """
    found: dict[str, list[str]] = {}
    for each in (*result.parameters.values(), *result.ratios.values()):
        if each.standard_error and (most := chief(each)) and most[0] in WORDS:
            found.setdefault(most[0], []).append(f"{each.symbol} ({most[1]:.0%})")
    return [
        f"{WORDS[name]} limits {', '.join(symbols)} (its part of the variance): "
        f"{what_to_do(name, result)}."
        for name, symbols in found.items()
    ]


def what_to_do(name: str, result: FitResult) -> str:
    """What narrows a systematic: where the motion tells a place better than a tape, or the sidecar
    says already how well something is known, not what was done.
    """
    each = [one.known[name] for one in result.mountings if name in one.known]
    errors = [one.standard_error or np.inf for one in each]
    if name == "added_mass_distance" and errors and max(errors) < TAPE:
        return (
            f"the motion tells it to {1e3 * max(errors):.1g} mm, better than a tape does: drop it "
            "more often, with that mass and without"
        )
    if result.basis is not None and is_declared(name, result.basis.problem):
        return "± holds what the sidecar says of it: only what is known better narrows it"
    return ADVICE[name]


def is_declared(name: str, problem: Problem) -> bool:
    """Do all recordings say how well it is known?"""
    own = DECLARED_AS.get(name, name)
    movements = [one for one in problem.movements if one.added_mass > 0 or name == own]
    return all(own in one.systematics.declared for one in movements)


def limited_anew(result: FitResult, before: FitResult) -> FitResult:
    """The same after its errors were widened from those of `before`: its notes tell what limits a
    number of its error as it is now.
    """
    old, new = limiting(before), limiting(result)
    notes = result.notes
    first = next((at for at, note in enumerate(notes) if note in old), len(notes))
    behind = [note for note in notes[first:] if note not in old]
    kept = new if first < len(notes) else []  # where there were none, none is to be told
    return replace(result, notes=[*notes[:first], *kept, *behind])


def applies(name: str, one: Movement) -> bool:
    """Has a movement what this is known of?"""
    if name in ("log_added", "distance"):
        return one.added_mass > 0 and not (name == "distance" and one.unplaced)
    if name in OF_THE_TORQUE:
        return one.kind == "measured" and one.gain_known
    return name != "gyro_scale" or one.angular_velocity is not None


def known_to(name: str, one: Movement) -> float:
    """One standard deviation of what nobody declares of a movement: a torque's zero in N m."""
    known = one.systematics
    return known.torque_zero * known.torque_reach if name == "torque_zero" else getattr(known, name)


def granted(problem: Problem, doubted: Collection[str] = ()) -> list[str]:
    """How well what no sidecar says is taken to be known, in one sentence, but for what is
    `doubted`.
    """
    said = []
    for name, words, shown in GRANTED:
        each = [
            known_to(name, one)
            for one in problem.movements
            if name not in {*one.systematics.declared, *doubted} and applies(name, one)
        ]
        foot = f" ({BY_A_FOOT})" if name == "tilt" and not problem.belief.rig else ""
        said += [f"{words} to {shown(max(each))}{foot}"] if each else []
    if not said:
        return []
    weighed = BY_SCALE if any("added mass" in each for each in said) else ""
    return [
        f"± takes for granted, where no sidecar says better or worse: {', '.join(said)} (one "
        f"standard deviation).{AMISS if said[-1].startswith('times') else ''}{weighed}"
    ]


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
