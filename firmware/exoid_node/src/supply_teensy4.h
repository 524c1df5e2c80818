/// The board itself: who it is and its status LED. It cannot measure what supplies it.

#pragma once

#include <stdint.h>

namespace exoid {

class Board {
 public:
  void begin();

  /// The processor's serial number in 32 bits; never 0.
  static uint32_t serial();

  /// 0: it is not measured.
  static uint32_t supply_mv() { return 0; }

  void light(bool on);
};

}  // namespace exoid
