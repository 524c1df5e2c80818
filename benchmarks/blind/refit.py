"""What the best baseline leaves of a motion: how large something concealed is, in noise floors.

The baseline is fitted to the encoder alone, so that an error of the gyro shows in the gyro alone.
"""

from dataclasses import dataclass

import jax
import jax.numpy as jnp
import numpy as np
from jaxtyping import Array, Float

from exoid.physics.leg import GRAVITY, LegModel, LegParameters
from exoid.physics.motion.simulate import simulate
from exoid.physics.state import LegState
from exoid.physics.torque import CycleTorque

from .motion import LANES, LONGEST, TICK, Motion, padded, row
from .scenario import Scenario

SHARED = 3  # m l g / J, c / J, d / J; then each segment's tau / J, angle, angular velocity
OWN = 3
ROUNDS = 12  # of Gauss-Newton
HALVINGS = 6
ENOUGH = 1e-5  # relative gain of a round below which no further one is made


@dataclass(frozen=True)
class Left:
    """Root mean squares of what the baseline leaves, without noise."""

    angle: float  # rad
    velocity: float  # rad/s


@dataclass(frozen=True)
class Ratio:
    """Residual with noise over the noise floor, as a fit shows it: 1 where nothing is left."""

    angle: float
    velocity: float


def ratio(scenario: Scenario, motion: Motion) -> Ratio:
    """How far the best baseline stays from a motion."""
    left = refit(scenario, motion)
    return Ratio(
        float(np.hypot(1.0, left.angle / scenario.angle_floor)),
        float(np.hypot(1.0, left.velocity / scenario.velocity_floor)),
    )


def refit(scenario: Scenario, motion: Motion) -> Left:
    """Fit leg, starts and torques to what is shown by Gauss-Newton from the truth."""
    data, weight = stacked(scenario, motion)
    unknowns = truth(scenario)
    residual, slopes = predicted(scenario, unknowns, data)
    for _ in range(ROUNDS):
        before = cost(residual, weight)
        change = step(residual, slopes, weight, active=scenario.active)
        for halving in range(HALVINGS):
            at = unknowns + change / 2**halving
            found = predicted(scenario, at, data)
            if cost(found[0], weight) < before:
                unknowns, (residual, slopes) = at, found
                break
        if cost(residual, weight) > (1 - ENOUGH) * before:
            break
    used = weight > 0
    return Left(*(float(np.sqrt(np.mean(residual[used][:, k] ** 2))) for k in range(2)))


def stacked(scenario: Scenario, motion: Motion) -> tuple[np.ndarray, np.ndarray]:
    """What is shown, a lane a segment, and the weight of its angles, 0 where the lane ended."""
    size = round(LONGEST[scenario.movements[0].kind] / TICK) + 1
    data, weight = np.zeros((LANES, size, 2)), np.zeros((LANES, size))
    shown = zip(motion.shown_angle, motion.shown_velocity, strict=True)
    for lane, channels in enumerate(shown):
        data[lane, : channels[0].size] = np.stack(channels, axis=1)
        weight[lane, : channels[0].size] = 1 / scenario.angle_floor
    return data, weight


def truth(scenario: Scenario) -> np.ndarray:
    """The unknowns of the leg as it was drawn."""
    leg = scenario.leg
    inertia = float(leg.inertia)
    gravity = float(leg.mass * leg.com_distance) * GRAVITY
    shared = np.array([gravity, float(leg.stiffness), float(leg.damping)]) / inertia
    own = np.zeros((LANES, OWN))
    for lane, each in enumerate(scenario.movements):
        own[lane] = (each.amplitude or 0.0) / inertia, each.start_angle, 0.0
    return np.concatenate([shared, own.ravel()])


def predicted(
    scenario: Scenario, unknowns: np.ndarray, data: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Data minus baseline, and the baseline's slopes in every lane's six unknowns."""
    each = [row(movement, scenario.reading, 0) for movement in scenario.movements]
    clocks = jnp.asarray(padded(each)[:, 2:4])
    own = unknowns[SHARED:].reshape(LANES, OWN)
    lanes = np.concatenate([np.tile(unknowns[:SHARED], (LANES, 1)), own], axis=1)
    time = TICK * jnp.arange(data.shape[1])
    shown, slopes = jax.device_get(baseline(jnp.asarray(lanes), clocks, time))
    return data - shown, slopes


@jax.jit
def baseline(
    lanes: Float[Array, "lane 6"], clocks: Float[Array, "lane 2"], time: Float[Array, " time"]
):
    def swing(at, clock):
        gravity, stiffness, damping, push, angle, velocity = at
        one = jnp.ones(())
        leg = LegParameters(one, one, gravity / GRAVITY, damping, stiffness)
        model = LegModel(leg, CycleTorque(push, *clock, jnp.zeros(())))
        moved = simulate(model, LegState(angle, velocity), time)
        return jnp.stack([moved.angle, moved.angular_velocity], axis=1)

    return jax.vmap(swing)(lanes, clocks), jax.vmap(jax.jacfwd(swing))(lanes, clocks)


def step(
    residual: np.ndarray, slopes: np.ndarray, weight: np.ndarray, *, active: bool
) -> np.ndarray:
    """The change of the unknowns that the linearised misfit asks for."""
    lanes, size = weight.shape
    weighted = slopes[:, :, 0] * weight[..., None]
    matrix = np.zeros((lanes, size, SHARED + lanes * OWN))
    matrix[..., :SHARED] = weighted[..., :SHARED]
    for lane in range(lanes):
        first = SHARED + lane * OWN
        matrix[lane, :, first : first + OWN] = weighted[lane, :, SHARED:]
    if not active:
        matrix[..., SHARED::OWN] = 0.0  # nothing pushes
    flat = matrix.reshape(-1, matrix.shape[-1])
    unit = np.linalg.norm(flat, axis=0)
    unit[unit == 0] = 1.0
    misfit = (residual[..., 0] * weight).ravel()
    return np.linalg.lstsq(flat / unit, misfit, rcond=1e-10)[0] / unit


def cost(residual: np.ndarray, weight: np.ndarray) -> float:
    """Sum of squares over the noise; infinite where the baseline ran away."""
    with np.errstate(over="ignore", invalid="ignore"):
        total = float(np.sum((residual[..., 0] * weight) ** 2))
    return total if np.isfinite(total) else np.inf
