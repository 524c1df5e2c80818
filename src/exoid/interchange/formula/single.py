"""Formulas in single precision, of nothing but + - * / and comparisons: what a microcontroller
computes to the last bit as NumPy does.
"""

from collections.abc import Mapping
from functools import cache
from math import factorial, log, log2

import jax.numpy as jnp
import numpy as np

from exoid.interchange.formula.expression import (
    Expression,
    evaluate,
    known,
    make,
    number,
    symbol,
    walk,
)
from exoid.interchange.formula.trace import trace
from exoid.physics.waves import cos

X = symbol("x")
EXP_TERMS = 8  # of the series on half of log 2 to each side: the next is below 1e-8
LOG_HIGH = 0.693359375  # of log 2, in few bits: exact when multiplied by a small whole number
LOG_LOW = log(2) - LOG_HIGH
LOWEST, HIGHEST = -87.0, 88.0  # where single precision holds the exponential
FLAT = 10.0  # beyond which tanh is 1


@cache
def functions() -> dict[str, Expression]:
    """Cosine, sine, exponential and tanh of `x`; the cosine is that of `exoid.physics.waves`."""
    (cosine,) = trace(lambda x: cos(x), (jnp.zeros(()),), ("x",))
    quarter = make("sub", X, number(np.pi / 2))
    clipped = make("min", make("max", X, number(-FLAT)), number(FLAT))
    double = known(exponential(), {"x": make("mul", number(2.0), clipped)})
    tanh = make("div", make("sub", double, number(1.0)), make("add", double, number(1.0)))
    return {
        "cos": cosine.item(),
        "sin": known(cosine.item(), {"x": quarter}),
        "exp": exponential(),
        "tanh": tanh,
    }


def exponential() -> Expression:
    """2^k times the series of what is left of x."""
    inside = make("min", make("max", X, number(LOWEST)), number(HIGHEST))
    whole = make("round", make("mul", inside, number(log2(np.e))))
    rest = make("sub", inside, make("mul", whole, number(LOG_HIGH)))
    rest = make("sub", rest, make("mul", whole, number(LOG_LOW)))
    series = number(1 / factorial(EXP_TERMS - 1))
    for power in range(EXP_TERMS - 2, -1, -1):
        series = make("add", make("mul", series, rest), number(1 / factorial(power)))
    return make("mul", make("two_to", whole), series)


def used(formulas: Mapping[str, Expression]) -> set[str]:
    """The names of what these formulas compute with."""
    return {each.operation for root in formulas.values() for each in walk(root)}


def made_of(formulas: Mapping[str, Expression]) -> set[str]:
    """The same, and what those functions are made of."""
    direct = used(formulas)
    return direct | used({name: functions()[name] for name in direct & set(functions())})


def single(root: Expression, values: Mapping[str, object]) -> np.float32:
    """The value in single precision, operation by operation as the exported C has it."""
    plain = inlined(root)
    return np.float32(evaluate(plain, values, np.float32))


def inlined(root: Expression) -> Expression:
    """The same without functions but those of C's language."""
    found: dict[int, Expression] = {}
    for each in walk(root):
        parts = tuple(found[id(part)] for part in each.parts)
        if each.operation in functions():
            found[id(each)] = known(functions()[each.operation], {"x": parts[0]})
        else:
            found[id(each)] = Expression(each.operation, parts, each.value, each.symbol)
    return found[id(root)]
