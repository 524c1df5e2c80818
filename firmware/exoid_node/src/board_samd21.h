/// What the node runs on: an Arduino Nano 33 IoT with an MCP2515.

#pragma once

#include "can_clock.h"
#include "exo_commands.h"
#include "flash_samd21.h"
#include "mcp2515.h"
#include "sampling_timer.h"
#include "spi_link.h"
#include "supply_samd21.h"
#include "usb_port.h"
#include "watchdog_samd21.h"

namespace exoid {

using CanLink = SpiLink;
using CanController = Mcp2515<CanLink, CAN_CLOCK, CommandIds>;

}  // namespace exoid
