"""How each field of a frozen dataclass is kept in a file, read off its type."""

from dataclasses import dataclass, fields, is_dataclass
from functools import cache
from types import NoneType, UnionType
from typing import Annotated, Any, Literal, Union, get_args, get_origin, get_type_hints

from jaxtyping import AbstractArray

Role = Literal["number", "array", "word", "json", "group", "rows", "groups"]


@dataclass(frozen=True)
class Kind:
    """How a field is kept."""

    role: Role
    type: Any  # of the number or array, or the dataclass
    unit: str | None
    optional: bool

    @property
    def units(self) -> dict[str, str]:
        """As netCDF has it."""
        return {} if self.unit is None else {"units": self.unit}


@cache
def kinds(of: Any) -> dict[str, Kind]:
    """Every field of a dataclass, by its type: `Annotated[float, "rad"]` is a number in rad."""
    hints = get_type_hints(of, include_extras=True)
    return {each.name: kind(hints[each.name]) for each in fields(of)}


def kind(hint: Any) -> Kind:
    unit, optional = None, False
    while True:
        others = [each for each in get_args(hint) if each is not NoneType]
        if get_origin(hint) is Annotated:
            hint, unit = get_args(hint)[:2]
        elif get_origin(hint) in (Union, UnionType) and len(others) == 1:
            hint, optional = others[0], True
        else:
            return Kind(*role(hint), unit, optional)


def role(hint: Any) -> tuple[Role, Any]:
    origin, inside = get_origin(hint), get_args(hint)
    if is_dataclass(hint):
        return "group", hint
    if origin in (list, tuple) and is_dataclass(inside[0]):
        return "rows" if plain(inside[0]) else "groups", (origin, inside[0])
    if isinstance(hint, type) and issubclass(hint, AbstractArray):
        return "array", hint
    if hint in (float, int, bool):
        return "number", hint
    if hint is str or origin is Literal:
        return "word", str
    return "json", origin


def plain(of: Any) -> bool:
    """Does one row of a table hold it?"""
    return all(
        plain(each.type) and not each.optional
        if each.role == "group"
        else each.role in ("number", "word", "json")
        for each in kinds(of).values()
    )
