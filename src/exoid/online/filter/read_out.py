"""From what is followed to what a leg is: m l g / J, c / J and d / J.

The offset o is followed as if nothing were known of it. But gravity tells gamma = B / A, and the
seat is level but for its tilt e: o - c gamma = c e. That is a measurement of 0 with the variance
(c / J)^2 var(e), no line in the unknowns; so it is taken anew at every reading, where the filter
stands, and never becomes a part of what is followed.

No drop tells whether a foot puts the centre of mass beside the leg's line, which looks like a tilt
of the seat, nor whether the clock is what encoder and gyro disagree by: errors hold both.

Nor may the spring be slack at full extension: at phi_r it adds (c / J) phi_r to the offset, as
a constant torque does, and o - c gamma = c (e + phi_r). That is no part of the errors, which are of
Eq. 9: `if_slack` tells it beside them.
"""

from math import hypot
from typing import Any

import equinox as eqx
import jax
import jax.numpy as jnp
from jaxtyping import Array, Bool, Float

from exoid.fitting.model.systematics import FOOT
from exoid.fitting.result.remarks.zero.leaning import BENT
from exoid.online.filter.gaussian import Gaussian
from exoid.online.filter.times import times
from exoid.online.model.model import Node
from exoid.online.model.unknowns import AT, Row
from exoid.recordings.signal.both_sensors.sensor_scales import DISAGREE, FARTHEST, SUSPECTED

ROUNDS = 3  # of Gauss-Newton; the last moves nothing
FAR = 5.0  # standard deviations from the seat, which no level lets it be tilted by
POWERS = (2, 2, 1)  # of a clock's rate, by which m l g / J, c / J and d / J go
LEAST = 1e-3  # 1/s^2, of a torque over inertia that nobody could see

Scalar = Float[Array, ""]


class Seated(eqx.Module):
    """The belief on a seat that is level, and on one tilted as a foot makes it look, and as a
    spring does that is slack within BENT of full extension.
    """

    level: Gaussian
    slanted: Gaussian
    slack: Gaussian
    odds: Float[Any, ""]  # that a foot does
    clock: Float[Any, ""]  # standard deviation of its rate, relative

    def told(self, slope: Float[Array, "number unknown"]) -> Float[Array, " number"]:
        """Standard errors of numbers that change so with the unknowns, by what the drops tell: what
        more drops would make smaller.
        """
        return jnp.sqrt(jnp.sum(times(slope, self.level.root) ** 2, axis=1))

    def errors(
        self, values: Float[Array, " number"], slope: Float[Array, "number unknown"], powers: Any
    ) -> Float[Array, " number"]:
        """The same with what no drop tells: a foot, and a clock, with so many powers of whose rate
        the numbers go.
        """
        apart = times(slope, (self.slanted.mean - self.level.mean)[:, None])[:, 0]
        level = self.told(slope) ** 2
        slanted = jnp.sum(times(slope, self.slanted.root) ** 2, axis=1) + apart**2
        clock = jnp.asarray(powers) * values * self.clock
        return jnp.sqrt(level + self.odds * (slanted - level) + clock**2)

    def if_slack(self, slope: Float[Array, "number unknown"]) -> Float[Array, " number"]:
        """How far numbers that change so with the unknowns are off where the spring is slack
        elsewhere than at full extension: root mean square.
        """
        apart = times(slope, (self.slack.mean - self.level.mean)[:, None])[:, 0]
        wider = jnp.sum(times(slope, self.slack.root) ** 2, axis=1) - self.told(slope) ** 2
        return jnp.sqrt(jnp.maximum(apart**2 + wider, 0.0))


def seated(belief: Gaussian, node: Node) -> Seated:
    """The belief with what a node says of seat and clock."""
    level = on_the_seat(belief, node.tilt)
    slack = on_the_seat(belief, hypot(node.tilt, BENT))
    clock = doubted_clock(level, node)
    if node.slant <= node.tilt:
        return Seated(level, level, slack, jnp.zeros(()), clock)
    gain = likelihood(belief, node.slant) - likelihood(belief, node.tilt)
    odds = 1 / (1 + jnp.exp(-gain) * (1 / FOOT - 1))
    return Seated(level, on_the_seat(belief, node.slant), slack, odds, clock)


def doubted_clock(belief: Gaussian, node: Node) -> Float[Array, ""]:
    """How far the clock's rate may be off: as is usual, or by what is declared; where encoder and
    gyro disagree in scale, it may be the clock.
    """
    usual, at = jnp.asarray(node.clock), AT["gyro_scale"]
    if node.clock_declared:
        return usual
    apart, error = jnp.abs(belief.mean[at]), jnp.sqrt(jnp.sum(belief.root[at] ** 2))
    suspected = SUSPECTED * jnp.minimum(apart, FARTHEST)
    return jnp.where(apart > DISAGREE * error, jnp.maximum(suspected, usual), usual)


def likelihood(belief: Gaussian, tilt: float) -> Float[Array, ""]:
    """The logarithm of that of a seat whose tilt has this standard deviation."""
    value, slope, noise = slope_of_seat(belief.mean, tilt)
    total = jnp.sum(times(slope[None], belief.root) ** 2) + noise
    return -(jnp.log(total) + value**2 / total) / 2


def on_the_seat(belief: Gaussian, tilt: Any) -> Gaussian:
    """The belief with what is known of the seat, whose tilt [rad] has this standard deviation."""

    def corrected(_, found: Gaussian) -> Gaussian:
        value, slope, noise = slope_of_seat(found.mean, tilt)
        factor = times(slope[None], belief.root)[0]
        total = jnp.sum(factor**2) + noise
        gain = times(belief.root, factor[:, None])[:, 0] / total
        left = value + jnp.sum(slope * (belief.mean - found.mean))
        mean = belief.mean - gain * left
        narrower = jnp.outer(gain, factor) / (1 + jnp.sqrt(noise / total))
        return Gaussian(mean, belief.root - narrower)

    return jax.lax.fori_loop(0, ROUNDS, corrected, belief)


def off_the_seat(belief: Gaussian, node: Node) -> Bool[Array, ""]:
    """Do the drops contradict what is known of the seat, and of a foot? Then the spring rests
    elsewhere, or a constant torque acts, and the ratios that the seat makes sure of are wrong.
    """
    value, slope, noise = slope_of_seat(belief.mean, max(node.tilt, node.slant))
    total = jnp.sum(times(slope[None], belief.root) ** 2) + noise
    return value**2 > FAR**2 * total


def slope_of_seat(mean: Row, tilt: Any) -> tuple[Scalar, Row, Scalar]:
    """o - c gamma, its derivative by the row, and the variance that a tilt gives it."""

    def tilted(row: Row) -> Scalar:
        turned = row[AT["upright_gravity"]] / row[AT["level_gravity"]]
        return row[AT["offset"]] - row[AT["stiffness"]] * turned

    value, slope = jax.value_and_grad(tilted)(mean)
    return value, slope, (mean[AT["stiffness"]] * tilt) ** 2 + LEAST**2


def ratios(belief: Seated) -> tuple[Float[Array, "3"], Float[Array, "3"]]:
    """m l g / J, c / J and d / J, and their standard errors."""
    found = values(belief.level.mean)
    return found, belief.errors(found, slopes(belief.level.mean), POWERS)


def values(row: Row) -> Float[Array, "3"]:
    gravity = jnp.hypot(row[AT["level_gravity"]], row[AT["upright_gravity"]])
    return jnp.stack([gravity, row[AT["stiffness"]], row[AT["damping"]]])


def slopes(row: Row) -> Float[Array, "3 unknown"]:
    """The derivatives of the ratios by the row."""
    return jax.jacfwd(values)(jnp.asarray(row))
