"""What an annotation says of a value: its type without None, its unit, and what a union allows."""

import collections.abc
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, fields, is_dataclass
from functools import cache
from types import NoneType, UnionType
from typing import Annotated, Any, Literal, Union, get_args, get_origin, get_type_hints

import jax
import numpy as np
from jaxtyping import AbstractArray

from exoid.report.saved.node import DocumentError

LISTS = (list, tuple, collections.abc.Sequence, collections.abc.Iterable)
MAPPINGS = (dict, collections.abc.Mapping)
BARE = {list: (Any,), tuple: (Any, ...), dict: (Any, Any)}  # where nothing is said


@dataclass(frozen=True)
class Annotation:
    """One type and its unit, or what a union allows."""

    type: Any
    unit: str | None = None
    choices: tuple[Any, ...] = ()

    @property
    def origin(self) -> Any:
        return get_origin(self.type) or self.type

    @property
    def inside(self) -> tuple[Any, ...]:
        """The types within a list, a tuple or a mapping."""
        return get_args(self.type) if get_origin(self.type) else BARE.get(self.type, ())

    def of_each(self, count: int) -> tuple[Any, ...]:
        """The type of each of so many in a list or a tuple."""
        fixed = self.origin is tuple and self.inside[-1:] != (...,)
        return self.inside if fixed else self.inside[:1] * count

    @property
    def name(self) -> str:
        """Of the type, as a file has it."""
        return "array" if is_array(self.type) else base(self.type).__name__


@cache
def read(hint: Any) -> Annotation:
    """What a hint says; `Annotated[float, "rad"]` is a number in rad."""
    unit = None
    while True:
        if get_origin(hint) is Annotated:
            hint, unit = get_args(hint)[:2]
        elif get_origin(hint) in (Union, UnionType):
            others = [each for each in get_args(hint) if each is not NoneType]
            if len(others) > 1:
                return Annotation(hint, unit, tuple(others))
            hint = others[0]
        else:
            return Annotation(hint, unit)


@cache
def kept(of: type) -> dict[str, Any]:
    """The fields of a dataclass that a file keeps, with their hints.

    One with `metadata={"saved": False}` is not kept; it takes its default when it comes back.
    """
    hints = get_type_hints(of, include_extras=True)
    return {
        each.name: hints[each.name]
        for each in fields(of)
        if each.init and each.metadata.get("saved", True)
    }


def is_array(hint: Any) -> bool:
    """NumPy's, JAX's, or jaxtyping's of either."""
    return isinstance(hint, type) and issubclass(hint, (AbstractArray, np.ndarray, jax.Array))


def axes(hint: Any) -> tuple[str, ...]:
    """The names of an array's axes, as far as its type has them."""
    return tuple(getattr(hint, "dim_str", "").split())


def base(hint: Any) -> Any:
    """The class that a value of this type has: str of Literal["a", "b"]."""
    hint = read(hint).type
    return type(get_args(hint)[0]) if get_origin(hint) is Literal else get_origin(hint) or hint


def choose(value: Any, choices: Sequence[Any], place: str) -> Any:
    """The one type among those of a union that a value has."""
    fitting = [each for each in choices if fits(value, read(each).type)]
    named = [each for each in fitting if type(value) is base(each)] or fitting
    if len(named) != 1:
        found = type(value).__name__
        raise DocumentError(f"{place}: {found} is none of {choices}, or several. Annotate it.")
    return named[0]


def fits(value: Any, hint: Any) -> bool:
    if is_array(hint):
        return isinstance(value, np.ndarray | np.generic | jax.Array)
    return hint is Any or isinstance(value, base(hint))


def class_called(name: str, bases: Sequence[Any], own: Sequence[type]) -> type | None:
    """The class of this name among `bases`, exoid's classes below them, and a user's `own`."""
    theirs = [each for each in own if issubclass(each, tuple(bases))]
    for each in (*theirs, *(found for one in bases for found in family(one))):
        if each.__qualname__ == name:
            return each
    return None


def family(of: type) -> Iterator[type]:
    """A class of exoid and those below it; of a term, all that a diagnosis may have."""
    from exoid.physics.term import Term

    if issubclass(of, Term):
        import exoid.mismatch.novel.nameless  # noqa: F401
        from exoid.physics.library import library

        library()
    yield of
    for each in of.__subclasses__():
        if each.__module__.partition(".")[0] == "exoid":
            yield from family(each)


def is_record(hint: Any) -> bool:
    return isinstance(hint, type) and is_dataclass(hint)
