/// A free movement followed by what is unknown of the leg: an extended Kalman filter, whose
/// covariance is kept as U D U'.
///
/// Motion and the gyro's bias stand first: a new movement sets them anew and leaves the rest as it
/// was. The motion is followed at the mean time at which the gyro's samples were taken, AGE before the
/// middle of two ticks.

#pragma once

#include "leg_step.h"

namespace exoid {

class LegFilter {
 public:
  /// A movement begins: of the motion no more is known than a look shows.
  void open(const Leg& leg, float angle, float shown) {
    const float* is = leg.belief.mean;
    const Turned at = turned(angle);
    const float rate = shown / (1.0F + is[SCALE]), age = is[AGE];
    const float error = is[LEVEL_ERROR] * at.cosine + is[UPRIGHT_ERROR] * at.sine;
    const float before[OWN] = {angle - age * rate - error, rate, 0.0F};
    const float variance[OWN] = {learning::ANGLE_VARIANCE, learning::RATE_VARIANCE,
                                 learning::BIAS * learning::BIAS};
    belief_ = {};
    acceleration_ = jerk_ = 0.0F;
    for (int32_t k = 0; k < OWN; ++k) {
      belief_.mean[k] = before[k];
      belief_.variance[k] = variance[k];
    }
    for (int32_t k = 0; k < UNKNOWNS; ++k) {
      belief_.mean[OWN + k] = is[k];
      belief_.variance[OWN + k] = leg.belief.variance[k] * learning::FADING;
      for (int32_t row = 0; row < k; ++row) belief_.at(OWN + row, OWN + k) = leg.belief.at(row, k);
    }
    belief_.at(ANGLE, RATE) = -age;
    for (int32_t k = BIAS; k < SIZE; ++k) share(k, at, rate);
  }

  /// Two ticks on.
  void predict() {
    const Stepped next = step_of(belief_.mean[ANGLE], belief_.mean[RATE], belief_.mean + OWN);
    belief_.mean[ANGLE] = next.angle;
    belief_.mean[RATE] = next.rate;
    acceleration_ = next.acceleration;
    jerk_ = next.jerk;
    carry(next);
    roughen(next);
  }

  /// The encoder's angle [rad]: the first part of the work.
  void see_angle(float angle) {
    const float rate = belief_.mean[RATE], age = belief_.mean[OWN + AGE];
    const Turned at = turned(belief_.mean[ANGLE]);
    float* slope = update_.slope;
    slope[ANGLE] = 1.0F;
    slope[RATE] = belief_.at(ANGLE, RATE) + age;
    for (int32_t k = BIAS; k < SIZE; ++k) {
      slope[k] = belief_.at(ANGLE, k) + age * belief_.at(RATE, k);
    }
    add(OWN + AGE, rate);
    add(OWN + LEVEL_ERROR, at.cosine);
    add(OWN + UPRIGHT_ERROR, at.sine);
    const float error =
        belief_.mean[OWN + LEVEL_ERROR] * at.cosine + belief_.mean[OWN + UPRIGHT_ERROR] * at.sine;
    const float curved = learning::CURVE * acceleration_;
    begin(angle - (belief_.mean[ANGLE] + age * rate + error + curved), learning::ANGLE_VARIANCE);
  }

  /// The gyro's rate [rad/s]: the same of it.
  void see_rate(float measured) {
    const float gain = 1.0F + belief_.mean[OWN + SCALE], rate = belief_.mean[RATE];
    float* slope = update_.slope;
    slope[ANGLE] = 0.0F;
    slope[RATE] = gain;
    slope[BIAS] = gain * belief_.at(RATE, BIAS) + 1.0F;
    slope[OWN] = gain * belief_.at(RATE, OWN) + belief_.at(BIAS, OWN) + rate;
    for (int32_t k = OWN + 1; k < SIZE; ++k) {
      slope[k] = gain * belief_.at(RATE, k) + belief_.at(BIAS, k) + rate * belief_.at(OWN, k);
    }
    const float noise =
        learning::RATE_VARIANCE + learning::WANDER_VARIANCE * acceleration_ * acceleration_;
    const float expected = gain * (rate + learning::CURVE * jerk_) + belief_.mean[BIAS];
    begin(measured - expected, noise);
  }

  /// The second part of the work of what was seen.
  void go_on() { update_.narrow(belief_, SECOND_PART, LAST_PART); }

  /// And the last one.
  Correction finish() {
    update_.narrow(belief_, LAST_PART, SIZE);
    return update_.end(belief_);
  }

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
  static constexpr int32_t SECOND_PART = 7, LAST_PART = 11;  // first columns of these parts
  static constexpr float FARTHEST = 16.0F;  // rad^2; NaN is beyond, too

  /// What a column of U has of the motion that the first look shows.
  void share(int32_t column, const Turned& at, float rate) {
    belief_.at(RATE, column) = column == BIAS ? -1.0F : -rate * stays(SCALE, column);
    const float error = rate * stays(AGE, column) + at.cosine * stays(LEVEL_ERROR, column);
    belief_.at(ANGLE, column) = -belief_.mean[OWN + AGE] * belief_.at(RATE, column) -
                                (error + at.sine * stays(UPRIGHT_ERROR, column));
  }

  /// An element of U, with its diagonal and what is 0 below.
  float stays(int32_t unknown, int32_t column) const {
    const int32_t row = OWN + unknown;
    if (row < column) return belief_.at(row, column);
    return row == column ? 1.0F : 0.0F;
  }

  /// What is measured depends on an unknown by that much, too.
  void add(int32_t row, float weight) {
    update_.slope[row] = update_.slope[row] + weight;
    for (int32_t k = row + 1; k < SIZE; ++k) {
      update_.slope[k] = update_.slope[k] + weight * belief_.at(row, k);
    }
  }

  void begin(float innovation, float noise) {
    update_.begin(belief_, innovation, noise, learning::DOUBT, learning::GATE);
    update_.narrow(belief_, 0, SECOND_PART);
  }

  /// The first two rows of U after a step, in which the leg moves them: their other columns.
  void carry(const Stepped& f) {
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
      const float push = weighed(f.shown, k, UNKNOWNS, UNKNOWNS);
      const float change = weighed(f.turning, k, TORQUE, FRICTION);
      first = angle + learning::STEP_POWERS[1] * push;
      second = rate + (f.f01 * push + learning::STEP_POWERS[1] * change);
    }
  }

  /// Sum of the weights by a column of the leg's U; the weights of `one` and `other` are 0.
  float weighed(const float (&weights)[DYNAMIC], int32_t column, int32_t one, int32_t other) const {
    float sum = 0.0F;
    for (int32_t k = LEVEL; OWN + k <= column; ++k) {
      if (k == one || k == other) continue;
      const float weight = weights[k - LEVEL];
      sum = sum + (OWN + k < column ? weight * belief_.at(OWN + k, column) : weight);
    }
    return sum;
  }

  /// The first two columns of U D U' after a step, and the roughness of the rate. Nothing is
  /// subtracted but in the determinant of the step, which is near 1.
  void roughen(const Stepped& f) {
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

  Factored<SIZE> belief_ = {};
  Update<SIZE> update_ = {};
  float acceleration_ = 0.0F;  // rad/s^2
  float jerk_ = 0.0F;          // rad/s^3
};

}  // namespace exoid
