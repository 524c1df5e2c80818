/// A free movement followed by what is unknown of the leg: an extended Kalman filter, whose
/// covariance is kept as U D U'.
///
/// It follows the encoder's angle psi = phi + zero, because the equation of motion is linear in
///
///     psi'' = torque - level cos(psi) - upright sin(psi) - stiffness psi - damping psi'
///
/// where level^2 + upright^2 = (m l g / J)^2 and the torque has the zero's share c zero / J: so the
/// filter is hardly wrong, however little is known. Motion and the gyro's bias stand first: a new
/// movement sets them anew and leaves the leg as it was. The motion is followed at the mean time at
/// which the gyro's samples were taken, `late` before the tick.

#pragma once

#include "constants.h"
#include "leg.h"

namespace exoid {

class LegFilter {
 public:
  /// The first sample of a movement: of the motion no more is known than it shows.
  void open(const Leg& leg, float angle, float rate) {
    const float before[OWN] = {angle - learning::LATE * rate, rate, 0.0F};
    const float variance[OWN] = {learning::ANGLE_VARIANCE,
                                 learning::FIRST_RATE * learning::FIRST_RATE,
                                 learning::BIAS * learning::BIAS};
    belief_ = {};
    acceleration_ = 0.0F;
    for (int32_t k = 0; k < OWN; ++k) {
      belief_.mean[k] = before[k];
      belief_.variance[k] = variance[k];
    }
    for (int32_t k = 0; k < UNKNOWNS; ++k) {
      belief_.mean[OWN + k] = leg.belief.mean[k];
      belief_.variance[OWN + k] = leg.belief.variance[k] * learning::FADING;
      for (int32_t row = 0; row < k; ++row) belief_.at(OWN + row, OWN + k) = leg.belief.at(row, k);
    }
    see_rate(rate, ALWAYS);
  }

  /// One tick on.
  void predict() {
    const float* is = belief_.mean;
    const Turned at = turned(is[ANGLE]);
    const float rate = is[RATE], level = is[OWN + LEVEL], upright = is[OWN + UPRIGHT];
    const float damping = is[OWN + DAMPING];
    const float slope = level * at.sine - upright * at.cosine - is[OWN + STIFFNESS];
    const float bend = level * at.cosine + upright * at.sine;
    const float a = is[OWN + TORQUE] - bend - is[OWN + STIFFNESS] * is[ANGLE] - damping * rate;
    const float jerk = slope * rate - damping * a;
    const float snap = bend * rate * rate + slope * a - damping * jerk;
    const float angle = is[ANGLE];
    belief_.mean[ANGLE] = angle + H1 * rate + H2 * a + H3 * jerk;
    belief_.mean[RATE] = rate + H1 * a + H2 * jerk + H3 * snap;
    acceleration_ = a + H1 * jerk;

    const Step step = {1.0F + H2 * slope, H1 - H2 * damping,
                       H1 * slope + H2 * (bend * rate - damping * slope),
                       1.0F - H1 * damping + H2 * (slope + damping * damping)};
    const float shown[UNKNOWNS] = {0.0F, -at.cosine, -at.sine, -angle, 1.0F, -rate};
    const float turning[UNKNOWNS] = {0.0F, at.sine * rate, -at.cosine * rate, -rate, 0.0F, -a};
    carry(step, shown, turning);
    roughen(step);
  }

  /// The encoder's angle [rad].
  Correction see_angle(float angle) {
    float slope[SIZE];
    slope[ANGLE] = 1.0F;
    slope[RATE] = belief_.at(ANGLE, RATE) + learning::LATE;
    for (int32_t k = BIAS; k < SIZE; ++k) {
      slope[k] = belief_.at(ANGLE, k) + learning::LATE * belief_.at(RATE, k);
    }
    const float expected = belief_.mean[ANGLE] + learning::LATE * belief_.mean[RATE];
    return correct(belief_, slope, angle - expected, learning::ANGLE_VARIANCE, learning::GATE);
  }

  /// The gyro's rate [rad/s].
  Correction see_rate(float measured) { return see_rate(measured, learning::GATE); }

  /// Is the motion one that a knee can do?
  bool is_sound() const { return belief_.mean[ANGLE] * belief_.mean[ANGLE] < FARTHEST; }

  /// The leg as it is believed now.
  void read(Factored<UNKNOWNS>& leg) const {
    for (int32_t k = 0; k < UNKNOWNS; ++k) {
      leg.mean[k] = belief_.mean[OWN + k];
      leg.variance[k] = belief_.variance[OWN + k];
      for (int32_t row = 0; row < k; ++row) leg.at(row, k) = belief_.at(OWN + row, OWN + k);
    }
  }

 private:
  enum Own : int32_t { ANGLE, RATE, BIAS, OWN };
  static constexpr int32_t SIZE = OWN + UNKNOWNS;
  static constexpr float H1 = learning::STEP_POWERS[0], H2 = learning::STEP_POWERS[1],
                         H3 = learning::STEP_POWERS[2];
  static constexpr float ALWAYS = 1e30F;
  static constexpr float FARTHEST = 16.0F;  // rad^2; NaN is beyond, too

  /// How angle and rate after a step follow from those before.
  struct Step {
    float f00, f01, f10, f11;
  };

  /// The first two rows of U after a step, in which the leg moves them: their other columns.
  void carry(const Step& f, const float (&shown)[UNKNOWNS], const float (&turning)[UNKNOWNS]) {
    for (int32_t k = BIAS; k < SIZE; ++k) {
      float& first = belief_.at(ANGLE, k);
      float& second = belief_.at(RATE, k);
      const float angle = f.f00 * first + f.f01 * second;
      const float rate = f.f10 * first + f.f11 * second;
      if (k < OWN + LEVEL) {
        first = angle;
        second = rate;
        continue;
      }
      const float push = weighed(shown, k, UNKNOWNS), change = weighed(turning, k, TORQUE);
      first = angle + H2 * push;
      second = rate + (f.f01 * push + H2 * change);
    }
  }

  /// Sum of the weights by a column of the leg's U; the weight of `without` is 0.
  float weighed(const float (&weights)[UNKNOWNS], int32_t column, int32_t without) const {
    float sum = 0.0F;
    for (int32_t k = LEVEL; OWN + k <= column; ++k) {
      if (k == without) continue;
      sum = sum + (OWN + k < column ? weights[k] * belief_.at(OWN + k, column) : weights[k]);
    }
    return sum;
  }

  /// The first two columns of U D U' after a step, and the roughness of the rate. Nothing is
  /// subtracted but in the determinant of the step, which is near 1.
  void roughen(const Step& f) {
    const float d0 = belief_.variance[ANGLE], d1 = belief_.variance[RATE];
    const float both = belief_.at(ANGLE, RATE);
    const float w01 = f.f00 * both + f.f01, w11 = f.f10 * both + f.f11;
    const float determinant = f.f00 * f.f11 - f.f01 * f.f10;
    const float p00 = f.f00 * f.f00 * d0 + w01 * w01 * d1;
    const float p11 = f.f10 * f.f10 * d0 + w11 * w11 * d1 + learning::ROUGHNESS;
    const float p01 = f.f00 * f.f10 * d0 + w01 * w11 * d1;
    const float inverse = 1.0F / p11;
    belief_.variance[ANGLE] =
        (determinant * determinant * d0 * d1 + learning::ROUGHNESS * p00) * inverse;
    belief_.variance[RATE] = p11;
    belief_.at(ANGLE, RATE) = p01 * inverse;
  }

  Correction see_rate(float measured, float gate) {
    const float gain = 1.0F + belief_.mean[OWN + SCALE], rate = belief_.mean[RATE];
    float slope[SIZE];
    slope[ANGLE] = 0.0F;
    slope[RATE] = gain;
    slope[BIAS] = gain * belief_.at(RATE, BIAS) + 1.0F;
    slope[OWN] = gain * belief_.at(RATE, OWN) + belief_.at(BIAS, OWN) + rate;
    for (int32_t k = OWN + LEVEL; k < SIZE; ++k) {
      slope[k] = gain * belief_.at(RATE, k) + belief_.at(BIAS, k) + rate * belief_.at(OWN, k);
    }
    const float noise =
        learning::RATE_VARIANCE + learning::WANDER_VARIANCE * acceleration_ * acceleration_;
    const float expected = gain * rate + belief_.mean[BIAS];
    return correct(belief_, slope, measured - expected, noise, gate);
  }

  Factored<SIZE> belief_ = {};
  float acceleration_ = 0.0F;  // rad/s^2
};

}  // namespace exoid
