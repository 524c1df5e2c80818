"""Write a formula in the words of a language."""

from collections import Counter
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field

import numpy as np

from exoid.interchange.formula.expression import Expression, interned, walk

INFIX = {
    "add": "+",
    "sub": "-",
    "mul": "*",
    "div": "/",
    "lt": "<",
    "le": "<=",
    "gt": ">",
    "ge": ">=",
    "eq": "==",
    "ne": "!=",
}
BINDS = {"mul": 3, "div": 3, "add": 2, "sub": 2}  # how strongly; what compares binds by 1
ATOM = 9
FORMULA = {"neg": "-{0}", "select": "({1} if {0} else {2})", "not": "not ({0})"}


def same(name: str) -> str:
    return name


def shortest(value: float) -> str:
    """The fewest digits that give it back."""
    return repr(float(value))


@dataclass(frozen=True)
class Language:
    """How it writes numbers, names, functions and what is longer than an operator."""

    number: Callable[[float], str] = shortest
    name: Callable[[str], str] = same
    function: Callable[[str], str] = same
    forms: Mapping[str, str] = field(default_factory=lambda: FORMULA)


def spell(root: Expression, language: Language, told: Mapping[int, str] | None = None) -> str:
    """The formula on one line; `told` has names of nodes that were computed before."""
    found: dict[int, tuple[str, int]] = {}
    for each in walk(root):
        known = (told or {}).get(id(each)) if each is not root else None
        parts = [found[id(part)] for part in each.parts]
        found[id(each)] = (known, ATOM) if known else written(each, parts, language)
    return found[id(root)][0]


def written(each: Expression, parts: list[tuple[str, int]], language: Language) -> tuple[str, int]:
    """One node, and how strongly it holds together."""
    if each.symbol:
        return language.name(each.symbol), ATOM
    if each.value is not None:
        return language.number(each.value), ATOM if each.value >= 0 else 2
    if each.operation in language.forms:
        form = language.forms[each.operation]
        inside = [text if binds == ATOM else f"({text})" for text, binds in parts]
        return form.format(*inside), 2 if each.operation == "neg" else ATOM
    if each.operation in INFIX:
        binds = BINDS.get(each.operation, 1)
        (left, left_binds), (right, right_binds) = parts
        left = left if (left_binds >= binds and binds > 1) or left_binds == ATOM else f"({left})"
        right = right if right_binds > binds else f"({right})"
        return f"{left} {INFIX[each.operation]} {right}", binds
    return f"{language.function(each.operation)}({', '.join(text for text, _ in parts)})", ATOM


def lines(
    roots: Mapping[str, Expression], language: Language, assign: str = "{0} = {1}"
) -> list[str]:
    """A line for every formula by its name, and before them for what is used more than once."""
    used: Counter[int] = Counter()
    roots = interned(roots)
    nodes: dict[int, Expression] = {}
    for root in roots.values():
        for each in walk(root):
            nodes.setdefault(id(each), each)
    for each in nodes.values():
        used.update(id(part) for part in each.parts)
    told: dict[int, str] = {}
    said: list[str] = []
    for key, each in nodes.items():
        if used[key] > 1 and each.operation and not is_truth(each):
            name = f"part_{len(told) + 1}"
            said.append(assign.format(name, spell(each, language, told)))
            told[key] = name
    for name, root in roots.items():
        said.append(assign.format(name, told.get(id(root)) or spell(root, language, told)))
    return said


def is_truth(each: Expression) -> bool:
    """Is it true or false, and no number?"""
    return each.operation in ("lt", "le", "gt", "ge", "eq", "ne", "and", "or", "not")


def single(value: float) -> str:
    """The fewest digits that give back what single precision holds, as C writes it."""
    text = str(np.float32(value))
    return f"{text}f" if any(sign in text for sign in ".en") else f"{text}.0f"
