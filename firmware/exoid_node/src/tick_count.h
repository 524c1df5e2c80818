/// The ticks that an interrupt counts, and the time since the last for who is interrupted.

#pragma once

#include <stdint.h>

namespace exoid {

class TickCount {
 public:
  /// For the interrupt: one has come at this time.
  void tick(uint32_t at_us) {
    at_us_ = at_us;
    count_ = count_ + 1;
  }

  uint32_t count() const { return count_; }

  /// `now_us()` tells the time.
  template <class Clock>
  uint32_t age_us(Clock now_us) const {
    uint32_t before, age;
    do {
      before = count_;
      age = now_us() - at_us_;
    } while (before != count_);  // one came meanwhile
    return age;
  }

 private:
  volatile uint32_t count_ = 0;
  volatile uint32_t at_us_ = 0;
};

}  // namespace exoid
