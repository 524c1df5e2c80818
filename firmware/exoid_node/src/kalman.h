/// The Kalman filter of exoid.recordings.filter.kalman in float, operation by operation in the same order.
///
/// Sums run from left to right as written. Compile with -ffp-contract=off where the processor can
/// fuse a product and a sum: the same text then gives the same bits everywhere.

#pragma once

#include "constants.h"

namespace exoid {

/// A value, or none: what is not valid or not finite never reaches the filter.
struct Measurement {
  float value;
  bool valid;
};

/// State (angle rad, velocity rad/s, acceleration rad/s^2, bias of the gyro rad/s) and the ten
/// distinct elements of P.
struct Belief {
  float x0, x1, x2, x3;
  float p00, p01, p02, p03, p11, p12, p13, p22, p23, p33;
};

enum class Row { ANGLE, RATE };

/// Neither NaN nor infinite: only such a number less itself is 0.
inline bool is_finite(float value) { return value - value == 0.0F; }

inline bool usable(const Measurement& measured) {
  return measured.valid && is_finite(measured.value);
}

/// The belief after the first sample alone: what was measured, or 0 with START_VARIANCE. A measured
/// rate is off by the bias, so the two are believed to be opposite.
inline Belief begin(const Measurement& angle, const Measurement& rate) {
  Belief belief = {};
  belief.p00 = START_VARIANCE[0];
  belief.p11 = START_VARIANCE[1];
  belief.p22 = START_VARIANCE[2];
  belief.p33 = START_VARIANCE[3];
  if (usable(angle)) {
    belief.x0 = angle.value;
    belief.p00 = MEASUREMENT_NOISE[0];
  }
  if (usable(rate)) {
    belief.x1 = rate.value;
    belief.p11 = MEASUREMENT_NOISE[1] + START_VARIANCE[3];
    belief.p13 = -START_VARIANCE[3];
  }
  return belief;
}

/// x = A x and P = A P A' + Q over one time step, in which the bias stays; b is A P.
inline Belief predict(const Belief& b) {
  constexpr float step = TIME_STEP;
  constexpr float half = 0.5F * step * step;
  const float b00 = b.p00 + step * b.p01 + half * b.p02;
  const float b01 = b.p01 + step * b.p11 + half * b.p12;
  const float b02 = b.p02 + step * b.p12 + half * b.p22;
  const float b03 = b.p03 + step * b.p13 + half * b.p23;
  const float b11 = b.p11 + step * b.p12;
  const float b12 = b.p12 + step * b.p22;
  const float b13 = b.p13 + step * b.p23;
  return {
      b.x0 + step * b.x1 + half * b.x2,
      b.x1 + step * b.x2,
      b.x2,
      b.x3,
      b00 + step * b01 + half * b02 + PROCESS_NOISE[0],
      b01 + step * b02,
      b02,
      b03,
      b11 + step * b12 + PROCESS_NOISE[1],
      b12,
      b13,
      b.p22 + PROCESS_NOISE[2],
      b.p23,
      b.p33 + PROCESS_NOISE[3],
  };
}

/// One scalar measurement, of the angle or of velocity and bias together; the belief as it is where
/// nothing was measured.
inline Belief correct(const Belief& b, Row row, const Measurement& measured) {
  if (!usable(measured)) return b;
  const bool of_angle = row == Row::ANGLE;
  const float c0 = of_angle ? b.p00 : b.p01 + b.p03;
  const float c1 = of_angle ? b.p01 : b.p11 + b.p13;
  const float c2 = of_angle ? b.p02 : b.p12 + b.p23;
  const float c3 = of_angle ? b.p03 : b.p13 + b.p33;
  const float variance = (of_angle ? c0 : c1 + c3) + MEASUREMENT_NOISE[of_angle ? 0 : 1];
  const float inverse = 1.0F / variance;
  const float g0 = c0 * inverse, g1 = c1 * inverse, g2 = c2 * inverse, g3 = c3 * inverse;
  const float innovation = measured.value - (of_angle ? b.x0 : b.x1 + b.x3);
  return {
      b.x0 + g0 * innovation,
      b.x1 + g1 * innovation,
      b.x2 + g2 * innovation,
      b.x3 + g3 * innovation,
      b.p00 - g0 * c0,
      b.p01 - g0 * c1,
      b.p02 - g0 * c2,
      b.p03 - g0 * c3,
      b.p11 - g1 * c1,
      b.p12 - g1 * c2,
      b.p13 - g1 * c3,
      b.p22 - g2 * c2,
      b.p23 - g2 * c3,
      b.p33 - g3 * c3,
  };
}

/// One tick: predict, then the angle, then the rate.
inline Belief advance(const Belief& belief, const Measurement& angle, const Measurement& rate) {
  return correct(correct(predict(belief), Row::ANGLE, angle), Row::RATE, rate);
}

}  // namespace exoid
