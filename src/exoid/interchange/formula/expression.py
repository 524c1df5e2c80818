"""A formula as a tree: what every format writes in its own words."""

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

OPERATIONS: dict[str, Callable[..., Any]] = {
    "add": np.add,
    "sub": np.subtract,
    "mul": np.multiply,
    "div": np.divide,
    "neg": np.negative,
    "abs": np.abs,
    "sign": np.sign,
    "max": np.maximum,
    "min": np.minimum,
    "exp": np.exp,
    "log": np.log,
    "sin": np.sin,
    "cos": np.cos,
    "tanh": np.tanh,
    "sqrt": np.sqrt,
    "round": np.round,  # half to even
    "floor": np.floor,
    "two_to": np.exp2,  # of a whole number
    "lt": np.less,
    "le": np.less_equal,
    "gt": np.greater,
    "ge": np.greater_equal,
    "eq": np.equal,
    "ne": np.not_equal,
    "and": np.logical_and,
    "or": np.logical_or,
    "not": np.logical_not,
    "select": np.where,  # condition, what it is where that holds, what else
}


@dataclass(frozen=True, eq=False)
class Expression:
    """An operation on its parts; a leaf is a number (`value`) or a `symbol`."""

    operation: str = ""
    parts: tuple["Expression", ...] = ()
    value: float | None = None
    symbol: str = ""

    @property
    def symbols(self) -> frozenset[str]:
        """What it hangs on."""
        return frozenset(each.symbol for each in walk(self) if each.symbol)


ZERO = Expression(value=0.0)


def number(value: float) -> Expression:
    return Expression(value=float(value))


def symbol(name: str) -> Expression:
    return Expression(symbol=name)


def walk(root: Expression) -> Iterator[Expression]:
    """Every node once, its parts before it."""
    met: set[int] = set()

    def visit(node: Expression) -> Iterator[Expression]:
        if id(node) in met:
            return
        met.add(id(node))
        for each in node.parts:
            yield from visit(each)
        yield node

    return visit(root)


def make(operation: str, *parts: Expression) -> Expression:
    """The operation on these parts, without what adds or multiplies nothing."""
    if all(each.value is not None for each in parts):
        return number(OPERATIONS[operation](*(each.value for each in parts)))
    first, last = parts[0], parts[-1]
    if operation == "mul" and 0.0 in (first.value, last.value):
        return ZERO
    if (operation, first.value) == ("div", 0.0):
        return ZERO
    if (operation, first.value) in (("add", 0.0), ("mul", 1.0)):
        return last
    if (operation, last.value) in (("add", 0.0), ("sub", 0.0), ("mul", 1.0), ("div", 1.0)):
        return first
    if (operation, first.value) == ("sub", 0.0):
        return make("neg", last)
    if operation == "select" and first.value is not None:
        return parts[1] if first.value else parts[2]
    if operation == "mul" and "inertia" in (first.symbol, last.symbol):
        ratio = last if first.symbol == "inertia" else first
        if ratio.symbol.endswith("_over_inertia"):
            return symbol(ratio.symbol.removesuffix("_over_inertia"))
    return Expression(operation, parts)


def total(parts: list[Expression]) -> Expression:
    """Their sum."""
    found = ZERO
    for each in parts:
        found = make("add", found, each)
    return found


def evaluate(root: Expression, values: Mapping[str, Any], dtype: Any = np.float64) -> Any:
    """The value where the symbols have theirs, every operation rounded to `dtype`."""
    found: dict[int, Any] = {}
    for each in walk(root):
        if each.symbol:
            found[id(each)] = np.asarray(values[each.symbol], dtype)
        elif each.value is not None:
            found[id(each)] = np.asarray(each.value, dtype)
        else:
            done = OPERATIONS[each.operation](*(found[id(part)] for part in each.parts))
            kept = done if np.asarray(done).dtype == bool else np.asarray(done, dtype)
            found[id(each)] = kept
    return found[id(root)]


def known(root: Expression, values: Mapping[str, "float | Expression"]) -> Expression:
    """The same with numbers, or formulas, in place of the symbols that have one."""
    found: dict[int, Expression] = {}
    for each in walk(root):
        if each.symbol:
            value = values.get(each.symbol, each)
            found[id(each)] = value if isinstance(value, Expression) else number(value)
        elif each.value is not None:
            found[id(each)] = each
        else:
            found[id(each)] = make(each.operation, *(found[id(part)] for part in each.parts))
    return found[id(root)]


def interned(roots: Mapping[str, Expression]) -> dict[str, Expression]:
    """The same formulas, in which what is alike is one node."""
    met: dict[tuple[Any, ...], Expression] = {}
    found: dict[int, Expression] = {}
    for root in roots.values():
        for each in walk(root):
            parts = tuple(found[id(part)] for part in each.parts)
            key = (each.operation, each.value, each.symbol, *map(id, parts))
            same = Expression(each.operation, parts, each.value, each.symbol)
            found[id(each)] = met.setdefault(key, same)
    return {name: found[id(root)] for name, root in roots.items()}
