"""A parameter declares its unit, its range and its symbol where it is born."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass, fields
from typing import Any

import equinox as eqx
from jaxtyping import Float

Parameter = Float[Any, ""]  # a number of a term
Starts = tuple[float, ...] | Callable[[float, float], tuple[float, ...]]
AT_AN_END = 1e-3  # of a parameter's range, within which it is at an end of it


@dataclass(frozen=True)
class Declaration:
    """What a parameter says of itself. `lower` and `upper` are the bounds of a fit.

    A search begins at every one of `starts`; where the right place hangs on the motion, they are a
    function of its lowest and highest angle [rad]. At `plain` a term is a simpler one that has all
    its parameters but this. What legs really do may follow another law: `law` is the share of a
    number by which it is off then.
    """

    symbol: str
    unit: str
    lower: float
    upper: float
    title: str
    starts: Starts = ()
    plain: float = 0.0
    law: float = 0.0

    @property
    def inertia_power(self) -> int:
        """How it goes with J where motion alone is known: torques as J, what gives way as 1 / J."""
        if self.unit.startswith(("N m", "kg")):
            return 1
        return -1 if self.unit.endswith("/(N m)") else 0

    def starts_between(self, lowest: float, highest: float) -> tuple[float, ...]:
        """Where a search begins, for a motion between these angles [rad]."""
        return self.starts(lowest, highest) if callable(self.starts) else self.starts


def parameter(
    symbol: str,
    unit: str,
    lower: float,
    upper: float,
    title: str = "",
    starts: Starts = (),
    *,
    plain: float = 0.0,
    law: float = 0.0,
):
    """Declare a parameter field: its symbol, unit, bounds and the words that tables print.

    >>> class Mud(exoid.PhysicsTerm):
    ...     title = reference = explanation = isolate = "mud"
    ...     level: jax.Array = exoid.parameter("D", "N m s/rad", 0.0, 5.0, "drag", (0.1,))
    """
    return eqx.field(
        metadata={"parameter": Declaration(symbol, unit, lower, upper, title, starts, plain, law)},
    )


def declarations(module: type) -> Iterator[tuple[str, Declaration]]:
    """Every declared parameter of a module class, in order, by field name."""
    for entry in fields(module):
        if "parameter" in entry.metadata:
            yield entry.name, entry.metadata["parameter"]
