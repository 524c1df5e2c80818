/// The serial port on USB, without the 70 ms and more for which the core waits for a host that
/// does not read.

#pragma once

#include <Arduino.h>

#include "usb_samd21.h"

namespace exoid {

class UsbPort {
 public:
  void begin() { Serial.begin(0); }  // USB knows no bit rate
  int available() { return Serial.available(); }
  int read() { return Serial.read(); }

  /// Room for one packet, none while the host has not taken the last.
  int availableForWrite() { return usb_packet_is_taken() ? Serial.availableForWrite() : 0; }

  /// Whether a program has let go of the port since the last call: DTR falls, also where it was
  /// killed. The packet that waits for it is withdrawn, else the next one would hear it.
  bool hung_up() {
    const bool was_held = held_;
    held_ = Serial.dtr();
    if (!was_held || held_) return false;
    usb_withdraw_packet();
    return true;
  }

  /// Returns more than `count` where the core lost what it had taken.
  size_t write(const uint8_t* bytes, size_t count) { return Serial.write(bytes, count); }

 private:
  bool held_ = false;  // by a program
};

}  // namespace exoid
