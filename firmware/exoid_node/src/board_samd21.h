/// The board itself: who it is, what supplies it, and its status LED.

#pragma once

#include <stdint.h>

namespace exoid {

class Board {
 public:
  /// `own_led` lights the board's own LED, too: not where its pin is the clock of the MCP2515.
  void begin(bool own_led);

  /// The processor's serial number in 32 bits; never 0.
  static uint32_t serial();

  /// The voltage at the processor [mV].
  uint32_t supply_mv();

  void light(bool on);

 private:
  bool own_led_ = false;
};

}  // namespace exoid
