"""The weighed mass on the shank, as it changes in the course of a stream."""

from bisect import bisect_right
from dataclasses import dataclass, replace
from math import inf

from exoid.fitting.model.systematics import SOMEWHERE
from exoid.physics.anatomy.expected import Expected, ExpectedLeg
from exoid.recordings.declared.subject import Subject


@dataclass(frozen=True)
class Mass:
    """A weight [kg] and its distance from the knee [m]; where that is unknown, about where."""

    weight: float = 0.0
    distance: float = SOMEWHERE
    placed: bool = True  # is the distance known?


BARE = Mass()


@dataclass(frozen=True)
class Load:
    """From each of the times on [s], a mass.

    >>> Load((0.0, 30.0), (Mass(), Mass(1.5, 0.4))).at(31.0).weight  # kg
    1.5
    """

    begins: tuple[float, ...] = (0.0,)
    masses: tuple[Mass, ...] = (BARE,)
    pauses: tuple[float, ...] = ()  # s, after which a gap in the stream is no fault

    def at(self, time: float) -> Mass:
        return self.masses[max(0, bisect_right(self.begins, time) - 1)]

    def paused(self, time: float) -> float:
        """When the last pause, or the last change of the mass, was [s]."""
        every = sorted((*self.pauses, *self.begins[1:]))
        return every[bisect_right(every, time) - 1] if every and time >= every[0] else -inf

    @property
    def known(self) -> bool:
        """Is there any?"""
        return any(each.weight for each in self.masses)


def mass_of(weight: float | None, distance: float | None) -> Mass:
    """**Raises** `ValueError` where it would sit in the knee."""
    if not weight:
        return Mass()
    if distance == 0.0:
        raise ValueError(
            f"the added mass of {weight:g} kg is said to sit 0 m from the knee, where nothing "
            "of it shows. Measure its distance, or leave that out."
        )
    return Mass(weight) if distance is None else Mass(weight, distance)


def constant_load(subject: Subject) -> Load:
    """One mass for the whole stream, or none."""
    weight, distance = subject.added_mass, subject.added_mass_distance
    assert not isinstance(weight, tuple)
    assert not isinstance(distance, tuple)
    if weight and distance is None:
        return Load(masses=(Mass(weight, placed=False),))
    return Load(masses=(mass_of(weight, distance),))


def expected_with(expected: ExpectedLeg, mass: Mass) -> ExpectedLeg:
    """The leg with the mass on it, as if it were one body."""
    bare, weight, distance = expected, mass.weight, mass.distance
    if not weight:
        return bare
    total = bare.mass.value + weight
    moment = bare.mass.value * bare.com_distance.value + weight * distance
    inertia = bare.inertia.value + weight * distance**2
    return replace(
        bare,
        mass=Expected(total, bare.mass.standard_deviation),
        com_distance=Expected(moment / total, bare.com_distance.standard_deviation),
        inertia=Expected(inertia, bare.inertia.standard_deviation),
    )
