"""What an anthropometric table is: fractions of a body, how they scatter, and whom it measured."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import NamedTuple

from exoid.physics.anatomy.body.segments import Fractions
from exoid.physics.anatomy.body.size import Body

Range = tuple[float, float]

# How fast a table loses its word outside its sample: the scatter doubles over so much.
MASS_BY_INDEX = 20.0  # kg/m^2: fat and muscle are not shared out alike
SHAPE_BY_INDEX = 40.0  # kg/m^2: lengths and their ratios hardly know of weight
BY_HEIGHT = 0.3  # m


class Scatter(NamedTuple):
    """Standard deviations between people of one mass and height, relative."""

    mass: float
    com_distance: float
    radius: float  # of J / (m l)


@dataclass(frozen=True)
class Table:
    """One source; its numbers are those of a body, its scatter that within its sample."""

    name: str
    fractions: Callable[[Body], Fractions]
    scatter: Scatter
    mass_index: Range  # kg/m^2, of the sample
    height: Range  # m

    def scatter_of(self, body: Body) -> Scatter:
        """Wider the farther the body lies outside the sample."""
        heavier = outside(body.mass_index, self.mass_index)
        taller = outside(body.height, self.height) / BY_HEIGHT
        mass = 1 + heavier / MASS_BY_INDEX + taller
        shape = 1 + heavier / SHAPE_BY_INDEX + taller
        own = self.scatter
        return Scatter(own.mass * mass, own.com_distance * shape, own.radius * shape)


def of_sex(body: Body, each: Mapping[str, Fractions]) -> Fractions:
    """The fractions of a body's sex; without one, the mean of female and male."""
    if body.sex:
        return each[body.sex]
    pairs = zip(each["female"], each["male"], strict=True)
    return Fractions(*((one + other) / 2 for one, other in pairs))


def outside(value: float, of: Range) -> float:
    return max(of[0] - value, value - of[1], 0.0)
