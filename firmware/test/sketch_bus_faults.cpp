// What the sensors' bus may do, and what the node makes of it: it never stops for it.

#include <Arduino.h>

#include "constants.h"
#include "wire_bus.h"
#include "world.h"

namespace {

using exoid::Frame;

constexpr uint32_t BOTH = (1U << ENCODER_FAULT) | (1U << IMU_FAULT);
constexpr uint32_t LONGEST_PASS_US = 2 * exoid::TICK_US;

std::vector<Frame> states_of(uint32_t ticks) {
  world.on_bus.clear();
  run_ms(ticks * 10);
  return only(world.on_bus, exoid::STATE_ID);
}

uint32_t faults(const Frame& state) { return field(state, 56, 5); }

void begin() {
  power_on();
  run_ms(300);
  check(faults(states_of(5).back()) == 0, "all is well before the fault");
}

void check_no_tick_was_missed() {
  check(world.longest_pass_us < LONGEST_PASS_US, "no pass of the loop takes two ticks");
  run_ms(200);
  const Frame time = only(world.on_bus, exoid::TIME_ID).back();
  check(field(time, 40, 8) == 0, "no tick was missed");
}

/// In the middle of a transfer, at each of its bytes.
void clock_held_in_a_transfer() {
  begin();
  for (uint32_t bytes = 0; bytes < 40; ++bytes) {
    const uint32_t soon = board.ticks + 2;
    world.leg = [=](uint32_t tick) {
      if (tick == soon) board.i2c.hold_clock_after(bytes);
      return swinging(tick);
    };
    bool told = false;
    for (const Frame& state : states_of(6)) told = told || faults(state) != 0;
    const bool held = board.i2c.clock_held;
    check(told == held, "a held clock is told, and nothing else");
    board.i2c.hold_clock_after(0);
    board.i2c.clock_held = false;
    check(faults(states_of(4).back()) == 0, "the sensors come back with the clock");
  }
  check_no_tick_was_missed();
}

void clock_held_for_minutes() {
  begin();
  run_ms(3);  // between two ticks: the frames of the one before are sent
  board.i2c.clock_held = true;
  for (const Frame& state : states_of(6000)) check(faults(state) == BOTH, "nothing was measured");
  board.i2c.clock_held = false;
  check(faults(states_of(30).back()) == 0, "the sensors come back with the clock");
  check_no_tick_was_missed();
}

/// As after a start without a stop: the SERCOM waits for one that never comes.
void busy_with_both_lines_high() {
  begin();
  for (const bool has_timeouts : {true, false}) {
    run_ms(3);  // between two ticks
    board.i2c.has_timeouts = has_timeouts;
    board.i2c.glitch();
    uint32_t told = 0;
    for (const Frame& state : states_of(10)) told += faults(state) != 0;
    check(!has_timeouts || told == 0, "the time-outs end it before it costs a reading");
    check(told <= 1, "the bus is released after one transfer that failed, without time-outs too");
    const uint32_t timeouts = SERCOM_I2CM_CTRLA_LOWTOUTEN | SERCOM_I2CM_CTRLA_MEXTTOEN |
                              SERCOM_I2CM_CTRLA_SEXTTOEN | SERCOM_I2CM_CTRLA_INACTOUT(1);
    check((SERCOM4->I2CM.CTRLA.reg & timeouts) == timeouts, "they are on, after a release too");
  }
  check_no_tick_was_missed();
}

void data_held_in_a_transfer() {
  begin();
  for (int pulses = 1; pulses <= 9; ++pulses) {
    board.i2c.data_held_for = pulses;
    check(faults(states_of(4).back()) == 0, "nine pulses free any device");
    const uint32_t soon = board.ticks + 2;
    world.leg = [=](uint32_t tick) {
      if (tick == soon) board.i2c.hold_data_after(static_cast<uint32_t>(3 * pulses), pulses);
      return swinging(tick);
    };
    check(faults(states_of(6).back()) == 0, "a line that is held in a transfer is freed after it");
  }
  check_no_tick_was_missed();
}

/// The lines take 16 us to rise after a stop's command.
void stop_in_progress() {
  begin();
  const uint32_t set_up = board.i2c.set_ups;
  states_of(50);
  check(board.i2c.set_ups == set_up, "a stop in progress is not taken for a bus that is stuck");
}

/// Answers by its last byte which bytes of a register file were read, one and more at once.
void one_byte_and_more() {
  power_on();
  exoid::WireBus bus;
  bus.begin();
  uint8_t one[1] = {}, two[2] = {};
  check(bus.read(0x6A, 0x0F, one, 1) && one[0] == 0x69, "one byte is read");
  check(bus.read(0x6A, 0x0F, two, 2) && two[0] == 0x69, "and two");
  check(bus.write(0x6A, 0x10, 0x68) && bus.read(0x6A, 0x10, one, 1) && one[0] == 0x68, "and kept");
  check(!bus.read(0x55, 0x0F, one, 1), "a device that is not there does not answer");
  check(bus.read(0x6A, 0x0F, one, 1), "and keeps the bus from no other");
}

void sensors_that_brown_out() {
  begin();
  for (uint32_t off : {1U, 3U, 30U, 300U}) {
    const uint32_t from = board.ticks + 5;
    world.leg = [=](uint32_t tick) {
      chips::Exposure now = swinging(tick);
      if (tick >= from && tick < from + off) {
        now.faults = chips::ENCODER_SILENT | chips::IMU_SILENT | chips::IMU_RESET;
      }
      return now;
    };
    const std::vector<Frame> states = states_of(off + 30);
    uint32_t told = 0;
    for (const Frame& state : states) told += status(state, ENCODER_FAULT);
    check(told == off, "the encoder's silence is told as long as it lasts");
    check(faults(states.back()) == 0, "both are set up again");
  }
  check_no_tick_was_missed();
}

}  // namespace

std::vector<Scenario> bus_fault_scenarios() {
  return {
      {"clock_held_in_a_transfer", clock_held_in_a_transfer},
      {"clock_held_for_minutes", clock_held_for_minutes},
      {"busy_with_both_lines_high", busy_with_both_lines_high},
      {"data_held_in_a_transfer", data_held_in_a_transfer},
      {"stop_in_progress", stop_in_progress},
      {"one_byte_and_more", one_byte_and_more},
      {"sensors_that_brown_out", sensors_that_brown_out},
  };
}
