"""Answers that belong to what was asked about: kept as long as it lives, and gone with it."""

from collections.abc import Callable
from functools import wraps
from typing import Any, ParamSpec, TypeVar

Answer = TypeVar("Answer")
Rest = ParamSpec("Rest")


def remembered(ask: Callable[..., Answer]) -> Callable[..., Answer]:
    """`ask`, which works an answer out once for each of its first arguments, a value type without
    equality or slots, and further ones that can be hashed.

    A cache of a fixed size forgets the first drop of a long recording before it is asked for again,
    and keeps the last long after nobody needs it.
    """
    name = f"{ask.__module__}.{ask.__qualname__}"

    @wraps(ask)
    def answer(about: Any, *more: Any) -> Answer:
        # Kept in it: a table beside would keep two things for ever that are told of each other.
        found = vars(about).setdefault(name, {})
        if more not in found:
            found[more] = ask(about, *more)
        return found[more]

    return answer
