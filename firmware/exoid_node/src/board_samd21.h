/// What the node runs on: an Arduino Nano 33 IoT with an MCP2515.

#pragma once

#include "can_timing.h"
#include "config.h"
#include "mcp2515.h"
#include "spi_link.h"
#include "timer_samd21.h"
#include "usb_port.h"
#include "watchdog_samd21.h"

namespace exoid {

using CanLink = SpiLink;
using CanController = Mcp2515<CanLink, CanTiming<config::CAN_CRYSTAL, config::CAN_BIT_RATE>,
                              config::CanUnderstood>;

}  // namespace exoid
