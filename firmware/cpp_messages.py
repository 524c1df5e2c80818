"""The C++ of the messages of exoid.dbc: what is in a frame, and how it gets in and out.

A signal whose scale is a power of two is packed from its value and read as one, because that
product is exact in float32; one that is a float32 itself is packed as it is; every other signal is
packed from its count.
"""

import math
import re
import textwrap

from cantools.database.can import Message, Signal

WIDEST_VALUE = 16  # bits of a quantised value; float32 holds its limits and a half exactly


def message_code(message: Message) -> str:
    """A message that the node sends: what it says, how it is packed, and whether values fit."""
    name, struct, variable = names(message)
    puts = "".join(
        f"  put(frame, {each.start}, {each.length}, {bits(each, variable)});\n"
        for each in message.signals
    )
    code = content(message) + (
        f"\ninline Frame pack(const {struct}& {variable}) {{\n"
        f"  Frame frame = {{{name}_ID, {{0, 0, 0, 0, 0, 0, 0, 0}}}};\n{puts}  return frame;\n}}\n"
    )
    checks = [check(each, variable) for each in message.signals if quantised(each)]
    if not checks:
        return code
    every = " &&\n         ".join(checks)
    return code + (
        "\n/// Whether no value is cut off when it is packed.\n"
        f"inline bool fits(const {struct}& {variable}) {{\n  return {every};\n}}\n"
    )


def command_code(message: Message) -> str:
    """A message that the node hears: what it says, how it is read, and whether that may be."""
    _, struct, variable = names(message)
    gets = "".join(
        f"  {variable}.{snake(each.name)} = {taken(each)};\n" for each in message.signals
    )
    bounds = [check for each in message.signals for check in bounds_of(each, variable)]
    return content(message) + (
        f"\ninline void unpack(const Frame& frame, {struct}& {variable}) {{\n{gets}}}\n"
        "\n/// Whether every signal is within its range.\n"
        f"inline bool is_valid(const {struct}&{f' {variable}' if bounds else ''}) {{\n"
        f"  return {' && '.join(bounds) or 'true'};\n}}\n"
    )


def names(message: Message) -> tuple[str, str, str]:
    """The name of its identifier, of its struct, and of a variable that holds it."""
    name = message.name.removeprefix("EXO_")
    return name, "".join(word.capitalize() for word in name.split("_")), name.lower()


def content(message: Message) -> str:
    """Identifier and struct."""
    name, struct, _ = names(message)
    fields = "".join(
        f"  {kind(each)} {snake(each.name)};{note(each)}\n" for each in message.signals
    )
    return (
        f"\nconstexpr uint16_t {name}_ID = 0x{message.frame_id:03X};\n"
        f"\n{about(message)}\nstruct {struct} {{\n{fields}}};\n"
    )


def taken(signal: Signal) -> str:
    """The expression of a signal's value, from the frame."""
    got = f"get(frame, {signal.start}, {signal.length})"
    if signal.length == 1:
        return f"{got} != 0"
    if quantised(signal):
        return f"static_cast<float>(with_sign({got}, {signal.length})) * {signal.scale:.8g}F"
    return f"with_sign({got}, {signal.length})" if signal.is_signed else got


def bounds_of(signal: Signal, variable: str) -> list[str]:
    """What must hold of a signal that can hold more than it may; in counts."""
    value = f"{variable}.{snake(signal.name)}"
    least, most = (
        round((float(limit) - signal.offset) / signal.scale)
        for limit in (signal.minimum or 0, signal.maximum or 0)
    )
    end = "" if signal.is_signed else "U"
    lowest = -(2 ** (signal.length - 1)) if signal.is_signed else 0
    checks = [f"{value} >= {least}{end}"] if least > lowest else []
    return checks + ([f"{value} <= {most}{end}"] if most < lowest + 2**signal.length - 1 else [])


def about(message: Message) -> str:
    lines = textwrap.wrap(message.comment or "", width=95)
    return "\n".join(f"/// {line}" for line in lines)


def kind(signal: Signal) -> str:
    if quantised(signal) or signal.is_float:
        return "float"
    if signal.length == 1:
        return "bool"
    return "int32_t" if signal.is_signed else "uint32_t"


def note(signal: Signal) -> str:
    """The comment of a field: its unit, or what one count stands for."""
    if quantised(signal):
        return f"  // {signal.unit}"
    if signal.scale == 1:
        return f"  // {signal.unit}" if signal.unit else ""
    return f"  // counts of {signal.scale:.8g} {signal.unit or ''}".rstrip()


def bits(signal: Signal, variable: str) -> str:
    """The expression of the bits that are sent, limited to what the signal can hold."""
    value = f"{variable}.{snake(signal.name)}"
    if quantised(signal):
        return f"quantise({counts(signal, variable)}, {limits(signal)})"
    if signal.is_float:
        return f"float_bits({value})"
    if signal.length == 1:
        return f"{value} ? 1U : 0U"
    if signal.is_signed:
        return f"within({value}, {limits(signal)})"
    return value if signal.length == 32 else f"at_most({value}, {2**signal.length - 1}U)"


def check(signal: Signal, variable: str) -> str:
    return f"fits({counts(signal, variable)}, {limits(signal)})"


def counts(signal: Signal, variable: str) -> str:
    return f"{variable}.{snake(signal.name)} * {1 / signal.scale:.1f}F"


def limits(signal: Signal) -> str:
    return f"{-(2 ** (signal.length - 1))}, {2 ** (signal.length - 1) - 1}"


def quantised(signal: Signal) -> bool:
    power = math.frexp(signal.scale)[0] == 0.5 and signal.scale != 1 and signal.offset == 0
    return power and signal.is_signed and signal.length <= WIDEST_VALUE


def snake(name: str) -> str:
    return re.sub(r"(?<=[a-z])(?=[A-Z])", "_", name).lower()
