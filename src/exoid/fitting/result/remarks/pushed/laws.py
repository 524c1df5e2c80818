"""Laws beside Eq. 9 that a fit without them takes for what it has, and their torques."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial

import numpy as np

from exoid.physics.term import Term
from exoid.physics.terms.device.coulomb_friction import CoulombFriction
from exoid.physics.terms.device.torque_bias import TorqueBias
from exoid.physics.terms.tissue.maxwell_element import MaxwellElement
from exoid.physics.terms.tissue.quadratic_drag import QuadraticDrag

RELAXES = np.geomspace(0.1, 0.8, 7).tolist()  # s; tissue that does else is a spring or a damper


@dataclass(frozen=True)
class Law:
    """A torque, and its value over J along a motion, for a unit of the term's first parameter."""

    term: type[Term]
    along: Callable[[np.ndarray, np.ndarray], np.ndarray]  # time [s], rate [rad/s]
    booked: tuple[str, ...] = ("damping",)  # as what a fit without it has it
    of: str = ""  # what else it has, in words

    @property
    def one_way(self) -> bool:
        """Can it only brake?"""
        return self.term is not TorqueBias


def lagging(time: np.ndarray, rate: np.ndarray, relaxation_time: float) -> np.ndarray:
    """-(phi - z) with z' = (phi - z) / t_r, of tissue that was relaxed when the motion began."""
    kept = np.exp(-np.diff(time) / relaxation_time)
    gained = relaxation_time * (1 - kept) * (rate[1:] + rate[:-1]) / 2
    lag = np.zeros(time.size)
    for at, (share, more) in enumerate(zip(kept.tolist(), gained.tolist(), strict=True)):
        lag[at + 1] = share * lag[at] + more
    return -lag


def relaxing(relaxation_time: float) -> Law:
    """Of tissue that relaxes within so many seconds."""
    along = partial(lagging, relaxation_time=relaxation_time)
    return Law(MaxwellElement, along, of=f", t_r = {relaxation_time:.2g} s")


CONSTANT = Law(TorqueBias, lambda _, rate: np.ones_like(rate), ("gravity", "stiffness"))
LAWS = (
    Law(CoulombFriction, lambda _, rate: -np.sign(rate)),
    Law(QuadraticDrag, lambda _, rate: -rate * np.abs(rate)),
    *map(relaxing, RELAXES),
    CONSTANT,
)
