/// The sampling clock of the emulated board: TIMER0 of QEMU's microbit counts microseconds. A real
/// node that is late misses ticks; this one catches up, so that a busy host loses no sample.

#pragma once

#include <stdint.h>

#include "constants.h"

namespace exoid {

class Nrf51Clock {
 public:
  void begin() {
    constexpr uint32_t BITS_32 = 3, MICROSECONDS = 4;  // 16 MHz over 2^4
    at(BIT_MODE) = BITS_32;
    at(PRESCALER) = MICROSECONDS;
    at(START) = 1;
  }

  /// Goes on by half a tick where that much time is gone. Returns whether it did.
  bool advance() {
    if (now_us() - halves_ * HALF < HALF) return false;
    ++halves_;
    return true;
  }

  uint32_t ticks() const { return halves_ / 2; }

  uint32_t age_us() const { return now_us() - ticks() * TICK_US; }

 private:
  static constexpr uint32_t HALF = TICK_US / 2;
  static constexpr uint32_t START = 0x000, CAPTURE = 0x040;
  static constexpr uint32_t BIT_MODE = 0x508, PRESCALER = 0x510, CAPTURED = 0x540;

  static volatile uint32_t& at(uint32_t offset) {
    return *reinterpret_cast<volatile uint32_t*>(0x40008000U + offset);
  }

  static uint32_t now_us() {
    at(CAPTURE) = 1;
    return at(CAPTURED);
  }

  uint32_t halves_ = 0;
};

}  // namespace exoid
