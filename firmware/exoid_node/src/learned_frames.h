/// What is learned of a leg, as the frames that tell it.

#pragma once

#include "exo_can.h"
#include "learned.h"

namespace exoid {

inline Ratios ratios_of(const Learned& found) {
  return {found.ratio[GRAVITY_RATIO], found.ratio[STIFFNESS_RATIO], found.ratio[DAMPING_RATIO],
          found.ratio[TORQUE_RATIO]};
}

inline RatioErrors errors_of(const Learned& found) {
  return {found.error[GRAVITY_RATIO], found.error[STIFFNESS_RATIO], found.error[DAMPING_RATIO],
          found.error[TORQUE_RATIO]};
}

inline Learning learning_of(const LegLearner& learner, const Learned& found, uint32_t tick) {
  constexpr float COUNTS = 16.0F, MOST = 255.0F;  // of Surprise
  const float surprise = found.surprise * COUNTS;
  return {tick & 255U,
          static_cast<uint32_t>(trust(learner, found)),
          static_cast<uint32_t>(learner.phase()),
          learner.drops(),
          static_cast<uint32_t>(surprise < MOST ? surprise : MOST),
          LEARNING_CRC};
}

}  // namespace exoid
