"""The weighed mass on the shank, as it changes in the course of a stream."""

from bisect import bisect_right
from dataclasses import dataclass
from math import hypot

from exoid.fitting.model.systematics import GYRATION, MEASURED_GYRATION, PLACED, WEIGHED
from exoid.recordings.recording import Subject


@dataclass(frozen=True)
class Load:
    """From each of the times on [s], a mass [kg] and its distance from the knee [m].

    >>> Load((0.0, 30.0), (0.0, 1.5), (0.0, 0.4)).at(31.0)
    (1.5, 0.4)
    """

    begins: tuple[float, ...] = (0.0,)
    masses: tuple[float, ...] = (0.0,)
    distances: tuple[float, ...] = (0.0,)
    doubt: float = 0.0  # relative standard error of J that comes of weighing and placing it

    def at(self, time: float) -> tuple[float, float]:
        place = max(0, bisect_right(self.begins, time) - 1)
        return self.masses[place], self.distances[place]


def doubt_of(subject: Subject, mass: float, distance: float) -> float:
    """How much of J a mass leaves open that was weighed, placed and shaped as well as is said.

    J is measured in its m (l^2 + k^2), of which the estimator knows m and l. What nobody said is as
    a fit believes it: by a kitchen scale, by tape, and anything up to a wide cuff.
    """
    said, placed = subject.added_mass_uncertainty, subject.added_mass_distance_uncertainty
    weighed = WEIGHED if said is None else said / mass
    away = (PLACED if placed is None else placed) / distance
    gyration = subject.added_mass_gyration
    if gyration is None:
        extent = 3**0.5 * GYRATION**2  # it is there, and scatters by as much again and a half
    else:
        extent = hypot(1.0, 2 * MEASURED_GYRATION) * gyration**2
    return hypot(weighed, 2 * away, extent / distance**2)


def constant_load(subject: Subject) -> Load:
    """One mass for the whole stream, or none.

    **Raises** `ValueError` where it is not said where the mass sits.
    """
    mass, distance = subject.added_mass or 0.0, subject.added_mass_distance or 0.0
    assert not isinstance(mass, tuple)
    assert not isinstance(distance, tuple)
    if not mass:
        return Load()
    check_placed(distance)
    return Load((0.0,), (mass,), (distance,), doubt_of(subject, mass, distance))


def check_placed(distance: float) -> None:
    """**Raises** `ValueError` for a mass of which nobody said where it sits."""
    if distance <= 0:
        raise ValueError(
            "a mass is on the shank and nothing says where: a live estimate needs its distance "
            "from the knee. Give --added-mass-distance M, or added_mass_distance_m in the sidecar."
        )
