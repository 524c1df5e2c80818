"""A body that nobody has, or hardly anybody: likely a number in another unit, or a lost digit."""

from typing import NamedTuple

from exoid.physics.anatomy.body.size import BUILDS

GROWN = 16.0  # years
LEAST = 30.0  # kg, of a grown person
INFANT = 8.0  # kg; who weighs less cannot sit on the edge of a seat
PLAUSIBLE = (16.0, 40.0)  # kg/m2, of most people
SIZES = (1.0, 2.2)  # m, of most people
USUAL = (12.0, 45.0)  # kg/m2, of grown people, but for some in a thousand
POUND = 0.45359237  # kg
UNITS = {"lb": POUND, "st": 14 * POUND}  # kg, in which people are weighed elsewhere


class Doubt(NamedTuple):
    """What is wrong with a body, in words that follow upon whose it is."""

    says: str
    impossible: bool  # of anybody; else hardly anybody is so


def doubts(mass: float | None, height: float | None, age: float | None) -> tuple[Doubt, ...]:
    """Of a body mass [kg], a height [m] and an age [years], as far as they are known."""
    build = () if mass is None or height is None else doubts_of_build(mass, height, age)
    if any(each.impossible for each in build) or mass is None:
        return build
    if mass < INFANT or (mass < LEAST and (age or 0.0) >= GROWN):
        years = f" at {age:g} years" if age is not None else ""
        return (*build, Doubt(f"weighs {mass:g} kg{years}. Is a digit missing?", True))
    return build


def doubts_of_build(mass: float, height: float, age: float | None) -> tuple[Doubt, ...]:
    """Of a body mass for its height; a child may be lighter than grown people."""
    build, said = mass / height**2, f"weighs {mass:g} kg at {height:g} m, as"
    hint = likely_exchanged(mass, height) or likely_unit(mass, height)
    if not BUILDS[0] <= build <= BUILDS[1]:
        return (Doubt(f"{said} nobody does. Which of them is wrong?{hint}", True),)
    if (age is None or age >= GROWN) and not USUAL[0] <= build <= USUAL[1]:
        hardly = f"{said} hardly anybody does ({build:.0f} kg/m2). Is that right?{hint}"
        return (Doubt(hardly, False),)
    return ()


def likely_exchanged(mass: float | None, height: float | None) -> str:
    """The body that it would be were each number [kg, m] in the place of the other."""
    if mass is None or height is None:
        return ""
    for centimetres in (1.0, 100.0):
        other, tall = height * centimetres, mass / centimetres
        if SIZES[0] <= tall <= SIZES[1] and PLAUSIBLE[0] <= other / tall**2 <= PLAUSIBLE[1]:
            return f" It would be {other:g} kg at {tall:g} m were the two exchanged."
    return ""


def likely_unit(mass: float, height: float) -> str:
    """The unit in which the body mass would be that of most people."""
    for unit, size in UNITS.items():
        if PLAUSIBLE[0] <= mass * size / height**2 <= PLAUSIBLE[1]:
            return f" It would be {mass * size:.3g} kg if it is in {unit}."
    return ""
