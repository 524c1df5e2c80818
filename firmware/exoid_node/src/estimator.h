/// From one tick's readings to the STATE frame: what may reach the filter, and what it then says.

#pragma once

#include "as5600.h"
#include "exo_can.h"
#include "kalman.h"
#include "lsm6ds3.h"

namespace exoid {

constexpr int32_t TURN = FINE_TURN;       // counts, in which every encoder's are whole
constexpr int32_t ZERO_COUNT = TURN / 2;  // count sent for 0 rad
constexpr int32_t GYRO_LIMIT = 32767;     // counts; the last one means that much or more
constexpr uint32_t LONGEST_BLIND = 25;    // ticks without a measurement before a fresh start

/// What the sensors said at one tick, in counts of the frames RAW and ACC, the angle in FINE's.
struct Sample {
  bool encoder_fault;
  bool imu_fault;
  bool magnet_missing;
  bool magnet_strength;
  int32_t count;    // mounting zero taken off, 0..TURN - 1
  int32_t gyro[3];  // to the foot, in extension, across the shank
  int32_t accel[3];
};

/// The nearest count of RAW, which wraps as the fine one does.
inline uint32_t coarse(int32_t count) {
  constexpr int32_t FINER = TURN / RAW_TURN;
  return static_cast<uint32_t>((count + FINER / 2) / FINER) & (RAW_TURN - 1);
}

/// The count that shows `next` and is nearest to `before`: no step is longer than half a turn.
inline int32_t unwrap(int32_t before, int32_t next) {
  const int32_t step = next - before + TURN / 2;
  return before + (step & (TURN - 1)) - TURN / 2;
}

/// The bits of a count of so many to a turn.
constexpr uint32_t bits_of(int32_t turn) { return turn > 1 ? 1 + bits_of(turn / 2) : 0; }

inline bool gyro_saturated(const Sample& sample) {
  const int32_t rate = sample.gyro[1];
  return !sample.imu_fault && (rate >= GYRO_LIMIT || rate <= -GYRO_LIMIT);
}

inline bool sees_angle(const Sample& sample) {
  return !sample.encoder_fault && !sample.magnet_missing;
}

inline bool sees_rate(const Sample& sample) { return !sample.imu_fault && !gyro_saturated(sample); }

/// The filter with its faults: it predicts over a missing measurement, stands still when nothing
/// at all was measured for LONGEST_BLIND ticks, and then starts afresh from the next measurement.
class Estimator {
 public:
  /// The next sample is the first.
  void restart() { started_ = false; }

  /// STATE of this tick but for counter and overrun; `missed` ticks before it had no sample.
  State update(const Sample& sample, uint32_t missed) {
    const bool saturated = gyro_saturated(sample);
    const bool angle_seen = sees_angle(sample), rate_seen = sees_rate(sample);
    const bool reset = !started_ || (blind_ + missed >= LONGEST_BLIND && (angle_seen || rate_seen));
    if (reset) count_ = ZERO_COUNT;
    const Measurement angle = {angle_of(sample, angle_seen), angle_seen};
    const Measurement rate = {static_cast<float>(sample.gyro[1]) * GYRO_STEP, rate_seen};
    filter(reset, missed, angle, rate);

    State state = {belief_.x0, belief_.x1, belief_.x2, 0, sample.encoder_fault,
                   sample.magnet_missing, sample.magnet_strength, sample.imu_fault, saturated,
                   false, reset, false};
    state.state_saturated = !fits(state);
    return state;
  }

  /// Of the gyro [rad/s].
  float bias() const { return belief_.x3; }

 private:
  float angle_of(const Sample& sample, bool seen) {
    if (seen) count_ = unwrap(count_, sample.count);
    return static_cast<float>(count_ - ZERO_COUNT) * FINE_STEP;
  }

  void filter(bool reset, uint32_t missed, const Measurement& angle, const Measurement& rate) {
    const bool measured = angle.valid || rate.valid;
    if (reset) {
      belief_ = begin(angle, rate);
      started_ = measured;
      blind_ = 0;
      return;
    }
    for (uint32_t tick = 0; tick < missed; ++tick) coast();
    if (measured) {
      belief_ = advance(belief_, angle, rate);
      blind_ = 0;
    } else {
      coast();
    }
  }

  void coast() {
    if (blind_ >= LONGEST_BLIND) return;
    belief_ = predict(belief_);
    ++blind_;
  }

  Belief belief_ = {};
  int32_t count_ = ZERO_COUNT;  // unwrapped
  uint32_t blind_ = 0;          // ticks since the last measurement
  bool started_ = false;
};

}  // namespace exoid
