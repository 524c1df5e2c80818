// teensy4: plays scenarios with the sketch's own body on a simulated Teensy 4, each in a process.

#include <Arduino.h>

#include <cmath>

#include "listener.h"

#include "../../exoid_node/exoid_node.ino"

using teensy::board;

std::vector<Frame> on_bus;
uint64_t longest_pass_us = 0;

uint32_t field(const Frame& frame, int start, int length) {
  uint64_t bits = 0;
  for (int at = 7; at >= 0; --at) bits = (bits << 8) | frame.data[at];
  return static_cast<uint32_t>((bits >> start) & ((1ULL << length) - 1));
}

static double angle_at(uint32_t tick) { return -1.5 + 0.8 * std::cos(0.06 * tick); }

chips::Exposure swinging(uint32_t tick) {
  chips::Exposure now = {};
  const double velocity = -4.8 * std::sin(0.06 * tick);
  now.count = static_cast<uint16_t>(std::lround(angle_at(tick) / exoid::ENCODER_STEP) + 2048);
  now.gyro[1] = static_cast<int16_t>(-std::lround(velocity / exoid::GYRO_STEP));
  now.accel[0] = -8000;
  return now;
}

void run_ms(uint32_t time) {
  const uint64_t end = board.now_us + time * 1000ULL;
  while (board.now_us < end) {
    const uint64_t began_us = board.now_us;
    board.advance();
    loop();
    longest_pass_us = std::max(longest_pass_us, board.now_us - began_us);
    board.now_us += 5;
  }
}

void power_on() {
  board.leg = swinging;
  board.can.on_frame = [](const Frame& frame) { on_bus.push_back(frame); };
  setup();
}

std::vector<Frame> states_of(uint32_t ticks) {
  on_bus.clear();
  run_ms(ticks * 10);
  std::vector<Frame> found;
  for (const Frame& each : on_bus) {
    if (each.id == exoid::STATE_ID) found.push_back(each);
  }
  return found;
}

uint32_t status(const Frame& state) { return field(state, 56, 8); }

namespace {

void motion() {
  power_on();
  run_ms(300);
  const std::vector<Frame> states = states_of(200);
  check(states.size() == 200, "every tick has a STATE");
  const uint32_t first = field(states.front(), 48, 8);
  check(first == 30 || first == 31, "ticks are counted from the start, a hundred a second");
  for (uint32_t at = 0; at < states.size(); ++at) {
    check(status(states[at]) == 0, "nothing is wrong");
    const double angle = static_cast<int16_t>(field(states[at], 0, 16)) / 4096.0;
    const uint32_t tick = first + at;
    check(field(states[at], 48, 8) == (tick & 255U), "none is left out");
    check(std::fabs(angle - angle_at(tick)) < 0.004, "the filter follows the leg");
  }
  std::vector<uint16_t> sampled;
  for (const Frame& each : on_bus) {
    if (each.id >= exoid::STATE_ID && each.id <= exoid::ACC_ID) sampled.push_back(each.id);
  }
  for (uint32_t at = 0; at < sampled.size(); ++at) {
    check(sampled[at] == 0x101 + at % 3, "STATE, RAW and ACC come in this order");
  }
  check(longest_pass_us < exoid::TICK_US, "no pass of the loop takes a tick");
  check(board.fed_us < 15000, "the watchdog is fed at every sample");
  check(board.now_us - board.fed_last_us < 15000, "to the last");
}

void watchdog_is_set() {
  SRC_SRSR = SRC_SRSR_WDOG3_RST_B | 1;
  power_on();
  check(WDOG3_CS.value == 0x21A0, "it runs on 32.768 kHz, and may be set again");
  check(WDOG3_TOVAL.value == 4096 && WDOG3_WIN.value == 0, "for 125 ms, without a window");
  check((CCM_CCGR5 & 0x30) == 0x30, "it has its clock");
  check(watchdog.has_reset(), "that it started the node is known");
  check(SRC_SRSR == SRC_SRSR_WDOG3_RST_B, "and cleared by writing 1 to that bit alone");
  run_ms(1500);
  bool told = false;
  for (const Frame& each : on_bus) {
    told = told || (each.id == exoid::HEALTH_ID && field(each, 8, 1) != 0);
  }
  check(told, "EXO_HEALTH tells it");
}

void bus_without_listener() {
  power_on();
  run_ms(300);
  board.can.acknowledged = false;
  check(states_of(100).empty(), "nobody hears it");
  board.can.acknowledged = true;
  bool told = false;
  const std::vector<Frame> states = states_of(60);
  for (const Frame& state : states) told = told || (status(state) & 128) != 0;
  check(told && status(states.back()) == 0, "Overrun tells that frames were lost, once");
  check(longest_pass_us < exoid::TICK_US, "no pass takes a tick");
}

void host_on_usb() {
  power_on();
  run_ms(300);
  board.typed = "O\r";
  run_ms(1000);
  check(board.to_host.size() > 300 * 22, "frames come as lines");
  check(board.to_host.compare(0, 2, "\rt") == 0, "after the answer");
  const size_t before = board.to_host.size();
  board.room = 0;
  run_ms(1000);
  check(board.to_host.size() == before, "a host that takes nothing is sent nothing");
  check(longest_pass_us < exoid::TICK_US, "and not waited for");
}

void program_that_is_killed() {
  power_on();
  run_ms(300);
  board.typed = "O\r";
  run_ms(1000);
  board.held = false;
  run_ms(20);
  board.held = true;
  board.to_host.clear();
  run_ms(1000);
  check(board.to_host.empty(), "the next program hears nothing before it opens the channel");
}

}  // namespace

int main() {
  std::vector<Scenario> scenarios = {
      {"motion", motion},
      {"watchdog_is_set", watchdog_is_set},
      {"bus_without_listener", bus_without_listener},
      {"host_on_usb", host_on_usb},
      {"program_that_is_killed", program_that_is_killed},
  };
  for (const Scenario& each : wire_scenarios()) scenarios.push_back(each);
  for (const Scenario& each : command_scenarios()) scenarios.push_back(each);
  return play(scenarios);
}
