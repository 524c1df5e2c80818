/// What the node runs on: a Teensy 4.0 or 4.1 with the CAN controller inside.

#pragma once

// The core's flags let the compiler fuse a product and a sum, and the filter then differs from the
// host's in its last bits. The sketch includes this file before all that computes.
#pragma GCC optimize("fp-contract=off")

#include "can_timing.h"
#include "config.h"
#include "flexcan.h"
#include "flexcan_teensy4.h"
#include "timer_teensy4.h"
#include "usb_teensy4.h"
#include "watchdog_teensy4.h"

namespace exoid {

using CanLink = FlexCanRegisters;
// An MCP2515 divides its crystal by two before all else, which this controller does not.
using CanController = FlexCan<CanLink, CanTiming<2 * FLEXCAN_CLOCK, config::CAN_BIT_RATE>,
                              config::CanUnderstood>;

}  // namespace exoid
