"""The C++ of the parameters by which the node commands a torque."""

from collections.abc import Iterable
from dataclasses import Field, fields

from learning_numbers import singles

from exoid.recordings.commissioning.torque_parameters import (
    ENDS,
    PART,
    PARTS,
    TorqueParameters,
    layout_crc,
)


def parameters_code() -> str:
    """Their struct, between what each is believed, and how they come."""
    declared = fields(TorqueParameters)
    lower, upper = (singles(tuple(each.metadata[end] for each in declared)) for end in ENDS)
    return f"""
/// A leg of J phi'' = tau - m l g cos(phi + thigh) - c phi - d phi' - friction sign(phi'), how much
/// of it is taken off, and how much torque there may be. Extension is positive.
struct TorqueParameters {{
{"".join(members(declared))}}};

constexpr uint8_t PARAMETERS = {len(declared)};
constexpr uint32_t PARAMETER_BYTES = 4 * PARAMETERS;
static_assert(sizeof(TorqueParameters) == PARAMETER_BYTES, "nothing lies between them");

/// What each may be, from and up to, in their order.
constexpr float LOWEST_PARAMETER[PARAMETERS] = {lower};
constexpr float HIGHEST_PARAMETER[PARAMETERS] = {upper};

constexpr uint32_t PART_BYTES = {PART};  // of them in one EXO_LOAD
constexpr uint32_t PARTS = {PARTS};  // and behind these their CRC

/// What the CRC of parameters begins with: that of this layout.
constexpr uint16_t PARAMETERS_SEED = 0x{layout_crc():04X};
"""


def members(declared: Iterable[Field]) -> Iterable[str]:
    for each in declared:
        said = each.metadata["note"]
        unit = f" [{each.metadata['unit']}]" if each.metadata["unit"] else ""
        yield f"  float {each.name};  // {said}{unit}\n"
