/// Is the angle that of the leg now? What the encoder turns and what the gyro says must agree.

#pragma once

#include "estimator.h"

namespace exoid {

constexpr float APART_FADING = 0.98F;  // a tick: a bias that is a little off does not add up
constexpr float MOST_APART = 0.1F;     // rad
constexpr uint32_t SETTLING = 50;      // ticks until the filter knows the gyro's bias

class AngleWatch {
 public:
  /// A tick's count of the encoder, and the rate [rad/s] less the gyro's bias; `sound` where both
  /// were measured, and the filter goes on from the tick before.
  void see(int32_t count, float rate, bool sound) {
    if (!sound) {
      settled_ = 0;
    } else {
      const int32_t counts = settled_ > 0 ? unwrap(count_, count) - count_ : 0;
      const float turned = static_cast<float>(counts) * FINE_STEP;
      apart_ = settled_ > 0 ? APART_FADING * apart_ + (turned - rate * TIME_STEP) : 0.0F;
      if (settled_ < SETTLING) ++settled_;
    }
    count_ = count;
  }

  /// False of an encoder or a gyro that stands still while the other moves, and while the filter
  /// begins.
  bool is_trusted() const {
    return settled_ >= SETTLING && apart_ < MOST_APART && apart_ > -MOST_APART;
  }

 private:
  float apart_ = 0.0F;  // rad
  int32_t count_ = ZERO_COUNT;
  uint32_t settled_ = 0;  // ticks
};

}  // namespace exoid
