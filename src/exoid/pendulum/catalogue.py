"""The measures in the order in which they are told: names, symbols, units, formulas."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import partial

from exoid.pendulum import definitions as read
from exoid.recordings.landmarks.landmarks import Landmarks
from exoid.recordings.landmarks.measure import Measure, NotAllowed


@dataclass(frozen=True)
class Definition:
    """A measure: how it is called, and the formula that reads it."""

    title: str
    symbol: str
    unit: str
    read: Callable[[Landmarks], read.DropReading]


TITLES = {"plateau_angle": "plateau (resting) angle"}  # the others are called by their name

MEASURES: dict[str, Definition] = {
    name: Definition(TITLES.get(name, name.replace("_", " ")), symbol, unit, formula)
    for name, symbol, unit, formula in (
        ("start_angle", "phi_s", "rad", read.start_angle),
        ("first_flexion_amplitude", "A1", "rad", read.first_flexion_amplitude),
        ("plateau_angle", "phi_r", "rad", read.plateau_angle),
        ("plateau_amplitude", "A0", "rad", read.plateau_amplitude),
        ("relaxation_index", "A1 / A0", "1", read.relaxation_index),
        (
            "normalised_relaxation_index",
            f"A1 / ({read.NORM} A0)",
            "1",
            partial(read.relaxation_index, norm=read.NORM),
        ),
        ("expected_relaxation_index", "A1 / A_e", "1", read.expected_relaxation_index),
        ("number_of_oscillations", "N", "1", read.number_of_oscillations),
        ("period", "T", "s", read.period),
        ("time_to_rest", "t_r", "s", read.time_to_rest),
        *(
            (
                f"logarithmic_decrement_{n}",
                f"D{n}",
                "1",
                partial(read.logarithmic_decrement, number=n),
            )
            for n in range(1, read.CYCLES + 1)
        ),
        ("peak_flexion_velocity", "w_f", "rad/s", read.peak_flexion_velocity),
        ("peak_extension_velocity", "w_e", "rad/s", read.peak_extension_velocity),
        ("peak_flexion_acceleration", "a_f", "rad/s^2", read.peak_flexion_acceleration),
        ("peak_extension_acceleration", "a_e", "rad/s^2", read.peak_extension_acceleration),
    )
}


def measures(drop: Landmarks) -> dict[str, Measure]:
    """Every measure of a drop, by name, read or refused."""
    return {name: measure(name, drop) for name in MEASURES}


def measure(name: str, drop: Landmarks) -> Measure:
    declared = MEASURES[name]
    told = (name, declared.title, declared.symbol, declared.unit)
    try:
        found = declared.read(drop)
    except NotAllowed as why:
        return Measure(*told, reason=str(why))
    first = float(drop.track.time[0])  # a leg may have been let go between it and the one before
    marks = tuple(replace(each, time=max(first, each.time)) for each in found.marks)
    return Measure(*told, found.value, found.error, marks)
