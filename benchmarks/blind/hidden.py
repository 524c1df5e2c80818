"""How much of a hidden torque a formula explains, where it acted."""

from collections.abc import Mapping
from typing import Any

import jax
import jax.numpy as jnp
import numpy as np

from exoid.mismatch.answer.diagnosis import Diagnosis
from exoid.mismatch.screen.effect import named
from exoid.mismatch.screen.prepared_recording import PreparedRecording
from exoid.physics.moment import Cycle, Moment, SegmentConstants
from exoid.physics.ratios import Ratios
from exoid.physics.term import Term

from .effects import TERMS

ACTS = 0.02  # of its largest, from which on a torque acts


def explained(found: Diagnosis, truth: Mapping[str, Any]) -> float:
    """1 - var(hidden - formula) / var(hidden), both per inertia and without what the leg's own
    parameters and the voluntary torque of each segment can take up.
    """
    hidden = TERMS[truth["effects"][0]](
        **{name: jnp.asarray(value) for name, value in truth["params"][truth["effects"][0]].items()}
    )
    workings = found.workings
    assert workings is not None  # it was not read from a file
    best = workings.best.candidate
    (formula,) = (named(*each) for each in zip(best.terms, best.values, strict=True))
    rows = [
        columns(found, workings.found.prepared, number)
        for number in range(workings.found.prepared.segments)
    ]
    true, told = (
        np.concatenate([torque(term, each) for each in found.location.missing]) / scale
        for term, scale in ((hidden, truth["baseline"]["J"]), (formula, found.inertia))
    )
    leg = np.concatenate([each[:, :3] for each in rows])
    voluntary = np.zeros((len(leg), len(rows)))
    ends = np.cumsum([0, *map(len, rows)])
    for number, each in enumerate(rows):
        voluntary[ends[number] : ends[number + 1], number] = each[:, 3]
    acts = np.abs(true) > ACTS * np.abs(true).max()
    basis = np.concatenate([leg, voluntary], axis=1)
    both = np.stack([true, true - told], axis=1)
    left = (both - basis @ np.linalg.lstsq(basis, both)[0])[acts]
    return float(1 - np.sum(left[:, 1] ** 2) / np.sum(left[:, 0] ** 2))


def columns(found: Diagnosis, prepared: PreparedRecording, number: int) -> np.ndarray:
    """Gravity, spring, damper, voluntary torque of a segment."""
    each = found.location.missing[number]
    shape = np.asarray(prepared.seen.cycle.begin[number])
    shape = np.append(shape, shape[-1])[: each.angle.size]
    return np.stack([np.cos(each.angle), each.angle, each.angular_velocity, shape], axis=1)


def torque(term: Term, each) -> np.ndarray:
    """The term's torque along a measured motion [N m]."""
    zero, one = jnp.zeros(()), jnp.ones(())
    place = SegmentConstants(Ratios(one, one, one, zero), one, Cycle(zero, one, zero, zero), zero)

    def at(time, angle, velocity):
        return term.torque(Moment(time, angle, velocity, zero, place), jnp.zeros(0))

    motion = (jnp.asarray(x) for x in (each.time, each.angle, each.angular_velocity))
    return np.asarray(jax.vmap(at)(*motion))
