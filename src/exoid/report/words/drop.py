"""What is read off a drop, in words."""

from math import degrees

from exoid.pendulum.drop import Average, Drop
from exoid.recordings.landmarks.measure import Measure
from exoid.report.words.text import shown_unit, with_error

EXPECTED = "expected_relaxation_index"
LARGE = 99.5  # of an error, beyond which two digits of it leave no unit


def loaded(drop: Drop) -> str:
    """The mass that was added, as words that follow its name."""
    return f", {drop.added_mass:.3g} kg added" if drop.added_mass else ""


def value(each: Measure) -> str:
    """In degrees where it is an angle."""
    assert each.value is not None  # only what was read is shown
    return written(each.unit, each.value, each.standard_error)


def mean(each: Average) -> str:
    return written(each.unit, each.mean, each.standard_deviation)


def written(unit: str, number: float, error: float | None) -> str:
    """With its error; thousands of deg/s^2 without a power of ten, to tens where that is enough."""
    number, error = (degrees(each) if "rad" in unit else each for each in (number, error or 0.0))
    if error == 1.0 and number.is_integer():  # a count, which noise may change by one
        return f"{number:.0f} ± 1"
    if error < LARGE:
        return with_error(number, error) if error else f"{number:.4g}"
    return f"{round(number, -1):.0f} ± {round(error, -1):.0f}"


def unit_of(each: Measure | Average) -> str:
    """What `value` and `mean` are written in."""
    return shown_unit(each.unit).replace("rad", "deg")
