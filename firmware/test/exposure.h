/// What the sensors' chips are exposed to.

#pragma once

#include <stdint.h>

namespace chips {

enum Fault : uint16_t {
  ENCODER_SILENT = 1,  // does not acknowledge its address
  IMU_SILENT = 2,
  MAGNET_MISSING = 4,
  MAGNET_WEAK = 8,
  MAGNET_STRONG = 16,
  IMU_RESET = 32,  // has lost its settings, as after a dip of its supply
};

/// What the chips are exposed to at one tick: a record of a sample stream.
struct Exposure {
  uint16_t count;
  uint16_t faults;
  int16_t gyro[3];
  int16_t accel[3];
};

}  // namespace chips
