/// Where a test program gets to know what the board sends and does: each program defines these.

#pragma once

#include <stddef.h>
#include <stdint.h>

#include "chips.h"
#include "frame.h"

namespace simulated {

/// A frame was on the CAN bus.
void on_can_frame(const exoid::Frame& frame, uint64_t at_us);

/// The host on USB took a packet.
void on_usb_packet(const uint8_t* bytes, size_t count);

/// What the sensors are exposed to at a tick of the sampling timer.
chips::Exposure exposed_to(uint32_t tick);

/// Ends the program with the sentence that does not hold.
[[noreturn]] void violated(const char* sentence);

}  // namespace simulated
