"""The C++ of the numbers by which the node learns a leg."""

from dataclasses import fields
from typing import Any

import numpy as np

from exoid.recordings.filter.learning import LEARNING, TICKS, Learning


def learning_code(step: float) -> str:
    """A namespace of constants, for ticks of `step` [s]."""
    look = TICKS * step
    powers = tuple(look**k / factorial for k, factorial in ((1, 1), (2, 2), (3, 6), (4, 24)))
    lines = [
        line("step_powers", powers, "s, s^2 / 2, s^3 / 6, s^4 / 24 of a look"),
        line("curve", step**2 / 8, "s^2, by which the mean of two ticks is off its middle"),
        line("angle_deviation", LEARNING.angle_variance**0.5, "rad"),
        *(line(each.name, getattr(LEARNING, each.name), note(each)) for each in fields(Learning)),
    ]
    return "\nnamespace learning {\n\n" + "".join(lines) + "\n}  // namespace learning\n"


def note(each: Any) -> str:
    return each.metadata["note"]


def line(name: str, value: Any, note: str) -> str:
    if isinstance(value, tuple):
        numbers = ", ".join(single(each) for each in value)
        return f"/// {note}\nconstexpr float {name.upper()}[{len(value)}] = {{{numbers}}};\n"
    kind, number = ("int32_t", value) if isinstance(value, int) else ("float", single(value))
    return f"constexpr {kind} {name.upper()} = {number};  // {note}\n"


def single(value: float) -> str:
    """The float32 nearest to `value` as a C++ literal."""
    return f"{np.format_float_scientific(np.float32(value), unique=True, trim='0')}F"


def singles(values: tuple[float, ...]) -> str:
    return f"{{{', '.join(single(value) for value in values)}}}"
