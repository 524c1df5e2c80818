/// The node's work: one sample per tick of the timer, its three to five frames, what it says of the
/// leg and of the torque's parameters, and the clock.

#pragma once

#include "estimator.h"
#include "leg_teller.h"
#include "permission.h"

namespace exoid {

/// `Encoder` reads counts of EXO_FINE, ZERO_COUNT where the knee is extended and more in extension,
/// and OWN_TURN is how many of its own make a turn. `Uplink` has
/// `bool send(const Frame&)`, false where a frame was lost. `Clock` has `ticks()`, the ticks of the
/// sampling timer since its start, and `age_us()`, the time since the last. `Command` is that of the
/// torque.
template <class Encoder, class Imu, class Uplink, class Clock, class Command>
class Node {
 public:
  Node(Encoder& encoder, Imu& imu, Uplink& uplink, const Clock& clock, Command& command)
      : encoder_(encoder), imu_(imu), uplink_(uplink), clock_(clock), command_(command) {}

  /// Does what is due; returns whether that was a sample. Call it as often as possible.
  bool run() {
    const uint32_t now = clock_.ticks();
    if (now != tick_) {
      sample(now);
      return true;
    }
    if (learner_.work() || tick_ == 0 || clock_.age_us() < TICK_US / 2) return false;
    if (tick_ - told_ >= TICKS_PER_TIME) {
      tell_time();
    } else {
      teller_.run(learner_, tick_, [this](const Frame& frame) { send(frame); });
    }
    if (tick_ - named_ >= TICKS_PER_PARAMETER) tell_parameter();
    return false;
  }

  /// Starts the filter again at the next tick, and learns the leg anew: whoever now begins to listen
  /// hears all of it.
  void restart() {
    estimator_.restart();
    learner_.forget();
    teller_.restart();
  }

  /// A frame was lost that the node has not sent itself; the next STATE tells it.
  void tell_loss() { lossy_ = true; }

  /// Whether the last sample had both an angle and a rate.
  bool healthy() const { return healthy_; }

 private:
  void sample(uint32_t now) {
    const uint32_t missed = now - tick_ - 1;
    tick_ = now;
    missed_ += missed;
    lossy_ = lossy_ || missed > 0;

    Sample sample = {};
    read_encoder(sample);
    read_imu(sample);
    const uint32_t age = clock_.age_us();
    healthy_ = !(sample.encoder_fault || sample.magnet_missing || sample.imu_fault);

    State state = estimator_.update(sample, missed);
    state.counter = tick_ & 255U;
    state.overrun = lossy_;
    const Frame told = pack(state);
    lossy_ = !uplink_.send(told);
    const bool driven = command(sample, state, told);
    send_readings(sample, age);
    learn(sample, missed, driven);
  }

  /// A leg that a motor drives does not move freely: what it does then is not looked at.
  void learn(const Sample& sample, uint32_t missed, bool driven) {
    unseen_ += missed;
    if (driven) {
      ++unseen_;
      return;
    }
    learner_.take({sample.count, sample.gyro[1], sees_angle(sample), sees_rate(sample), unseen_});
    unseen_ = 0;
  }

  /// Before the readings, as a drive waits for it. Returns whether there may be a torque.
  bool command(const Sample& sample, const State& state, const Frame& told) {
    constexpr uint32_t FAULTS = 7;  // byte of EXO_STATE
    if (!command_.is_asked()) return false;
    const Torque torque = command_.update(sample, state, told.data[FAULTS], estimator_.bias());
    send(pack(torque));
    return torque.permit == static_cast<uint32_t>(Permit::ENABLED);
  }

  void read_encoder(Sample& sample) {
    EncoderReading reading = {};
    sample.encoder_fault = !encoder_.read(reading);
    sample.count = sample.encoder_fault ? ZERO_COUNT : reading.count;
    sample.magnet_missing = reading.magnet_missing;
    sample.magnet_strength = reading.magnet_strength;
  }

  void read_imu(Sample& sample) {
    ImuReading reading = {};
    sample.imu_fault = !imu_.read(reading);
    for (uint8_t axis = 0; axis < 3; ++axis) {
      sample.gyro[axis] = reading.gyro[axis];
      sample.accel[axis] = reading.accel[axis];
    }
    // With x to the foot and z in extension, a positive rate about the chip's y is flexion.
    sample.gyro[1] = -sample.gyro[1];
  }

  void send_readings(const Sample& sample, uint32_t age_us) {
    const Raw raw = {coarse(sample.count), tick_ & 15U, sample.gyro[0],
                     sample.gyro[1], sample.gyro[2]};
    const Acc acc = {sample.accel[0], sample.accel[1], sample.accel[2], tick_ & 255U,
                     age_us / AGE_STEP_US};
    send(pack(raw));
    send(pack(acc));
    if (Encoder::OWN_TURN > RAW_TURN) send_fine(sample);
  }

  void send_fine(const Sample& sample) {
    const uint32_t count = static_cast<uint32_t>(sample.count);
    const Fine fine = {count, tick_ & 255U, bits_of(Encoder::OWN_TURN)};
    send(pack(fine));
  }

  void tell_time() {
    told_ = tick_;
    const Time time = {tick_ * TICK_US, tick_ & 255U, missed_ & 255U, CONFIG_CRC};
    send(pack(time));
  }

  void tell_parameter() {
    named_ = tick_;
    Parameter parameter = {};
    if (command_.tell(parameter)) send(pack(parameter));
  }

  void send(const Frame& frame) {
    const bool sent = uplink_.send(frame);
    lossy_ = lossy_ || !sent;
  }

  Encoder& encoder_;
  Imu& imu_;
  Uplink& uplink_;
  const Clock& clock_;
  Command& command_;
  Estimator estimator_;
  LegLearner learner_;
  LegTeller teller_;
  uint32_t tick_ = 0;                     // of the last sample; 0 before the first
  uint32_t told_ = 0U - TICKS_PER_TIME;  // tick of the last TIME
  uint32_t named_ = 0;                    // tick of the last PARAMETER
  uint32_t missed_ = 0;
  uint32_t unseen_ = 0;  // ticks that the learner has not seen since it saw one
  bool healthy_ = true;
  bool lossy_ = false;  // late, or a frame lost, since the last STATE that was sent
};

}  // namespace exoid
