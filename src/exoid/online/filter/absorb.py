"""One sample into a belief: a step of the leg, then encoder and gyro, one after the other.

The root of the covariance stays a lower triangle throughout: of a step only its last two rows move,
and a measurement multiplies it by the triangle of `correct`. Nothing is ever subtracted, so that no
rounding makes a variance negative.
"""

from collections.abc import Callable
from typing import Any

import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np
from jaxtyping import Array, Bool, Float

from exoid.online.filter.gaussian import Gaussian
from exoid.online.filter.loosen import loosened
from exoid.online.filter.motion import Span, advance, view
from exoid.online.filter.sensor_noise import SensorNoise
from exoid.online.filter.times import times
from exoid.online.model.model import Model
from exoid.online.model.sample import Sample
from exoid.online.model.unknowns import AT, Row

Pair = Float[Array, "2"]

ROUGHNESS = 1e-5  # rad/s in 10 ms: rounding, and what no model has; 400 steps add 0.2 mrad/s
TICK = 0.01  # s
MOST = 1e3  # chi-square that one sample counts at most for the likelihood of a belief
WHITE = 0.5  # of a sensor's variance that must be white to tell how large that is
UNSEEN = 1.0  # the place holder of a variance where nothing was measured


class Innovation(eqx.Module):
    """How far a sample surprised a belief; 0 where nothing was measured, or nothing believed."""

    whitened: Float[Array, "2"]  # of unit variance each, where the belief is right
    square: Float[Array, "2"]  # what surprised, less what the belief allowed, over the noise
    tells: Bool[Array, "2"]  # is that square worth anything? The belief is surer than the sensor
    white: Float[Array, "2"]  # the share of the sensors' variance that surely is white
    log_likelihood: Float[Array, ""]
    used: Bool[Array, "2"]
    far: Float[Array, ""]  # chi-square of both


def absorb(
    model: Model, belief: Gaussian, sample: Sample, span: Span, noise: SensorNoise
) -> tuple[Gaussian, Innovation]:
    """The belief after a span of time and the sample at its end."""
    ahead = carried_on(model, belief, sample, span)
    drift = noise.drift * jnp.sqrt(span.length)
    ahead = Gaussian(ahead.mean, loosened(ahead.root, AT["gyro_delay"], drift))

    def shown(row):
        seen = view(model.unknowns, row, sample)
        return seen.shown, seen

    slope, found = jax.jacfwd(shown, has_aux=True)(ahead.mean)
    seen, sensors = times(slope, ahead.root), noise.variance(found.acceleration)
    measured = jnp.stack([jnp.asarray(sample.angle), jnp.asarray(sample.angular_velocity)])
    known = ~jnp.isnan(measured)
    off = jnp.where(known, measured - found.shown, 0.0)
    far = chi_square(off, known, seen, sensors)
    used = known & (far < noise.gate)
    after, surprise, variance = corrected(ahead, seen, off, sensors, used)
    size = jnp.where(used, jnp.log(variance), 0.0)
    whitened = surprise / jnp.sqrt(variance)
    white = noise.white(sensors)
    told = (jnp.sum(seen**2, axis=1) < sensors) & used & (white > WHITE)
    square = jnp.where(told, (surprise**2 - variance + sensors) / sensors, 0.0)
    gated = jnp.where(far < noise.gate, 0.0, jnp.minimum(far, MOST))
    likelihood = -(jnp.sum(whitened**2 + size) + gated) / 2
    return after, Innovation(whitened, square, told, white, likelihood, used, far)


def carried_on(model: Model, belief: Gaussian, sample: Sample, span: Span) -> Gaussian:
    """The belief a span of time later, before the sample is looked at."""

    def arrival(row):
        reached = advance(model.unknowns, row, sample, span)
        return reached.state, reached

    slope, reached = jax.jacfwd(arrival, has_aux=True)(belief.mean)
    push = ROUGHNESS**2 * span.length / TICK + reached.rough**2
    state = reached.state
    if model.curved:
        mean, variance = bent(lambda row: arrival(row)[0][1], belief)
        state, push = state.at[1].add(mean), push + variance
    moved = carried(times(slope, belief.root), push)
    mean = jnp.concatenate([belief.mean[:-2], state])
    return Gaussian(mean, jnp.concatenate([belief.root[:-2], moved]))


def bent(rate: Callable[[Row], Any], belief: Gaussian) -> tuple[Any, Any]:
    """What the second derivatives of a rate make of its mean, and its variance beyond a line's.

    With M = S' H S they are tr(M) / 2 and tr(M M) / 2 (second-order filter: Athans, Wishner &
    Bertolini, IEEE TAC 13(5), 1968).
    """
    bends = jax.jacfwd(jax.jacfwd(rate))(belief.mean)
    table = times(times(belief.root.T, bends), belief.root)
    return jnp.trace(table) / 2, jnp.sum(table**2) / 2


def carried(rows: Float[Array, "2 unknown"], push: Any) -> Float[Array, "2 unknown"]:
    """The last two rows of a triangle again, the variance `push` added to the last one."""
    (a, b), (c, d) = rows[:, -2:]
    first = jnp.sqrt(a**2 + b**2)
    cross = (a * c + b * d) / first
    last = jnp.sqrt((a * d - b * c) ** 2 / first**2 + push)
    corner = jnp.stack([jnp.stack([first, jnp.zeros(())]), jnp.stack([cross, last])])
    return jnp.concatenate([rows[:, :-2], corner], axis=1)


def corrected(
    belief: Gaussian,
    seen: Float[Array, "2 unknown"],
    off: Pair,
    sensors: Pair,
    used: Bool[Array, "2"],
) -> tuple[Gaussian, Pair, Pair]:
    """The belief after both measurements, what surprised of each, and its variance.

    `seen` are the roots of what is shown, which every measurement narrows as it does the others.
    """
    table = jnp.concatenate([belief.root, seen])
    mean = jnp.concatenate([belief.mean, -off])
    surprise, variance = [], []
    for row in (-2, -1):
        factor = jnp.where(used[row], table[row], 0.0)
        noise = jnp.where(used[row], sensors[row], UNSEEN)
        left = jnp.where(used[row], -mean[row], 0.0)
        table, gain, total = correct(table, factor, noise)
        mean = mean + gain * left
        surprise.append(left)
        variance.append(total)
    return Gaussian(mean[:-2], table[:-2]), jnp.stack(surprise), jnp.stack(variance)


def correct(table: Float[Array, "row unknown"], factor: Float[Array, " unknown"], noise: Any):
    """The table S after a measurement with S'h = f and variance r: the new one, the gain, and the
    variance of what surprises.

    S (1 - f f' / a_0) S' has the triangle S L, where with a_i = r + f_i^2 + ... + f_n^2

        L_ii = sqrt(a_{i+1} / a_i),    L_ji = -f_j f_i / sqrt(a_i a_{i+1})  for j > i

    (Carlson, AIAA Journal 11(9), 1973, in closed form).
    """
    size = factor.size
    behind = jnp.asarray(np.tri(size, k=-1))  # 1 where the row is behind the column
    after = noise + jnp.sum(behind * (factor**2)[:, None], axis=0)
    here = after + factor**2
    weighed = table * factor
    rest = jnp.sum(weighed[:, :, None] * behind[None], axis=1)
    narrowed = table * jnp.sqrt(after / here) - rest * (factor / jnp.sqrt(after * here))
    return narrowed, jnp.sum(weighed, axis=1) / here[0], here[0]


def chi_square(off, known, seen, sensors):
    """Of both measurements together."""
    x, y = off
    a, b = jnp.where(known, jnp.sum(seen**2, axis=1) + sensors, UNSEEN)
    cross = jnp.where(known.all(), jnp.sum(seen[0] * seen[1]), 0.0)
    return (b * x**2 - 2 * cross * x * y + a * y**2) / (a * b - cross**2)
