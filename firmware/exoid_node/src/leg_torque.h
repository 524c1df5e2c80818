/// The torque that a motor gives to a leg that is known: what gravity, stiffness, damping and dry
/// friction do to it is taken off, each by its share.
///
/// Single precision, operation by operation as in tests/firmware/float32_torque.py.

#pragma once

#include "kalman.h"
#include "sine.h"
#include "torque_parameters.h"

namespace exoid {

constexpr float FURTHEST = 8.0F;        // rad, as far as EXO_STATE tells an angle
constexpr float PER_CREEPING = 10.0F;   // s/rad: below 0.1 rad/s friction is taken off in part
constexpr float NO_TORQUE = __builtin_huge_valf();  // not finite: there is no angle to go by

/// The sign of a velocity [rad/s], which goes smoothly through 0: a jump there would shake the leg.
inline float way(float velocity) {
  const float slow = velocity * PER_CREEPING;
  if (slow >= 1.0F) return 1.0F;
  if (slow <= -1.0F) return -1.0F;
  return slow * (1.5F - 0.5F * slow * slow);
}

/// The torque [N m] on a leg at `angle` [rad] and `velocity` [rad/s] that is to be accelerated by
/// `acceleration` [rad/s^2]; not finite where one of them is not, or the angle is out of reach.
inline float wanted_torque(const TorqueParameters& leg, float angle, float velocity,
                           float acceleration) {
  if (!(angle > -FURTHEST && angle < FURTHEST)) return NO_TORQUE;
  const float weight = leg.gravity * turned(angle + leg.thigh_angle).cosine;
  float torque = leg.inertia * acceleration;
  torque = torque + leg.gravity_share * weight;
  torque = torque + leg.stiffness_share * (leg.stiffness * angle);
  torque = torque + leg.damping_share * (leg.damping * velocity);
  return torque + leg.friction_share * (leg.friction * way(velocity));
}

/// `wanted` within `limit`, and not further than `step` from what was given `before` [N m].
inline float limited(float wanted, float before, float limit, float step) {
  float torque = wanted;
  torque = torque > before + step ? before + step : torque;
  torque = torque < before - step ? before - step : torque;
  torque = torque > limit ? limit : torque;
  return torque < -limit ? -limit : torque;
}

/// One of the parameters by its place.
inline float parameter(const TorqueParameters& leg, uint32_t place) {
  float number[PARAMETERS];
  __builtin_memcpy(number, &leg, sizeof number);
  return number[place];
}

/// Is each of them that of a leg and of a small motor? NaN is not.
inline bool is_plausible(const TorqueParameters& leg) {
  for (uint32_t place = 0; place < PARAMETERS; ++place) {
    const float number = parameter(leg, place);
    if (!(number >= LOWEST_PARAMETER[place] && number <= HIGHEST_PARAMETER[place])) return false;
  }
  return true;
}

}  // namespace exoid
