// What the node says of a leg that moves, and of sensors that fail.

#include <cmath>

#include "constants.h"
#include "world.h"

namespace {

using exoid::Frame;

constexpr uint32_t SETTLED_MS = 300;  // until the gyro runs and the filter has converged

uint32_t faults(const Frame& state) { return field(state, 56, 5); }

double angle(const Frame& state) { return signed_field(state, 0) / 4096.0; }
double velocity(const Frame& state) { return signed_field(state, 16) / 1024.0; }

/// The STATE frames of so many ticks from now.
std::vector<Frame> states_of(uint32_t ticks) {
  world.on_bus.clear();
  run_ms(ticks * 10);
  return only(world.on_bus, exoid::STATE_ID);
}

/// A STATE frame's tick; no scenario that asks for it lasts longer than the counter.
uint32_t tick_of(const Frame& state) { return field(state, 48, 8); }

/// A settled node whose leg suffers a fault from tick `begin` to before tick `end`.
std::vector<Frame> states_with(uint16_t fault, uint32_t begin, uint32_t end) {
  power_on();
  run_ms(SETTLED_MS);
  world.leg = [=](uint32_t tick) {
    chips::Exposure now = swinging(tick);
    if (tick >= begin && tick < end) now.faults = fault;
    return now;
  };
  return states_of(end - SETTLED_MS / 10 + 50);
}

void motion() {
  power_on();
  run_ms(SETTLED_MS);
  const std::vector<Frame> states = states_of(300);
  check(states.size() == 300, "every tick has a STATE");
  check(board.chips.encoder.is_set_up(), "the encoder's fast filter is set, and nothing else");
  for (const Frame& state : states) {
    const uint32_t tick = field(state, 48, 8);
    check(field(state, 56, 8) == 0, "no status bit is set while nothing is wrong");
    bool is_true = false;
    for (uint32_t time = tick; time < 1000; time += 256) {
      const double phase = 0.06 * time;
      is_true = is_true || (std::fabs(angle(state) + 1.5 - 0.8 * std::cos(phase)) < 0.004 &&
                            std::fabs(velocity(state) + 4.8 * std::sin(phase)) < 0.02);
    }
    check(is_true, "the filter follows the leg");
  }
  const std::vector<Frame> forces = only(world.on_bus, exoid::ACC_ID);
  for (const Frame& acc : forces) {
    check(signed_field(acc, 0) == -8000, "the accelerometer's counts are sent as they are");
    const uint32_t age_us = field(acc, 56, 8) * exoid::AGE_STEP_US;
    check(age_us > 500 && age_us < 1500, "the sensors are read within 1.5 ms of the tick");
  }
}

void start() {
  power_on();
  const std::vector<Frame> states = states_of(40);
  for (uint32_t at = 0; at < states.size(); ++at) {
    check(status(states[at], FILTER_RESET) == (at == 0), "the first sample says so");
    check(status(states[at], IMU_FAULT) == (at < 9), "the gyro counts once it has settled");
  }
}

/// Each STATE from tick `begin` to before `end` tells of the fault, and no other does.
void check_told(const std::vector<Frame>& states, Status bit, uint32_t begin, uint32_t end) {
  check(tick_of(states.front()) < begin && tick_of(states.back()) > end, "the fault is in the log");
  for (const Frame& state : states) {
    const bool told = tick_of(state) >= begin && tick_of(state) < end;
    check(faults(state) == (told ? 1U << bit : 0), "a fault is told at its own ticks");
    check(std::fabs(velocity(state)) < 5.2 && angle(state) < -0.6 && angle(state) > -2.4,
          "what was not measured never becomes motion");
  }
}

void encoder_nack() {
  check_told(states_with(chips::ENCODER_SILENT, 40, 43), ENCODER_FAULT, 40, 43);
}

void imu_nack() { check_told(states_with(chips::IMU_SILENT, 40, 43), IMU_FAULT, 40, 43); }

void imu_reset() {
  // One stale read, one tick to set the chip up and see nothing new, eight reads to settle.
  check_told(states_with(chips::IMU_RESET, 40, 41), IMU_FAULT, 40, 50);
}

void stuck_bus() {
  power_on();
  run_ms(SETTLED_MS);
  board.i2c.data_held_for = 5;
  for (const Frame& state : states_of(20)) check(faults(state) == 0, "pulses free the data line");
  board.i2c.clock_held = true;
  for (const Frame& state : states_of(10)) {
    check(faults(state) == ((1U << ENCODER_FAULT) | (1U << IMU_FAULT)), "nothing was measured");
  }
  board.i2c.clock_held = false;
  check(faults(states_of(20).back()) == 0, "the sensors come back with the bus");
}

void missing_magnet() {
  check_told(states_with(chips::MAGNET_MISSING, 40, 50), NO_MAGNET, 40, 50);
}

void weak_magnet() {
  check_told(states_with(chips::MAGNET_WEAK, 40, 50), MAGNET_STRENGTH, 40, 50);
}

void strong_magnet() {
  check_told(states_with(chips::MAGNET_STRONG, 40, 50), MAGNET_STRENGTH, 40, 50);
}

void gyro_saturation() {
  power_on();
  run_ms(SETTLED_MS);
  for (const int16_t count : {INT16_MAX, INT16_MIN}) {
    world.leg = [=](uint32_t tick) {
      chips::Exposure now = swinging(tick);
      now.gyro[1] = count;
      return now;
    };
    run_ms(10);
    for (const Frame& state : states_of(20)) {
      check(faults(state) == 1U << GYRO_SATURATED, "the end of the range is told");
      check(std::fabs(velocity(state)) < 6.0, "a rate at its limit does not reach the filter");
    }
    const int32_t sent = signed_field(only(world.on_bus, exoid::RAW_ID).back(), 32);
    check(sent == (count < 0 ? INT16_MAX : -INT16_MAX), "the limit has the sign of extension");
  }
}

void blindness() {
  const std::vector<Frame> states = states_with(chips::ENCODER_SILENT | chips::IMU_SILENT, 40, 140);
  std::vector<int32_t> angles;
  for (const Frame& state : states) {
    check(status(state, FILTER_RESET) == (tick_of(state) == 140), "the filter starts afresh, once");
    if (tick_of(state) >= 65 && tick_of(state) < 140) angles.push_back(signed_field(state, 0));
  }
  for (const int32_t each : angles) check(each == angles.front(), "it stands still before that");
  check(faults(states.back()) == 0, "then all is well");
}

void saturation() {
  power_on();
  run_ms(SETTLED_MS);
  uint32_t turned = 0;
  world.leg = [&](uint32_t tick) {
    chips::Exposure now = swinging(tick);
    now.count = static_cast<uint16_t>((turned += 300) & 4095U);
    now.gyro[1] = -30000;
    return now;
  };
  const Frame last = states_of(60).back();
  check(status(last, STATE_SATURATED), "a value beyond its range is told");
  check(signed_field(last, 0) == INT16_MAX && signed_field(last, 16) == INT16_MAX, "and cut off");
}

}  // namespace

std::vector<Scenario> sensor_scenarios() {
  return {
      {"motion", motion},
      {"start", start},
      {"encoder_nack", encoder_nack},
      {"imu_nack", imu_nack},
      {"imu_reset", imu_reset},
      {"stuck_bus", stuck_bus},
      {"missing_magnet", missing_magnet},
      {"weak_magnet", weak_magnet},
      {"strong_magnet", strong_magnet},
      {"gyro_saturation", gyro_saturation},
      {"blindness", blindness},
      {"saturation", saturation},
  };
}
