"""Read the formulas of a term off its own functions, as JAX traces them.

A term says once, in `exoid.physics`, what it does; every format takes its formulas from there. So
one of a user's own is exported like one of the library.
"""

from collections.abc import Callable, Sequence
from typing import Any

import jax
import numpy as np
from numpy.typing import NDArray

from exoid.interchange.formula.expression import OPERATIONS, Expression, make, number, symbol

Formulas = NDArray[np.object_]  # an array of expressions
SAME = ("convert_element_type", "copy", "stop_gradient")


class Untold(ValueError):
    """A function of JAX that no format has a form for."""


def trace(function: Callable[..., Any], arguments: Any, names: Sequence[str]) -> list[Formulas]:
    """The leaves of what `function` makes of its arguments, as arrays of expressions.

    `names` has one for every leaf of the arguments; the entries of an array are told apart by
    their numbers.
    """
    closed = jax.make_jaxpr(function)(*arguments)
    leaves = jax.tree.leaves(arguments)
    given = [named(np.shape(leaf), name) for leaf, name in zip(leaves, names, strict=True)]
    return run(closed.jaxpr, [constant(each) for each in closed.consts], given)


def named(shape: tuple[int, ...], name: str) -> Formulas:
    """An array of symbols."""
    made = np.empty(shape, object)
    for at in np.ndindex(shape):
        made[at] = symbol("_".join([name, *map(str, at)]))
    return made


def constant(value: Any) -> Formulas:
    """An array of numbers."""
    array = np.asarray(value)
    made = np.empty(array.shape, object)
    for at in np.ndindex(array.shape):
        made[at] = number(float(array[at]))
    return made


def run(jaxpr: Any, constants: list[Formulas], given: list[Formulas]) -> list[Formulas]:
    """What a traced function gives of these arrays."""
    known = dict(zip([*jaxpr.constvars, *jaxpr.invars], [*constants, *given], strict=True))

    def value(variable: Any) -> Formulas:
        return constant(variable.val) if hasattr(variable, "val") else known[variable]

    for each in jaxpr.eqns:
        known.update(zip(each.outvars, applied(each, [*map(value, each.invars)]), strict=True))
    return [value(each) for each in jaxpr.outvars]


def applied(equation: Any, given: list[Formulas]) -> list[Formulas]:
    """What one operation gives."""
    inner = equation.params.get("jaxpr", equation.params.get("call_jaxpr"))
    if inner is not None:
        return run(inner.jaxpr, [constant(each) for each in inner.consts], given)
    return [one(equation.primitive.name, equation.params, given)]


def one(name: str, said: dict[str, Any], given: list[Formulas]) -> Formulas:
    """What moves numbers about, or computes with each of them."""
    first = given[0]
    if name in SAME:
        return first
    if name == "broadcast_in_dim":
        shape = [1] * len(said["shape"])
        for at, size in zip(said["broadcast_dimensions"], first.shape, strict=True):
            shape[at] = size
        return np.broadcast_to(first.reshape(shape), said["shape"])
    if name in ("squeeze", "reshape"):
        wanted = said.get("new_sizes", np.squeeze(first, said.get("dimensions")).shape)
        return first.reshape(wanted)
    if name == "slice":
        ends = zip(said["start_indices"], said["limit_indices"], strict=True)
        return first[tuple(slice(*each) for each in ends)]
    if name == "concatenate":
        return np.concatenate(given, said["dimension"])
    if name == "stack":
        return np.stack(given, said["axis"])
    return each_of(name, said, given)


def each_of(name: str, said: dict[str, Any], given: list[Formulas]) -> Formulas:
    """An operation on every number."""

    def compute(*parts: Expression) -> Expression:
        if name == "integer_pow":
            return power(parts[0], said["y"])
        if name == "square":
            return power(parts[0], 2)
        if name == "clamp":
            return make("min", make("max", parts[1], parts[0]), parts[2])
        if name == "select_n":
            return make("select", parts[0], parts[2], parts[1])
        if name not in OPERATIONS:
            raise Untold(f"jax.lax.{name}")
        return make(name, *parts)

    made = np.empty(np.broadcast_shapes(*(each.shape for each in given)), object)
    made[...] = np.frompyfunc(compute, len(given), 1)(*given)
    return made


def power(base: Expression, exponent: int) -> Expression:
    """As products."""
    if exponent < 0:
        return make("div", number(1.0), power(base, -exponent))
    found = number(1.0)
    for _ in range(exponent):
        found = make("mul", found, base)
    return found
