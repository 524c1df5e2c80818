"""What the next recordings own, and what of it they have in common with those at hand.

The fit of both believes sensors, seat and weights of one session to be off by the same: a second
drop with the same weight does not weigh it once more.
"""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np
from jaxtyping import Float

from exoid.fitting.misfit.uncertainty import Information
from exoid.fitting.model.coordinates import TYPICAL
from exoid.fitting.model.systematics import SOMEWHERE, Systematics, in_common
from exoid.planning.planned import Candidate
from exoid.planning.prior_knowledge import PriorKnowledge, eliminated
from exoid.recordings.declared.sensors import Sensors

NONE = np.zeros(0)


@dataclass(frozen=True)
class Next:
    """A movement of a next recording, as far as it tells what that shares with others."""

    recording: int
    session: str | None
    sensors: Sensors
    thigh_angle: float  # rad
    added_mass: float  # kg
    added_mass_distance: float  # m
    systematics: Systematics
    angular_velocity: bool | None  # None without a gyro
    unplaced: bool = False
    least_mass: float = 0.0  # kg

    @property
    def borne(self) -> float:
        """Its added mass beyond the least of all that is recorded [kg]."""
        return max(self.added_mass - self.least_mass, 0.0)

    @property
    def load(self) -> tuple[float, float | None]:
        """The added mass [kg] and where it sits [m]."""
        return self.added_mass, self.added_mass_distance if self.added_mass > 0 else None


def with_recordings(
    belief: np.ndarray,
    known: PriorKnowledge,
    told: dict[Candidate, np.ndarray],
    chosen: Sequence[Candidate],
) -> np.ndarray:
    """The information of what was recorded, of the `belief`, and of these candidates, a recording
    for every seat and load, on what the belief is of: the leg, and maybe more behind it.
    """
    seats = list(dict.fromkeys(each.seat for each in chosen))
    size, leg, each = len(belief), len(known.prior), len(known.owned)
    held = size + len(known.information) - leg
    total = np.zeros((held + each * len(seats),) * 2)
    total[:size, :size] = belief
    add(total, [*range(leg), *range(size, held)], known.information)
    for one in chosen:
        first = held + each * seats.index(one.seat)
        add(total, [*range(size), *range(first, first + each)], told[one])
    rows = beliefs(known, told, chosen, seats)
    total[size:, size:] += rows.T @ rows
    return eliminated(total, size)


def information_error(total: np.ndarray, known: PriorKnowledge, goal: str) -> float:
    """The standard error of a goal by this information on the leg; inf where nothing tells it."""
    gradient = known.gradients[known.quantities.index(goal)]
    return Information(total, np.zeros_like(total), known.fixed).standard_error(gradient)


def add(total: np.ndarray, places: list[int], part: np.ndarray) -> None:
    """A part to the total, where it belongs."""
    total[np.ix_(places, places)] += part


def beliefs(
    known: PriorKnowledge,
    told: Iterable[Candidate],
    chosen: Sequence[Candidate],
    seats: list[tuple[float, float, float]],
) -> Float[np.ndarray, "row mounting"]:
    """What is believed of the next mountings, given those at hand, which come first: W value / sd.

    W is that of a fit of all of them; its rows of the recordings at hand are in their information.
    """
    new, believed = next_of(known, chosen, seats), deviations_of_next(known, told)
    before = sum(each.size for each in known.mountings.values())
    found = np.zeros((len(known.owned), len(seats), before + len(known.owned) * len(seats)))
    alone, alike = (in_common([*old, *new], known.owned) for old in ((), known.movements))
    first = 0
    for number, name in enumerate(known.owned):
        old = known.mountings.get(name, NONE) / usual(name)
        whitening = getattr(alike if old.size else alone, name)
        theirs = before + number + len(known.owned) * np.arange(len(seats))
        columns = [*range(first, first + old.size), *theirs]
        deviations = np.append(old, np.full(len(seats), believed[name]))
        found[number][:, columns] = whitening[old.size :] / deviations
        first += old.size
    return found.reshape(-1, before + len(known.owned) * len(seats)) if seats else found[0]


def next_of(
    known: PriorKnowledge, chosen: Sequence[Candidate], seats: list[tuple[float, float, float]]
) -> list[Next]:
    """The candidates as movements of recordings that come after those at hand."""
    first = 1 + max((one.recording for one in known.movements), default=-1)
    declared = known.movements[0].systematics if known.movements else known.systematics
    return [
        Next(
            recording=first + seats.index(each.seat),
            session=known.movements[-1].session if known.movements else None,
            sensors=known.movements[-1].sensors if known.movements else Sensors(),
            thigh_angle=each.thigh_angle,
            added_mass=each.motion.added_mass,
            added_mass_distance=each.motion.added_mass_distance,
            systematics=declared,
            angular_velocity=known.gyro or None,
            least_mass=known.least_mass,
        )
        for each in chosen
    ]


def deviations_of_next(known: PriorKnowledge, options: Iterable[Candidate]) -> dict[str, float]:
    """Of a new mounting, in typical steps: the mass sits where the candidates have it, by tape."""
    distance = max((option.motion.added_mass_distance for option in options), default=0.0)
    placed = known.systematics.distance / (distance or SOMEWHERE)
    each = {name: getattr(known.systematics, name, placed) for name in known.owned}
    return {name: size / usual(name) if size else 1.0 for name, size in each.items()}


def usual(name: str) -> float:
    """The step in which a fit counts what a mounting owns."""
    return float(getattr(TYPICAL.mounting, name))
