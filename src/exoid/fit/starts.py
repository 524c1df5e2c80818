"""Where a multi-start begins: drawn from the bounds, from anatomy, and from inverse dynamics."""

import numpy as np

from exoid.fit.coordinates import Coordinates, Mounting, Own, Shared
from exoid.fit.movement import Movement, smoothed_motion
from exoid.fit.observation import cycle_torque
from exoid.fit.systematics import OWNED
from exoid.physics.leg import GRAVITY, LegParameters
from exoid.physics.parameter import declarations
from exoid.physics.torque import CycleTorque
from exoid.recording.condition import local_line

SLOPE_WIDTH = 0.08  # s, over which the acceleration is taken for inverse dynamics


def draw(count: int, seed: int) -> np.ndarray:
    """`count` vectors (m, J, l, d, c, tau), uniform within the bounds of Eq. 13."""
    declared = [each for _, each in declarations(LegParameters)]
    declared += [each for name, each in declarations(CycleTorque) if name == "amplitude"]
    lower = np.array([each.lower for each in declared])
    upper = np.array([each.upper for each in declared])
    return np.random.default_rng(seed).uniform(lower, upper, size=(count, lower.size))


def coordinates(
    parameters: np.ndarray, movements: list[Movement], greatest_damping: float
) -> Coordinates:
    """The starts (m, J, l, d, c, tau), every movement from its first measured state.

    d/J is held below `greatest_damping` [1/s]: beyond it the time step cannot carry the motion.
    """
    mass, inertia, com_distance, damping, stiffness, torque = parameters.T
    first = np.array([first_state(each) for each in movements])
    voluntary = np.array([each.voluntary for each in movements])
    shape = (mass.size, len(movements))
    return Coordinates(
        shared=Shared(
            log_inertia=np.log(inertia),
            gravity=mass * com_distance * GRAVITY / inertia,
            stiffness=stiffness / inertia,
            damping=np.minimum(damping / inertia, greatest_damping),
        ),
        log_mass=np.log(mass),
        mounting=usual_mounting(movements, (mass.size,)),
        own=Own(
            torque=(torque / inertia)[:, None] * voluntary,
            angle=np.broadcast_to(first[:, 0], shape).copy(),
            angular_velocity=np.broadcast_to(first[:, 1], shape).copy(),
        ),
    )


def usual_mounting(
    movements: list[Movement], shape: tuple[int, ...] = (), owned: tuple[str, ...] = OWNED
) -> Mounting:
    """The mounting to expect of every recording, as declared, for starts of this shape."""
    count = len({each.recording for each in movements})
    return Mounting(*(np.zeros((*shape, count * (name in owned))) for name in OWNED))


def first_state(movement: Movement) -> tuple[float, float]:
    """Angle [rad] and angular velocity [rad/s] of the first sample, from the ones around it."""
    angle, velocity = smoothed_motion(movement, SLOPE_WIDTH)
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
