"""The formulas of a term, by the names that formats write."""

import inspect
from collections.abc import Iterable, Sequence
from dataclasses import fields, replace
from typing import Any

import jax
import jax.numpy as jnp
import numpy as np

from exoid.interchange.formula.expression import ZERO, Expression, known, make, symbol, total
from exoid.interchange.formula.trace import Formulas, Untold, trace
from exoid.interchange.model.called import called
from exoid.interchange.model.joint import Number, Part
from exoid.physics.moment import Cycle, Moment, SegmentConstants
from exoid.physics.ratios import Ratios
from exoid.physics.term import Term
from exoid.physics.torque import CycleTorque, Torque

NOW = (
    *("time", "angle", "rate", "acceleration"),
    *("gravity_over_inertia", "stiffness_over_inertia", "damping_over_inertia", "thigh_angle"),
    *("inertia", "drive_amplitude", "drive_period", "drive_frequency", "drive_onset"),
    *("number", "tether", "slack", "step"),
)  # the leaves of a `Moment`, in their order
FREE = {"tether": 0.0, "slack": 0.0, "step": 0.0}  # tied to nothing, contacts where they are


def some_moment() -> Moment:
    """An instant to trace at: only its shapes count."""
    time, angle, rate, acceleration, *place = map(jnp.ones_like, [jnp.zeros(())] * len(NOW))
    ratios, inertia, cycle = Ratios(*place[:4]), place[4], Cycle(*place[5:9])
    constants = SegmentConstants(ratios, inertia, cycle, *place[9:])
    return Moment(time, angle, rate, acceleration, constants)


def part_of(term: Term, numbers: tuple[Number, ...], begun: np.ndarray) -> Part:
    """A term with its formulas.

    **Raises** `ValueError` where it computes with what no format has a form for.
    """
    name, now, memory = called(type(term)), some_moment(), jnp.asarray(begun)
    own = tuple(each.name for each in numbers)
    inside = f"{name}_memory"

    def told(function: Any) -> list[Formulas]:
        given = jax.tree.map(jnp.asarray, term), now, memory
        return [free(each) for each in trace(function, given, (*own, *NOW, inside))]

    part = Part(name, term.title, inspect.getdoc(type(term)) or "", term, numbers, begun)
    try:
        (torque,) = told(lambda own, now, memory: own.torque(now, memory))
        (friction,) = told(lambda own, now, memory: own.dry_friction(now))
        (rates,) = told(lambda own, now, memory: own.memory_rate(now, memory))
        (within,) = told(lambda own, now, memory: own.memory_within(now, memory))
        shown = told(lambda own, now, memory: own.shown(now, memory))
    except Untold as fault:
        raise ValueError(
            f"{name} computes with {fault}, for which no other tool has a form here: write its "
            "torque with +, -, *, /, powers, exp, log, sin, cos, tanh, sqrt, abs, sign and where."
        ) from fault
    angle, rate, delay = (each.item() for each in shown)
    return replace(
        part,
        torque=torque.item(),
        friction=friction.item(),
        rates=tuple(rates.tolist()),
        within=tuple(within.tolist()),
        shown_angle=angle,
        shown_rate=rate,
        delay=delay,
    )


def free(each: Formulas) -> Formulas:
    """The same, tied to nothing."""
    made = np.empty(each.shape, object)
    made[...] = np.frompyfunc(lambda one: known(one, FREE), 1, 1)(each)
    return made


def eq9(push: Expression | None = None) -> Expression:
    """The acceleration of Eq. 9, with a torque `push` [N m] beside its own."""
    tilted = make("add", symbol("angle"), symbol("thigh_angle"))
    weight = make("mul", symbol("gravity"), make("cos", tilted))
    spring = make("mul", symbol("stiffness"), symbol("angle"))
    damper = make("mul", symbol("damping"), symbol("rate"))
    passive = make("add", make("add", weight, spring), damper)
    pulled = make("neg", passive) if push is None else make("sub", push, passive)
    return make("div", pulled, symbol("inertia"))


def acceleration(parts: Sequence[Part], push: Expression | None = None) -> Expression:
    """What Eq. 9 and the terms make of angle and rate, but for dry friction [rad/s^2].

    What changes the leg's inertia acts on all that moves it, the other terms' torques included.
    """
    pushed = eq9(push)
    for inertial in (False, True):
        torques = [
            known(each.torque, {"acceleration": pushed})
            for each in parts
            if each.term.inertial is inertial
        ]
        pushed = make("add", pushed, make("div", total(torques), symbol("inertia")))
    return pushed


def undriven(parts: Iterable[Part]) -> list[Part]:
    """The terms as they act on a leg that nobody pushes."""
    still = {"drive_amplitude": 0.0}
    return [replace(each, torque=known(each.torque, still)) for each in parts]


def friction(parts: Sequence[Part]) -> Expression:
    """The level of dry friction [N m]."""
    return total([each.friction for each in parts])


def torque_over_time(torque: Torque) -> Expression:
    """What drives the leg, by `time`, where that is a formula [N m]."""
    if not isinstance(torque, CycleTorque):
        return ZERO
    names = [f"drive_{each.name}" for each in fields(torque)]
    arguments = jax.tree.map(jnp.asarray, torque), jnp.zeros(())
    (found,) = trace(lambda torque, time: torque(time), arguments, (*names, "time"))
    return found.item()
