/// Three rows of the processor's flash: two for the settings, one for the parameters of the torque.
/// Flashing a sketch erases them.

#pragma once

#include <stdint.h>

namespace exoid {

class ProcessorFlash {
 public:
  void read(uint8_t slot, uint8_t* bytes, uint32_t count) const;

  /// Erases the slot and writes it, which takes 10 ms: the processor stands still for that time.
  /// Returns false for more than a page.
  bool write(uint8_t slot, const uint8_t* bytes, uint32_t count);
};

}  // namespace exoid
