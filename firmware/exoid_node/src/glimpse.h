/// What a tick showed of a leg, and what its counts mean.

#pragma once

#include "constants.h"

namespace exoid {

/// In counts of EXO_FINE and of EXO_RAW.
struct Glimpse {
  int32_t count;
  int32_t gyro;
  bool sees_angle;
  bool sees_rate;
  uint32_t missed;  // ticks before it without a sample
};

/// Of a count of EXO_FINE [rad].
inline float angle_of(int32_t count) {
  return static_cast<float>(count - FINE_TURN / 2) * FINE_STEP;
}

}  // namespace exoid
