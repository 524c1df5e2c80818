"""True motions of a leg with something concealed in it, at finer steps than any estimator takes."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial

import jax
import jax.numpy as jnp
import numpy as np
from jaxtyping import Array, Float

from exoid.physics.leg import LegModel, LegParameters
from exoid.physics.motion.simulate import simulate
from exoid.physics.state import LegState
from exoid.physics.term import Term
from exoid.physics.torque import CycleTorque
from exoid.twin.motion import CYCLES, FrequencyReading, Movement

STEP = 0.001  # s, of the simulation
TICK = 0.01  # s, of the sensors
LONGEST = {"passive": 7.0, "active": 2.5}  # s: one compiled program serves every duration
LANES = 8  # movements of a program, or a multiple


@dataclass(frozen=True)
class Motion:
    """Every segment as the leg moves and as perfect electronics would show it, a row a tick."""

    angle: list[np.ndarray]  # rad
    shown_angle: list[np.ndarray]  # rad
    shown_velocity: list[np.ndarray]  # rad/s


def perform(
    leg: LegParameters,
    movements: Sequence[Movement],
    reading: FrequencyReading,
    terms: tuple[Term, ...] = (),
    *,
    step: float = STEP,
) -> Motion:
    """The movements, from the release to the end of the drop or of the cycle."""
    stride = round(TICK / step)
    ticks = round(LONGEST[movements[0].kind] / TICK)
    time = step * jnp.arange(ticks * stride + 1)
    rows = padded([row(each, reading, k) for k, each in enumerate(movements)])
    found = jax.device_get(swings(leg, terms, jnp.asarray(rows), time, stride))
    counts = [round(each.duration / TICK) + 1 for each in movements]
    return Motion(*([each[k, :n] for k, n in enumerate(counts)] for each in found))


def row(movement: Movement, reading: FrequencyReading, number: int) -> list[float]:
    """Start, amplitude, period, frequency of the torque, number of the segment."""
    period = movement.duration
    amplitude = movement.amplitude or 0.0
    return [movement.start_angle, amplitude, period, CYCLES[reading] / period, float(number)]


def padded(rows: list[list[float]]) -> np.ndarray:
    """Repeats of the last row fill the lanes."""
    lanes = -(-len(rows) // LANES) * LANES
    return np.array(rows + [rows[-1]] * (lanes - len(rows)))


@partial(jax.jit, static_argnames="stride")
def swings(
    leg: LegParameters,
    terms: tuple[Term, ...],
    rows: Float[Array, "movement 5"],
    time: Float[Array, " time"],
    stride: int,
):
    def swing(values):
        start, amplitude, period, frequency, number = values
        torque = CycleTorque(amplitude, period, frequency, jnp.zeros(()))
        model = LegModel(leg, torque, terms=terms)
        moved = simulate(model, LegState(start, jnp.zeros(())), time, number)
        seen = (moved.angle, moved.shown_angle, moved.shown_velocity)
        return tuple(samples[::stride] for samples in seen)

    return jax.vmap(swing)(rows)
