/// The torque that a motor gives to a leg that is known: what gravity, stiffness, damping and dry
/// friction do to it is taken off, each by its share.
///
/// Single precision, operation by operation as in tests/firmware/float32_torque.py.

#pragma once

#include "kalman.h"
#include "sine.h"

namespace exoid {

/// A leg of J phi'' = tau - m l g cos(phi + thigh) - c phi - d phi' - friction sign(phi'), how much of
/// it is to be taken off, and how much torque there may be. Extension is positive.
struct LegParameters {
  float gravity;          // m l g [N m]
  float thigh_angle;      // of the thigh above level [rad]
  float stiffness;        // c [N m/rad]
  float damping;          // d [N m s/rad]
  float friction;         // dry [N m]
  float inertia;          // J [kg m^2]
  float gravity_share;    // 0: all is left to the leg, 1: all is taken off; so are the next
  float stiffness_share;
  float damping_share;
  float friction_share;
  float limit;            // of the torque [N m]
  float rate_limit;       // of the torque [N m/s]
};

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
inline float wanted_torque(const LegParameters& leg, float angle, float velocity,
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

/// Is each of these numbers that of a leg and of a small motor? NaN is not.
inline bool is_plausible(const LegParameters& leg) {
  constexpr float LEVEL = 1.5707964F;  // rad
  const float* number[] = {&leg.gravity,         &leg.thigh_angle,   &leg.stiffness,
                           &leg.damping,         &leg.friction,      &leg.inertia,
                           &leg.gravity_share,   &leg.stiffness_share, &leg.damping_share,
                           &leg.friction_share,  &leg.limit,         &leg.rate_limit};
  constexpr float LOWEST[] = {0.0F, -LEVEL, 0.0F, 0.0F, 0.0F, 0.0F, 0.0F, 0.0F, 0.0F, 0.0F, 0.0F, 0.0F};
  constexpr float HIGHEST[] = {60.0F, LEVEL, 60.0F, 10.0F, 10.0F, 2.0F,
                               1.0F,  1.0F,  1.0F,  1.0F,  15.0F, 100.0F};
  for (uint8_t at = 0; at < sizeof LOWEST / sizeof LOWEST[0]; ++at) {
    if (!(*number[at] >= LOWEST[at] && *number[at] <= HIGHEST[at])) return false;
  }
  return true;
}

}  // namespace exoid
