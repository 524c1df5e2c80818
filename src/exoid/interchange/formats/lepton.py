"""The words of OpenSim's expressions, which know angle and rate alone, and no condition."""

import numpy as np

from exoid.interchange.formula.expression import Expression, evaluate, walk
from exoid.interchange.formula.single import used
from exoid.interchange.formula.spell import Language, shortest, spell

NAMES = {"angle": "q", "rate": "qdot"}
FORMS = {
    "neg": "-{0}",
    "sign": "(step({0})-step(-{0}))",
    "lt": "(1-step({0}-{1}))",
    "le": "step({1}-{0})",
    "gt": "(1-step({1}-{0}))",
    "ge": "step({0}-{1})",
    "eq": "(step({0}-{1})*step({1}-{0}))",
    "ne": "(1-step({0}-{1})*step({1}-{0}))",
    "and": "({0}*{1})",
    "or": "max({0},{1})",
    "not": "(1-{0})",
    "select": "({2}+{0}*({1}-{2}))",
}  # step(0) is 1
WORDS = Language(shortest, lambda name: NAMES[name], forms=FORMS)
LACKED = {"floor", "round"}
FURTHEST, FASTEST, SAMPLES = 3.2, 15.0, 401  # rad and rad/s, of a leg


def expression(root: Expression) -> str:
    """On one line; the parser wants it without spaces, and XML without < and >."""
    return spell(root, WORDS).replace(" ", "")


def unable(root: Expression) -> str | None:
    """Why there is no such expression."""
    if lacked := used({"": root}) & LACKED:
        return f"it computes {' and '.join(sorted(lacked))}"
    angle = np.linspace(-FURTHEST, FURTHEST, SAMPLES)
    rate = np.random.default_rng(0).permutation(np.linspace(-FASTEST, FASTEST, SAMPLES))
    with np.errstate(all="ignore"):
        found = evaluate(both_sides(root), {"angle": angle, "rate": rate})
    if not np.isfinite(found).all():
        return "both sides of a choice are computed there, and one of them is no number"
    return None


def both_sides(root: Expression) -> Expression:
    """The same with every choice as the sum that it is written as."""
    found: dict[int, Expression] = {}
    for each in walk(root):
        parts = tuple(found[id(part)] for part in each.parts)
        if each.operation == "select":
            held, one, other = parts
            more = Expression("mul", (held, Expression("sub", (one, other))))
            found[id(each)] = Expression("add", (other, more))
        else:
            found[id(each)] = Expression(each.operation, parts, each.value, each.symbol)
    return found[id(root)]
