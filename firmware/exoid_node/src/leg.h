/// A leg as it is believed to be, and what anatomy says of one that nobody has seen move.

#pragma once

#include "learning.h"
#include "sine.h"
#include "triangle.h"

namespace exoid {

/// The unknowns that stay from movement to movement: of the sensors the gyro's scale, the age of its
/// samples, and the encoder's error once a turn, by cosine and sine; and those of the leg.
enum Unknown : int32_t {
  SCALE,
  AGE,
  LEVEL_ERROR,
  UPRIGHT_ERROR,
  LEVEL,
  UPRIGHT,
  STIFFNESS,
  TORQUE,
  DAMPING,
  FRICTION,
  UNKNOWNS
};

struct Leg {
  Factored<UNKNOWNS> belief;
  float squares;    // sum of chi-squares of what was learned from
  uint32_t counted;  // how many these are
};

inline Leg expected_leg() {
  Leg leg = {};
  for (int32_t k = 0; k < UNKNOWNS; ++k) {
    leg.belief.mean[k] = learning::EXPECTED[k];
    leg.belief.variance[k] = learning::SCATTER[k] * learning::SCATTER[k];
  }
  return leg;
}

/// No more is believed than with variances so many times as large.
inline void widen(Leg& leg, float times) {
  for (int32_t k = 0; k < UNKNOWNS; ++k) leg.belief.variance[k] = leg.belief.variance[k] * times;
}

/// Acceleration of a leg that is let go at an angle [rad/s^2].
inline float fall(const Leg& leg, float angle) {
  const Turned at = turned(angle);
  const float* is = leg.belief.mean;
  return is[TORQUE] - (is[LEVEL] * at.cosine + is[UPRIGHT] * at.sine) - is[STIFFNESS] * angle;
}

/// Is that another leg, by more than both errors and by more than matters?
inline bool differ(const Leg& one, const Leg& other) {
  const float gravity = one.belief.mean[LEVEL];
  const float squared = gravity * gravity;
  const Unknown which[3] = {LEVEL, STIFFNESS, DAMPING};
  const float sizes[3] = {squared, squared, gravity};
  for (uint8_t k = 0; k < 3; ++k) {
    const float apart = other.belief.mean[which[k]] - one.belief.mean[which[k]];
    const float both = covariance(one.belief, which[k], which[k]) +
                       covariance(other.belief, which[k], which[k]);
    const float square = apart * apart;
    if (square > learning::APART * both && square > learning::MATTERS * learning::MATTERS * sizes[k])
      return true;
  }
  return false;
}

}  // namespace exoid
