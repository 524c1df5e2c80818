/// What the core does not tell of its USB.

#pragma once

namespace exoid {

/// Whether the host has taken the last packet that was written to the serial port.
bool usb_packet_is_taken();

/// Takes that packet back.
void usb_withdraw_packet();

}  // namespace exoid
