/// What the status LED shows, second by second.

#pragma once

#include <stdint.h>

#include "constants.h"

namespace exoid {

/// Twenty steps of 50 ms, the first in the lowest bit.
enum class Blink : uint32_t {
  WELL = 0x00001,            // one flash a second
  SENSOR_FAULT = 0x00021,    // two: no angle, or nothing of the inertial sensor
  BUS_FAULT = 0x00421,       // three: the CAN controller is off the bus, or nearly
  NOT_COMMISSIONED = 0x003FF,  // half a second on, half a second off
  IDENTIFY = 0x55555,        // ten a second
};

/// Whether the LED is on at this tick.
inline bool is_lit(Blink blink, uint32_t tick) {
  constexpr uint32_t STEPS = 20, STEP_TICKS = 1000000 / STEPS / TICK_US;
  return ((static_cast<uint32_t>(blink) >> (tick / STEP_TICKS % STEPS)) & 1U) != 0;
}

}  // namespace exoid
