// sketch [SCENARIO]: plays one scenario with the sketch's own body, or all, each in a process.

#include <Arduino.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "world.h"

#include "../exoid_node/exoid_node.ino"

#include "fresh_start.h"

void power_on() { setup(); }

void power_cycle() {
  board.watchdog.enable(false);
  board.i2c.disable();
  board.can.set_answer(simulated::Mcp2515Model::DEAD_LOW);
  board.can.set_answer(simulated::Mcp2515Model::ANSWERS);
  build_anew();
  setup();
}

void run_ms(uint32_t time) {
  constexpr uint32_t PASS_US = 5;  // the rest of a pass of the loop
  const uint64_t end = board.now_us + time * 1000ULL;
  while (board.now_us < end) {
    const uint64_t began_us = board.now_us;
    loop();
    world.longest_pass_us = std::max(world.longest_pass_us, board.now_us - began_us);
    check(!board.watchdog.barks(), "the watchdog is fed in time");
    board.now_us += PASS_US;
  }
}

void check(bool holds, const char* sentence, int line) {
  if (holds) return;
  std::fprintf(stderr, "line %d, %.3f s: it does not hold that %s\n", line,
               static_cast<double>(board.now_us) * 1e-6, sentence);
  std::exit(1);
}

uint32_t field(const exoid::Frame& frame, uint32_t start, uint32_t length) {
  uint64_t bits = 0;
  for (int at = 7; at >= 0; --at) bits = (bits << 8) | frame.data[at];
  return static_cast<uint32_t>((bits >> start) & ((1ULL << length) - 1));
}

int32_t signed_field(const exoid::Frame& frame, uint32_t start) {
  return static_cast<int16_t>(field(frame, start, 16));
}

bool status(const exoid::Frame& state, uint32_t bit) { return field(state, 56 + bit, 1) != 0; }

std::vector<exoid::Frame> only(const std::vector<exoid::Frame>& frames, uint16_t id) {
  std::vector<exoid::Frame> found;
  for (const exoid::Frame& each : frames) {
    if (each.id == id) found.push_back(each);
  }
  return found;
}

chips::Exposure swinging(uint32_t tick) {
  constexpr double RATE = 6.0, SIZE = 0.8;  // rad/s, rad
  const double phase = RATE * 0.01 * tick;
  const double angle = -1.5 + SIZE * std::cos(phase), velocity = -SIZE * RATE * std::sin(phase);
  chips::Exposure now = {};
  const double counts = angle * Kinds::Encoder::TURN / (2.0 * std::acos(-1.0));
  now.count = static_cast<uint16_t>(std::lround(counts) + config::ENCODER_ZERO) &
              static_cast<uint16_t>(Kinds::Encoder::TURN - 1);
  now.gyro[1] = static_cast<int16_t>(-std::lround(velocity / exoid::GYRO_STEP));
  now.accel[0] = -8000;
  return now;
}

int play(const Scenario& scenario) {
  const pid_t child = fork();
  if (child == 0) {
    world.leg = swinging;
    scenario.play();
    std::exit(0);
  }
  int ended = -1;
  waitpid(child, &ended, 0);
  std::printf("%s: %s\n", ended == 0 ? "ok" : "FAILED", scenario.name);
  return ended == 0 ? 0 : 1;
}

int main(int count, char** names) {
  std::setvbuf(stdout, nullptr, _IOLBF, 0);
  int failed = 0, played = 0;
  for (const auto& scenarios :
       {sensor_scenarios(), uplink_scenarios(), port_scenarios(), bus_fault_scenarios(),
        can_fault_scenarios(), command_scenarios(), state_scenarios(), part_scenarios(),
        torque_scenarios()}) {
    for (const Scenario& each : scenarios) {
      if (count > 1 && std::strcmp(names[1], each.name) != 0) continue;
      failed += play(each);
      ++played;
    }
  }
  return played == 0 ? 2 : failed;
}
