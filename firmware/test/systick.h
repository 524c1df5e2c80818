/// The Cortex-M0's SysTick timer, which counts down at 16 MHz on QEMU's microbit.

#pragma once

#include <stdint.h>

namespace exoid {

constexpr uint32_t SYSTICK_PER_US = 16;
constexpr uint32_t SYSTICK_LONGEST = 0x1000000;  // counts

inline volatile uint32_t& systick_register(uint32_t offset) {
  return *reinterpret_cast<volatile uint32_t*>(0xE000E010U + offset);
}

/// Counts until the next tick.
inline uint32_t systick_left() { return systick_register(8); }

/// Interrupts every `period` counts, which ends a wait.
inline void systick_begin(uint32_t period) {
  constexpr uint32_t ENABLE = 1, INTERRUPT = 2, PROCESSOR_CLOCK = 4;
  systick_register(4) = period - 1;
  systick_register(8) = 0;
  systick_register(0) = ENABLE | INTERRUPT | PROCESSOR_CLOCK;
  while (systick_left() == 0) {  // until it has taken the period
  }
}

}  // namespace exoid
