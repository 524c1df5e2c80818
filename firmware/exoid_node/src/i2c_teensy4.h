/// I2C transfers by the Teensy's Wire, whose own waits end: those for a bus that is not free after
/// 16 ms, those within a transfer after 50 ms.

#pragma once

#include <stdint.h>

namespace exoid {

class I2cMaster {
 public:
  void begin() {}

  /// Wire itself waits for the end of a transfer.
  bool is_idle() const { return true; }

  /// Takes the bytes for a device; they leave with what comes next. Returns false where they are
  /// too many.
  bool write(uint8_t device, const uint8_t* bytes, uint8_t count);

  /// Sends what was taken, then reads one byte or more and ends with a stop. Returns false where
  /// the device is silent.
  bool read(uint8_t device, uint8_t* bytes, uint8_t count);

  /// Sends what was taken and lets the bus go. Returns false where a byte was not acknowledged.
  bool stop();
};

}  // namespace exoid
