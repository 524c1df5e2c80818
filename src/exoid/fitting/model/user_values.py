"""What a user fixes, bounds or expects by hand, by name: a leg's parameters, or a term's as
coulomb_friction.level, which are checked where the terms are known.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from math import inf, isfinite, isnan
from typing import Any, Literal, get_args

from exoid.physics.leg import LegParameters
from exoid.physics.parameter import Declaration, declarations

Means = Literal["fix", "bound", "prior"]
MEANS: tuple[Means, ...] = get_args(Means)  # the strongest first
Fixed = Mapping[str, float]
Bounds = Mapping[str, tuple[float | None, float | None]]
Expectations = Mapping[str, tuple[float, float]]

DECLARED = dict(declarations(LegParameters))
SYMBOLS = {declared.symbol: name for name, declared in DECLARED.items()}
POSITIVE = ("mass", "inertia", "com_distance")  # the others may be zero
TABLE = "fit"  # of the sidecar


@dataclass(frozen=True)
class ByHand:
    """Values, limits and expectations in the parameters' printed units.

    **Raises** `ValueError` (one sentence) where a name is no parameter's, or no leg is like that.
    """

    fix: Fixed = field(default_factory=dict)
    bound: Bounds = field(default_factory=dict)
    prior: Expectations = field(default_factory=dict)  # (value, standard deviation)

    def __post_init__(self):
        for means in MEANS:
            given = {parameter(name, means): value for name, value in getattr(self, means).items()}
            object.__setattr__(self, means, given)
        for name, value in self.fix.items():
            check_value("fix", name, value)
            for means in MEANS[1:]:
                if name in getattr(self, means):
                    raise ValueError(f"{name} is fixed, so it takes no {means} of its own.")
        for name, ends in self.bound.items():
            check_bound(name, *ends)
        for name, (value, deviation) in self.prior.items():
            check_value("prior", name, value)
            if not (isfinite(deviation) and deviation > 0):
                raise ValueError(
                    f"prior of {name}: {deviation:g} is no standard deviation; it is positive. "
                    f"To hold {name} at a value, fix it."
                )

    def __bool__(self) -> bool:
        return bool(self.names)

    def over(self, other: "ByHand") -> "ByHand":
        """This, and of `other` what says something of further parameters."""
        rest = other.of(lambda name: self.means(name) is None)
        return ByHand(*({**getattr(rest, means), **getattr(self, means)} for means in MEANS))

    def means(self, name: str) -> Means | None:
        """By what a parameter was decided by hand, the strongest."""
        return next((means for means in MEANS if name in getattr(self, means)), None)

    @property
    def names(self) -> list[str]:
        """Of what parameters something is said."""
        return [*{**self.fix, **self.bound, **self.prior}]

    @property
    def leg(self) -> "ByHand":
        """What is said of the leg alone."""
        return self.of(lambda name: name in DECLARED)

    @property
    def terms(self) -> "ByHand":
        """What is said of terms alone."""
        return self.of(lambda name: name not in DECLARED)

    def of(self, wanted: Callable[[str], bool]) -> "ByHand":
        """What is said of the parameters that are wanted."""

        each = (getattr(self, means).items() for means in MEANS)
        return ByHand(*({name: said for name, said in one if wanted(name)} for one in each))

    def words(self, terms: Mapping[str, Declaration]) -> list[str]:
        """Each as an option would have it; `terms` declares what is none of the leg's."""
        units = {name: declared.unit for name, declared in {**DECLARED, **terms}.items()}
        said = [f"{name} = {value:g} {units[name]}, fixed" for name, value in self.fix.items()]
        said += [f"{name} within {span(*ends)} {units[name]}" for name, ends in self.bound.items()]
        return said + [
            f"{name} = {value:g} ± {deviation:g} {units[name]} expected"
            for name, (value, deviation) in self.prior.items()
        ]


def span(low: float | None, high: float | None) -> str:
    if low is None:
        return f"at most {high:g}"
    return f"at least {low:g}" if high is None else f"{low:g} to {high:g}"


def parameter(name: str, means: str) -> str:
    """The parameter of this name or symbol."""
    if name in DECLARED or "." in name:
        return name
    if name in SYMBOLS:
        return SYMBOLS[name]
    known = ", ".join(f"{each} ({declared.symbol})" for each, declared in DECLARED.items())
    raise ValueError(
        f"{means} of {name!r}: no parameter of the leg has this name; it is {known}; of a term it "
        "is TERM.PARAMETER, as coulomb_friction.level."
    )


def check_value(means: str, name: str, value: float) -> None:
    """Refuse what no leg has."""
    if name not in DECLARED:
        if not isfinite(value):
            raise ValueError(f"{means} of {name}: {value:g} cannot be; it is a number.")
        return
    low = "positive" if name in POSITIVE else "0 or more"
    if not isfinite(value) or value < 0 or (value == 0 and name in POSITIVE):
        unit = DECLARED[name].unit
        raise ValueError(f"{means} of {name}: {value:g} {unit} cannot be; it is {low}.")


def check_bound(name: str, low: float | None, high: float | None) -> None:
    least = 0.0 if name in DECLARED else -inf
    ends = (least if low is None else low, inf if high is None else high)
    if any(map(isnan, ends)) or ends[0] < least or not ends[0] < ends[1]:
        raise ValueError(
            f"bound of {name}: {ends[0]:g} to {ends[1]:g} leaves nothing; the lower end comes "
            "first, and no parameter of a leg is negative."
        )


def from_sidecar(document: Any) -> ByHand:
    """The table [fit] of a sidecar: fix = {NAME = VALUE}, bound = {NAME = [LOW, HIGH]},
    prior = {NAME = [VALUE, DEVIATION]}.
    """
    if not isinstance(document, Mapping):
        raise ValueError(f"{TABLE} must be a table: write [{TABLE}] and its keys below.")
    for key in document:
        if key not in MEANS:
            raise ValueError(f"unknown {key} in [{TABLE}]: it takes fix, bound and prior.")
    return ByHand(
        {name: numbers("fix", name, value, 1)[0] for name, value in entries(document, "fix")},
        {name: pair("bound", name, value) for name, value in entries(document, "bound")},
        {name: pair("prior", name, value) for name, value in entries(document, "prior")},
    )


def entries(document: Mapping[str, Any], key: str):
    table = document.get(key, {})
    if not isinstance(table, Mapping):
        raise ValueError(f"{key} in [{TABLE}] must be a table such as {{damping = 0.4}}.")
    return table.items()


def pair(key: str, name: str, value: Any) -> tuple[float, float]:
    one, other = numbers(key, name, value, 2)
    return one, other


def numbers(key: str, name: str, value: Any, count: int) -> tuple[float, ...]:
    """So many numbers, refused in words."""
    each = value if isinstance(value, list) else [value]
    good = all(isinstance(one, int | float) and not isinstance(one, bool) for one in each)
    if len(each) != count or not good:
        wanted = "one number" if count == 1 else "two numbers in brackets"
        raise ValueError(f"{key} of {name} in [{TABLE}] is {value!r:.60}; it takes {wanted}.")
    return tuple(float(one) for one in each)
