/// The sampling clock: a hardware timer that ticks every 10 ms whatever the program does.

#pragma once

#include <stdint.h>

namespace exoid {

class SamplingTimer {
 public:
  void begin();
  /// Ticks since `begin`.
  uint32_t ticks() const;
  /// Time since the last tick [us].
  uint32_t age_us() const;
};

}  // namespace exoid
