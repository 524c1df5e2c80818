/// No store for settings and parameters: on a Teensy they hold until the power goes, and every reply
/// says so. The processor runs from the flash that it would have to erase.

#pragma once

#include <stdint.h>

namespace exoid {

class ProcessorFlash {
 public:
  /// Every slot is as erased.
  void read(uint8_t, uint8_t* bytes, uint32_t count) const {
    for (uint32_t at = 0; at < count; ++at) bytes[at] = 0xFF;
  }

  bool write(uint8_t, const uint8_t*, uint32_t) { return false; }
};

}  // namespace exoid
