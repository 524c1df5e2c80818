"""Where a multi-start begins: drawn from the limits, from anatomy, and from inverse dynamics."""

from collections.abc import Sequence
from dataclasses import replace
from itertools import product
from numbers import Integral
from typing import Any

import jax
import numpy as np

from exoid.fitting.data.movement import Movement, absent_of, smoothed_motion
from exoid.fitting.data.observe import cycle_torque
from exoid.fitting.data.pace import unhurried
from exoid.fitting.model.coordinates import Coordinates, SegmentUnknowns, shared_of
from exoid.fitting.model.limits import Limits, paper_limits
from exoid.fitting.model.mounting import Mounting
from exoid.fitting.model.systematics import OWNED, owned_by
from exoid.fitting.model.term_parameters import over_inertia, term_of
from exoid.physics.leg import GRAVITY, LegParameters
from exoid.physics.parameter import declarations
from exoid.physics.scale import AS_A_LEG, Scale, ranged
from exoid.physics.term import Term
from exoid.recordings.signal.local_line import local_line

FROM_NONE = 1e-3  # of the upper limit: where a draw begins whose lower limit is zero
SLOPE_WIDTH = 0.08  # s, over which the acceleration is taken for inverse dynamics


def check_draw(count: Any, seed: Any) -> None:
    """Whole numbers: one start or more, a seed that is not negative.

    **Raises** `ValueError` where they are not.
    """
    for name, value, least in (("multistart", count, 1), ("seed", seed, 0)):
        if not isinstance(value, Integral) or value < least:
            raise ValueError(f"{name} is {value!r}: give a whole number, {least} or more.")


def draw(count: int, seed: int, limits: Limits | None = None) -> np.ndarray:
    """`count` vectors (m, J, l, d, c, tau) within the limits, by default those of Eq. 13.

    Every decade alike, J between m l^2 and reach m l where there is room; tau / J between those of
    the strongest leg of the greatest inertia.
    """
    if limits is None or not np.isfinite(limits.reach):  # a rig's: it has none
        limits = paper_limits()
    part = np.random.default_rng(seed).uniform(size=(count, 6))
    low, high = (np.array(jax.tree.leaves(each)) for each in (limits.lower, limits.upper))
    low = np.maximum(low, FROM_NONE * high)
    decades = np.log(np.divide(high, low, out=np.ones(5), where=low > 0))  # fixed at 0: none
    mass, _, distance, damping, stiffness = (low * np.exp(decades * part[:, :5])).T
    reach = float(limits.reach)
    distance = np.minimum(distance, max(reach, low[2]))
    lightest, heaviest = low[1] / (reach * distance), high[1] / distance**2  # with room for a J
    mass = np.clip(np.clip(mass, lightest, heaviest), low[0], high[0])
    least = np.clip(mass * distance**2, low[1], high[1])
    most = np.clip(reach * mass * distance, low[1], high[1])
    inertia = least * (most / least) ** part[:, 1]
    torque = float(limits.torque) * inertia / high[1] * (2 * part[:, 5] - 1)
    return np.stack([mass, inertia, distance, damping, stiffness, torque], axis=1)


def term_starts(
    terms: Sequence[type[Term] | Term],
    movements: list[Movement],
    count: int,
    scale: Scale = AS_A_LEG,
) -> tuple[Term, ...]:
    """`count` starts of the terms: where an instance is; of a class all it declares, in turn."""
    angles = np.concatenate([each.angle for each in movements])
    ends = float(np.nanmin(angles)), float(np.nanmax(angles))

    def begins(term: type[Term] | Term) -> list[tuple[float, ...]]:
        if isinstance(term, type):
            return [ranged(each, scale).starts_between(*ends) for _, each in declarations(term)]
        return [(float(getattr(term, name)),) for name, _ in declarations(type(term))]

    each = [row for term in terms for row in begins(term)]
    rows = np.resize(np.array(list(product(*each)), dtype=float), (count, len(each)))
    classes = [term if isinstance(term, type) else type(term) for term in terms]
    like = tuple(term_of(term, lambda *_: 0.0) for term in classes)
    return jax.tree.unflatten(jax.tree.structure(like), list(rows.T))


def coordinates(
    parameters: np.ndarray,
    movements: list[Movement],
    terms: tuple[Term, ...] = (),
    owned: tuple[str, ...] = OWNED,
) -> Coordinates:
    """The starts (m, J, l, d, c, tau) with terms, every movement from its first measured state."""
    leg, torque = LegParameters(*parameters.T[:-1]), parameters.T[-1]
    first = np.array([first_state(each) for each in movements])
    voluntary = np.array([each.voluntary for each in movements])
    shape = (torque.size, len(movements))
    none = {name: np.zeros(torque.size) for name in absent_of(movements)}
    return Coordinates(
        shared=replace(shared_of(leg), **none),
        log_mass=np.log(leg.mass),
        mounting=usual_mounting(movements, (torque.size,), owned),
        own=SegmentUnknowns(
            torque=(torque / leg.inertia)[:, None] * voluntary,
            angle=np.broadcast_to(first[:, 0], shape).copy(),
            angular_velocity=np.broadcast_to(first[:, 1], shape).copy(),
        ),
        terms=tuple(over_inertia(term, leg.inertia) for term in terms),
    )


def usual_mounting(
    movements: list[Movement], shape: tuple[int, ...] = (), owned: tuple[str, ...] = OWNED
) -> Mounting:
    """The mounting to expect of every recording, as declared, for starts of this shape."""
    count, own = len({each.recording for each in movements}), owned_by(movements, owned)
    return Mounting(*(np.zeros((*shape, count * (name in own))) for name in OWNED))


def first_state(movement: Movement) -> tuple[float, float]:
    """Angle [rad] and angular velocity [rad/s] of the first sample, from the ones around it."""
    angle, velocity = smoothed_motion(movement, unhurried(movement, SLOPE_WIDTH))
    return float(angle[0]), float(velocity[0])


def informed(
    movements: list[Movement], reading: str, mass: float, inertia: float
) -> np.ndarray | None:
    """The start (m, J, l, d, c, tau) that inverse dynamics suggests, None where it has no say.

    Least squares on phi'' = tau s(t)/J - m l g cos(phi)/J - c phi/J - d phi'/J, linear in the
    ratios, so it needs no start itself; biased where the acceleration is noisy. Movements with a
    known mass or torque follow another equation and are left out.
    """
    rows, accelerations = [], []
    for each in movements:
        if each.scaled:
            continue
        time = each.segment.time
        angle, velocity = smoothed_motion(each, SLOPE_WIDTH)
        cycle = cycle_torque(time - each.onset, each, reading)
        rows.append(np.stack([-np.cos(angle), -angle, -velocity, cycle], axis=1))
        accelerations.append(local_line(time, velocity, SLOPE_WIDTH)[1])
    if not rows:
        return None
    solution, *_ = np.linalg.lstsq(np.concatenate(rows), np.concatenate(accelerations), rcond=None)
    gravity, stiffness, damping, torque = solution * inertia
    return np.array([mass, inertia, gravity / (mass * GRAVITY), damping, stiffness, torque])


def driven(movements: list[Movement], mass: float) -> np.ndarray | None:
    """The same where the torque was measured: least squares on tau = J phi'' + m l g cos(phi) +
    c phi + d phi', each side as smooth as the other; None where that makes no leg.
    """
    rows, torques = [], []
    for each in movements:
        time, torque = each.segment.time, each.segment.applied_torque
        assert torque is not None  # `movement` sees to that
        width = unhurried(each, SLOPE_WIDTH)
        angle, velocity = smoothed_motion(each, width)
        acceleration = local_line(time, velocity, width)[1]
        rows.append(np.stack([acceleration, np.cos(angle), velocity, angle], axis=1))
        torques.append(local_line(time, torque, width)[0])
    absent = absent_of(movements)
    has = np.array([1.0, "gravity" not in absent, 1.0, "stiffness" not in absent])
    table, known = np.concatenate(rows) * has, np.concatenate(torques)
    inertia, gravity, damping, stiffness = np.linalg.lstsq(table, known, rcond=None)[0]
    if inertia <= 0:
        return None
    return np.array([mass, inertia, gravity / (mass * GRAVITY), max(damping, 0.0), stiffness, 0.0])
