// What befalls the sensors' wires, and what the node on a Teensy makes of it.

#include "constants.h"
#include "listener.h"

namespace {

using teensy::board;

void clock_that_is_held() {
  power_on();
  run_ms(300);
  board.clock_held = true;
  for (const Frame& state : states_of(30)) check((status(state) & 9) == 9, "nothing is measured");
  check(board.held_us == 0, "a bus that is held is not waited for");
  check(longest_pass_us < exoid::TICK_US, "no pass takes a tick");
  board.clock_held = false;
  check(status(states_of(30).back()) == 0, "the sensors come back with the bus");
}

void data_that_is_held() {
  power_on();
  run_ms(300);
  board.pulses_to_free = 5;
  for (const Frame& state : states_of(20)) check(status(state) == 0, "pulses free the data line");
  check(board.held_us == 0, "before Wire could wait for it");
}

void sensors_that_are_silent() {
  power_on();
  run_ms(300);
  for (uint16_t fault : {chips::ENCODER_SILENT, chips::IMU_SILENT}) {
    board.leg = [=](uint32_t tick) {
      chips::Exposure now = swinging(tick);
      now.faults = fault;
      return now;
    };
    run_ms(20);
    const uint32_t bit = fault == chips::ENCODER_SILENT ? 1 : 8;
    for (const Frame& state : states_of(10)) check(status(state) == bit, "it is told");
    board.leg = swinging;
    check(status(states_of(30).back()) == 0, "and goes by");
  }
}

void read_that_is_refused() {
  power_on();
  run_ms(300);
  for (int read : {1, 2, 3, 4}) {  // of a tick: the encoder's two, then the inertial sensor's
    board.refuses_read = read;
    uint32_t told = 0;
    for (const Frame& state : states_of(20)) {
      if (status(state) == 0) continue;
      check(status(state) == (read <= 2 ? 1U : 8U), "what did not come is no reading");
      ++told;
    }
    check(told == 1, "and costs no more than its tick");
  }
}

void clock_that_falls_in_a_transfer() {
  power_on();
  run_ms(300);
  on_bus.clear();
  longest_pass_us = 0;
  board.holds_read = true;
  run_ms(1000);
  check(longest_pass_us > 50000 && longest_pass_us < 60000, "Wire waits for 50 ms, once");
  board.clock_held = false;
  check(status(states_of(60).back()) == 0, "the sensors come back with the bus");
  uint32_t missed = 0;
  for (const Frame& each : on_bus) missed = each.id == exoid::TIME_ID ? field(each, 40, 8) : missed;
  check(missed == 4 || missed == 5, "the ticks without a sample are counted");
  check(board.fed_us < 125000, "and the watchdog waits for longer");
}

}  // namespace

std::vector<Scenario> wire_scenarios() {
  return {
      {"clock_that_is_held", clock_that_is_held},
      {"data_that_is_held", data_that_is_held},
      {"sensors_that_are_silent", sensors_that_are_silent},
      {"read_that_is_refused", read_that_is_refused},
      {"clock_that_falls_in_a_transfer", clock_that_falls_in_a_transfer},
  };
}
