/// How a leg moves in the two ticks of a look.
///
/// It follows the angle psi = phi + zero, because the equation of motion is linear in
///
///     psi'' = torque - level cos(psi) - upright sin(psi) - stiffness psi - damping psi'
///             - friction sgn(psi')
///
/// where level^2 + upright^2 = (m l g / J)^2 and the torque has the zero's share c zero / J: so a
/// filter is hardly wrong, however little is known.

#pragma once

#include "leg.h"

namespace exoid {

constexpr int32_t DYNAMIC = UNKNOWNS - LEVEL;  // unknowns of the equation of motion

/// A step of so much, with what it depends on.
struct Stepped {
  float angle, rate, acceleration, jerk;  // at its end
  float f00, f01, f10, f11;               // of angle and rate by those before
  float shown[DYNAMIC];                   // of the acceleration by the unknowns, at its begin
  float turning[DYNAMIC];                 // of the jerk; of torque and friction it is 0
};

/// Dry friction in a step: its mean way, and by how much it damps [1/s].
struct Rub {
  float way, drag;
};

/// A leg that turns round in a step is rubbed both ways, each for its share of the time.
inline Rub rubbed(float rate, float free, float friction) {
  const float change =
      0.5F * learning::STEP_POWERS[0] * (free - (rate < 0.0F ? -friction : friction));
  const float size = change < 0.0F ? -change : change;
  const float reach = size > learning::LEAST_TURN ? size : learning::LEAST_TURN;
  const float middle = rate + change;
  if (middle < reach && middle > -reach) return {middle / reach, friction / reach};
  return {middle > 0.0F ? 1.0F : -1.0F, 0.0F};
}

/// From an angle and a rate, of a leg with the means of UNKNOWNS.
inline Stepped step_of(float angle, float rate, const float* is) {
  constexpr float H1 = learning::STEP_POWERS[0], H2 = learning::STEP_POWERS[1],
                  H3 = learning::STEP_POWERS[2], H4 = learning::STEP_POWERS[3];
  const Turned at = turned(angle);
  const float damping = is[DAMPING], stiffness = is[STIFFNESS];
  const float slope = is[LEVEL] * at.sine - is[UPRIGHT] * at.cosine - stiffness;
  const float bend = is[LEVEL] * at.cosine + is[UPRIGHT] * at.sine;
  const float free = is[TORQUE] - bend - stiffness * angle - damping * rate;
  const Rub rub = rubbed(rate, free, is[FRICTION]);
  const float a = free - is[FRICTION] * rub.way, drag = damping + rub.drag;
  const float jerk = slope * rate - damping * a;
  const float snap = bend * rate * rate + slope * a - damping * jerk;
  const float crackle = (3.0F * bend * rate * a - (slope + stiffness) * rate * rate * rate) +
                        slope * jerk - damping * snap;
  return {angle + H1 * rate + H2 * a + H3 * jerk + H4 * snap,
          rate + H1 * a + H2 * jerk + H3 * snap + H4 * crackle,
          a + H1 * jerk,
          jerk + H1 * snap,
          1.0F + H2 * slope,
          H1 - H2 * drag + H3 * slope,
          H1 * slope + H2 * (bend * rate - drag * slope),
          1.0F - H1 * drag + H2 * (slope + drag * drag),
          {-at.cosine, -at.sine, -angle, 1.0F, -rate, -rub.way},
          {at.sine * rate, -at.cosine * rate, -rate, 0.0F, -a, 0.0F}};
}

}  // namespace exoid
