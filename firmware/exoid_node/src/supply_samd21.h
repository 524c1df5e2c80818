/// The board itself: who it is, what supplies it, and its status LED.

#pragma once

#include <stdint.h>

namespace exoid {

class Board {
 public:
  void begin();

  /// The processor's serial number in 32 bits; never 0.
  static uint32_t serial();

  /// The voltage at the processor [mV].
  uint32_t supply_mv();

  void light(bool on);
};

}  // namespace exoid
