"""What is known of a leg before the next recording: from a fit, or from anatomy alone."""

from dataclasses import dataclass, field, replace
from typing import Any

import jax
import jax.numpy as jnp
import numpy as np
from jaxtyping import Float

from exoid.fitting.data.movement import Movement
from exoid.fitting.misfit.missed import Disturbance
from exoid.fitting.misfit.neighbourhood import prior_information, quantity_gradients
from exoid.fitting.model.assumptions import Assumptions
from exoid.fitting.model.belief import NAMES, Belief
from exoid.fitting.model.coordinates import (
    Coordinates,
    SegmentUnknowns,
    Shared,
    flattened,
    leg_parameters,
    quantity_names,
    unflattened,
    with_inertia,
)
from exoid.fitting.model.mounting import Mounting
from exoid.fitting.model.prior_and_limits import believe
from exoid.fitting.model.systematics import OWNED, Systematics, owned_by, under_load
from exoid.fitting.result.fit_result import FitResult
from exoid.fitting.solve.ask import take
from exoid.fitting.solve.problem import Problem
from exoid.physics.leg import GRAVITY, LegParameters
from exoid.physics.term import Term
from exoid.recordings.declared.sensors import Sensors
from exoid.recordings.declared.subject import Subject
from exoid.twin.sensors import SensorKit

LEG = 5  # coordinates of the leg: those that it owns and log m
ANYBODY = LegParameters(*map(np.asarray, (4.4, 0.42, 0.26, 0.36, 2.9)))  # 75 kg, 1.75 m, de Leva
ROUNDING = 1e-13  # relative information that is none
NOTHING = Mounting(*[np.zeros(0)] * len(OWNED))


@dataclass(frozen=True, eq=False)
class PriorKnowledge:
    """A leg and the information on it, every segment's own unknowns eliminated."""

    shared: Shared
    log_mass: Float[Any, ""]
    # of the data, on the coordinates of `point`, and on `mountings` with what is believed of them
    information: Float[np.ndarray, "known known"]
    belief: Belief
    systematics: Systematics  # how well what is declared will be known
    disturbance: Disturbance | None  # what the model misses; it will in the next recording too
    sensors: Sensors
    gyro: bool
    torque: float  # N m, amplitude of voluntary cycles; 0 where none is known
    terms: tuple[Term, ...]  # of the model, as `Coordinates` has them
    checked: bool  # do several movements rest on no form of a torque, one against the other
    movements: tuple[Movement, ...] = ()  # that were recorded
    # by its name, what was believed of it in every recording: one standard deviation
    mountings: dict[str, Float[np.ndarray, " recording"]] = field(default_factory=dict)

    @property
    def point(self) -> Coordinates:
        """The leg and its terms without any segment."""
        nothing = SegmentUnknowns(*[np.zeros(0)] * 3)
        return Coordinates(self.shared, self.log_mass, NOTHING, nothing, self.terms)

    @property
    def quantities(self) -> list[str]:
        """Which quantity every row of `gradients` is."""
        return quantity_names(0, self.classes)

    @property
    def classes(self) -> tuple[type[Term], ...]:
        """Of the terms."""
        return tuple(map(type, self.terms))

    @property
    def least_mass(self) -> float:
        """That was on in what was recorded [kg]."""
        return min((each.added_mass for each in self.movements), default=0.0)

    @property
    def owned(self) -> tuple[str, ...]:
        """What is an unknown of the next recording's mounting."""
        replaced = {term.replaces for term in self.terms}
        return tuple(name for name in owned_by([]) if name not in replaced)

    @property
    def leg(self) -> LegParameters:
        return jax.tree.map(jnp.asarray, leg_parameters(self.point, np))

    @property
    def model_terms(self) -> tuple[Term, ...]:
        """The terms in their own units."""
        return with_inertia(self.point, np)

    @property
    def prior(self) -> np.ndarray:
        return prior_information(self.point, replace(self.belief.prior, mounting=None))

    @property
    def gradients(self) -> np.ndarray:
        """d of every quantity by the coordinates of `point`."""
        return quantity_gradients(self.point)

    @property
    def fixed(self) -> np.ndarray:
        """Those of what the user fixed."""
        return self.gradients[[self.quantities.index(name) for name in self.belief.by_hand.fix]]


def from_anatomy(subject: Subject, assumed: Assumptions | None = None) -> PriorKnowledge:
    """Of nobody in particular where body mass or height is unknown."""
    belief = believe(subject, assumed)
    expected = dict(zip(NAMES, jax.tree.leaves(ANYBODY), strict=True)) | belief.typical
    leg = LegParameters(*(np.asarray(expected[name]) for name in NAMES))
    gravity = leg.mass * leg.com_distance * GRAVITY
    ratios = (np.asarray(each / leg.inertia) for each in (gravity, leg.stiffness, leg.damping))
    kit = SensorKit()
    said: dict[str, Any] = {
        name: off for name, off in under_load(subject).items() if off is not None
    }
    return PriorKnowledge(
        shared=Shared(np.log(leg.inertia), *ratios),
        log_mass=np.log(leg.mass),
        information=np.zeros((LEG, LEG)),
        belief=belief,
        systematics=Systematics(**said),
        disturbance=None,
        sensors=Sensors(
            encoder_counts=float(kit.encoder.counts_per_turn),
            angle_noise=float(kit.encoder.noise),
            velocity_noise=float(kit.gyroscope.noise),
        ),
        gyro=True,
        torque=0.0,
        terms=(),
        checked=False,
    )


def from_result(result: FitResult) -> PriorKnowledge:
    """What a fit knows.

    **Raises** `ValueError` for a result that has no one fit (`fit_each`), or was saved.
    """
    basis = result.basis_to("plan from")
    best, local = take(basis.ended.best.coordinates, 0), basis.ended.local
    first = basis.problem.movements[0]
    gyro = first.angular_velocity is not None
    numbers = unflattened(np.arange(flattened(best).size), best)
    leg = flattened((numbers.shared, numbers.log_mass, numbers.terms)).astype(int)
    kept = np.append(leg, flattened(numbers.mounting)).astype(int)
    others = np.setdiff1d(np.arange(flattened(best).size), leg)
    own = local.data.copy()
    own[np.ix_(others, others)] += local.prior[np.ix_(others, others)]  # of the mountings
    order = np.append(kept, np.setdiff1d(others, kept))
    ratio = result.ratios.get("torque_over_inertia")
    return PriorKnowledge(
        shared=best.shared,
        log_mass=best.log_mass,
        information=eliminated(own[np.ix_(order, order)], kept.size),
        belief=basis.problem.belief,
        systematics=as_found(first.systematics, basis.problem),
        disturbance=basis.ended.disturbance,
        sensors=Sensors(
            angle_noise=first.angle_noise, velocity_noise=first.velocity_noise if gyro else None
        ),
        gyro=gyro,
        terms=best.terms,
        torque=(ratio.value or 0.0) * float(np.exp(best.shared.log_inertia)) if ratio else 0.0,
        checked=sum(not each.voluntary for each in basis.problem.movements) > 1,
        movements=tuple(basis.problem.movements),
        mountings={
            name: basis.problem.deviation_of(name)
            for name in OWNED
            if getattr(best.mounting, name).size
        },
    )


def as_found(declared: Systematics, problem: Problem) -> Systematics:
    """What is believed of the first recording in the end: the next is made by the same hands.

    Where its clock or its seat is doubted (`rare.py`), that of the next will be, too.
    """
    mounting = problem.belief.prior.mounting
    if mounting is None:
        return declared
    doubted = ("clock", "gyro_scale", "tilt")
    wider = {n: float(each[0]) for n in doubted if (each := getattr(mounting, n)).size}
    kept = {name: size for name, size in wider.items() if getattr(declared, name) > 0}
    return replace(declared, **kept)


def eliminated(information: np.ndarray, kept: int) -> np.ndarray:
    """The information on the first `kept` coordinates when the others are unknown (Schur)."""
    a, b, c = information[:kept, :kept], information[:kept, kept:], information[kept:, kept:]
    return a - b @ np.linalg.pinv(c, rcond=ROUNDING, hermitian=True) @ b.T
