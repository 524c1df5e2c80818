/// How well a movement is explained: are innovations white, and as large as they should be?
///
/// What a model misses is slow beside a sample: neighbouring innovations then share a sign, and each
/// by the fading sum of those before it is positive on the average.

#pragma once

#include "learning.h"
#include "triangle.h"

namespace exoid {

class Surprise {
 public:
  void see_angle(const Correction& seen) {
    if (!seen.used) return;
    const float whitened = seen.weighed * learning::ANGLE_DEVIATION;
    lagged_ = learning::FADE * lagged_ + whitened * memory_;
    memory_ = learning::MEMORY * memory_ + whitened;
    squares_ = learning::FADE * learning::FADE * squares_ + 1.0F;
    angle_ = learning::FADE * angle_ + seen.square;
    weight_ = learning::FADE * weight_ + 1.0F;
  }

  void see_rate(const Correction& seen) {
    if (seen.used) rate_ = learning::FADE * rate_ + seen.square;
  }

  bool is_explained() const { return !is_unwhite(learning::SOUND); }

  /// Is it sure that the movement is not explained?
  bool is_failing() const {
    if (weight_ <= learning::FEWEST) return false;
    const float loud = learning::POWER * weight_;
    return is_unwhite(learning::UNWHITE) || angle_ > loud || rate_ > loud;
  }

 private:
  /// Is it beyond so many squared standard deviations?
  bool is_unwhite(float limit) const {
    constexpr float NARROWER = 1.0F - learning::MEMORY * learning::MEMORY;
    return lagged_ > 0.0F && lagged_ * lagged_ * NARROWER > limit * squares_;
  }

  float memory_ = 0.0F;   // of the innovations before, the latest most
  float lagged_ = 0.0F;   // sum of innovations by the memory before
  float squares_ = 0.0F;  // of the weights in it
  float angle_ = 0.0F, rate_ = 0.0F;  // sums of chi-squares
  float weight_ = 0.0F;               // of these sums
};

}  // namespace exoid
