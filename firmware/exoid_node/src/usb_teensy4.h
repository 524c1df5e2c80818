/// The Teensy's serial port on USB, which is up before the sketch and tells the room it has: what
/// is written within it never waits.

#pragma once

#include <Arduino.h>

namespace exoid {

class UsbPort {
 public:
  void begin() {}  // the core's own would wait for a host
  int available() { return Serial.available(); }
  int read() { return Serial.read(); }
  int availableForWrite() { return Serial.availableForWrite(); }
  size_t write(const uint8_t* bytes, size_t count) { return Serial.write(bytes, count); }

  /// Whether a program has let go of the port since the last call: DTR falls, also where it was
  /// killed.
  bool hung_up() {
    const bool was_held = held_;
    held_ = Serial.dtr() != 0;
    return was_held && !held_;
  }

 private:
  bool held_ = false;  // by a program
};

}  // namespace exoid
