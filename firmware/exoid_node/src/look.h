/// Two ticks that are looked at as one: a leg is slow beside them, and their mean tells as much.

#pragma once

#include "glimpse.h"

namespace exoid {

/// Sums over both, but for what both must see.
struct Look {
  int32_t counts;
  int32_t gyros;
  bool sees_angle;
  bool sees_rate;
  uint32_t missed;

  int32_t count() const { return counts >> 1; }
  float angle() const { return static_cast<float>(counts - FINE_TURN) * (0.5F * FINE_STEP); }
  float rate() const { return static_cast<float>(gyros) * (0.5F * GYRO_STEP); }
};

inline Look look_at(const Glimpse& first, const Glimpse& second) {
  return {first.count + second.count, first.gyro + second.gyro,
          first.sees_angle && second.sees_angle, first.sees_rate && second.sees_rate,
          first.missed + second.missed};
}

}  // namespace exoid
