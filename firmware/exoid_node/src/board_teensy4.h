/// What the node runs on: a Teensy 4.0 or 4.1 with the CAN controller inside.

#pragma once

// The core's flags let the compiler fuse a product and a sum, and the filter then differs from the
// host's in its last bits. The sketch includes this file before all that computes.
#pragma GCC optimize("fp-contract=off")

#include "can_clock.h"
#include "exo_commands.h"
#include "flash_teensy4.h"
#include "flexcan.h"
#include "flexcan_teensy4.h"
#include "sampling_timer.h"
#include "supply_teensy4.h"
#include "usb_teensy4.h"
#include "watchdog_teensy4.h"

namespace exoid {

using CanLink = FlexCanRegisters;
using CanController = FlexCan<CanLink, CAN_CLOCK, CommandIds>;

}  // namespace exoid
