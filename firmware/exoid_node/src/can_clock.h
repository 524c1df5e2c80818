/// The clock that the CAN controller divides into bits, as an MCP2515 would be stamped with it.

#pragma once

#include "config.h"

namespace exoid {

#if defined(__IMXRT1062__)
// An MCP2515 divides its crystal by two before all else; this controller does not, of 24 MHz.
constexpr uint32_t CAN_CLOCK = 48000000;  // Hz
#else
constexpr uint32_t CAN_CLOCK = config::CAN_CRYSTAL;  // Hz
#endif

}  // namespace exoid
