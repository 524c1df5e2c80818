"""How samples arrive: which of them are taken in, and whether the stream can be trusted."""

from dataclasses import replace
from typing import Any

import equinox as eqx
import jax.numpy as jnp
from jaxtyping import Array, Bool, Float

from exoid.online.movement.knowledge import Recent, Stream

GAP = 0.25  # s without a sample, over which nobody knows what a hand did
LOST = 3.0  # periods between samples from which on some were lost
FORGOTTEN = 1.0  # s, after which a fault counts a third
MOST = 4.0  # faults that count, from which on a stream is faulty
FROZEN = 50  # samples of the same rate: noise alone moves it by two steps


class Arrived(eqx.Module):
    """A sample looked at."""

    taken: Bool[Array, ""]  # is it new, of a time that can be?
    torn: Bool[Array, ""]  # does it stand by itself: after a gap, or on another clock?
    step: Float[Array, ""]  # s since the last one; 0 of the first
    stream: Stream


def look(recent: Recent, stream: Stream, row: Float[Array, " 6"], period: Any) -> Arrived:
    """Is a sample fit to be taken in?"""
    before = last(recent)
    first = recent.heard == 0
    since = jnp.where(first, 0.0, row[0] - before[0])
    timed = jnp.isfinite(row[0])
    back = timed & (since < -GAP)
    taken = timed & (first | (since > 0) | back)
    torn = taken & ~first & (back | (since > GAP))
    empty = jnp.isnan(row[1]) & jnp.isnan(row[2])
    lost = taken & ((since > LOST * period) | back)
    bad = ~taken | empty | lost
    fading = jnp.exp(-jnp.clip(jnp.where(taken, since, 0.0), 0.0, 10.0) / FORGOTTEN)
    frozen = jnp.where(taken & (row[2] == before[2]), stream.frozen + 1, 0)
    frozen = jnp.where(taken, frozen, stream.frozen)
    faults = fading * stream.faults + jnp.where(bad, 1.0, 0.0) + jnp.where(torn, MOST, 0.0)
    return Arrived(taken, torn, jnp.where(taken, since, 0.0), Stream(faults, frozen))


def is_faulty(stream: Stream) -> Bool[Array, ""]:
    """Are there too many faults to believe what is seen?"""
    return (stream.faults > MOST) | (stream.frozen >= FROZEN)


def heard(recent: Recent, row: Float[Array, " 6"], arrived: Arrived) -> Recent:
    """With the sample among the others; those before a gap are forgotten."""
    at = recent.heard % recent.rows.shape[0]
    old = jnp.where(arrived.torn, jnp.nan, recent.rows)
    rows = jnp.where(arrived.taken, old.at[at].set(row), recent.rows)
    return replace(recent, rows=rows, heard=recent.heard + arrived.taken)


def last(recent: Recent) -> Float[Array, " 6"]:
    """The last sample."""
    return recent.rows[(recent.heard - 1) % recent.rows.shape[0]]


def window(recent: Recent, span: Any) -> Bool[Array, " row"]:
    """Which rows are of the last `span` [s]."""
    now = recent.rows[(recent.heard - 1) % recent.rows.shape[0], 0]
    return (recent.rows[:, 0] > now - span) & ~jnp.isnan(recent.rows[:, 1])
