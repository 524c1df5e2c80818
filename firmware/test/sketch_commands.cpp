// What commands do to a node on CAN.

#include <cstdlib>

#include "command_frames.h"

namespace {

/// The processor stands still for 10 ms, but for no whole tick that it would need.
void check_flash_held_up_nothing(const std::vector<Frame>& frames) {
  constexpr uint32_t LATEST_US = exoid::TICK_US / 2 + 1500;
  check(world.longest_pass_us < 2 * exoid::TICK_US, "no pass of the loop takes two ticks");
  uint32_t held = 0;
  for (const Frame& acc : only(frames, exoid::ACC_ID)) {
    const uint32_t age_us = field(acc, 56, 8) * exoid::AGE_STEP_US;
    check(age_us < LATEST_US, "the next sample is half a tick late at most");
    held += age_us > 1500;
  }
  check(held <= 1, "and no other one");
  check(field(only(frames, exoid::TIME_ID).back(), 40, 8) == 0, "no tick was missed");
  for (const Frame& state : only(frames, exoid::STATE_ID)) {
    check(!status(state, OVERRUN), "and no frame was lost");
  }
}

void zero_here() {
  still_node(1000);
  check(count_of(world.on_bus) == 1000, "the built-in zero is the middle of the turn");
  const std::vector<Frame> frames = set(exoid::SET_ZERO_ID, 0, 16);
  check(field(one(frames, exoid::REPLY_ID), 32, 11) == exoid::SET_ZERO_ID, "it replies");
  check(field(one(frames, exoid::REPLY_ID), 43, 3) == 0, "and that all went well");
  const Frame settings = one(frames, exoid::SETTINGS_ID);
  check(field(settings, ZERO_PLACE, ZERO_BITS) == 1000, "the zero is where the knee is");
  check(field(settings, COMMISSIONED, 1) == 1 && field(settings, CHANGES, 8) == 1, "it is kept");
  check(count_of(frames) == 2048, "the knee is now extended");
  uint32_t resets = 0;
  for (const Frame& state : only(frames, exoid::STATE_ID)) {
    resets += status(state, FILTER_RESET);
    check(std::abs(signed_field(state, 16)) == 0, "the change is no motion");
  }
  check(resets == 1, "the filter starts anew");
  check_flash_held_up_nothing(frames);
  hold(900);
  run_ms(20);
  check(count_of(world.on_bus) == 1948, "the angle is measured from there");
}

/// A command at any moment of a tick.
void flash_at_any_time() {
  still_node(1000);
  for (uint32_t at = 0; at < 20; ++at) {
    run_ms(1);
    check_flash_held_up_nothing(set(exoid::SET_BIT_RATE_ID, at % 2 == 0 ? 2 : 4, 8));
  }
  check(field(one(set(exoid::TELL_ID, 0, 8), exoid::SETTINGS_ID), CHANGES, 8) == 20, "all are kept");
}

void zero_at_an_angle() {
  still_node(10);
  const int32_t hanging = -1024;  // a quarter of a turn
  const auto bits = static_cast<uint32_t>(hanging) & 0xFFFFU;
  check(count_of(set(exoid::SET_ZERO_ID, bits, 16)) == 1024, "the knee hangs");
  const std::vector<Frame> turned = set(exoid::SET_DIRECTION_ID, 1, 1);
  check(field(one(turned, exoid::SETTINGS_ID), REVERSED, 1) == 1, "the direction is turned");
  check(count_of(turned) == 3072, "the same count is now above the zero");
  check(count_of(set(exoid::SET_ZERO_ID, bits, 16)) == 1024, "a turned knee hangs, too");
  hold(20);
  run_ms(20);
  check(count_of(world.on_bus) == 1014, "a turned encoder counts down");
}

void zero_without_an_angle() {
  still_node(1000);
  world.leg = [](uint32_t) {
    chips::Exposure now = {};
    now.faults = chips::MAGNET_MISSING;
    return now;
  };
  run_ms(20);
  const std::vector<Frame> frames = set(exoid::SET_ZERO_ID, 0, 16);
  check(field(one(frames, exoid::REPLY_ID), 43, 3) == 1, "it says that there is no angle");
  check(field(one(frames, exoid::SETTINGS_ID), COMMISSIONED, 1) == 0, "and keeps what it had");
}

void not_a_command() {
  still_node(1000);
  const Frame good = command(exoid::SET_ZERO_ID, SERIAL, 0, 16);
  std::vector<Frame> bad;
  for (uint32_t bit = 0; bit < 64; ++bit) {
    bad.push_back(good);
    bad.back().data[bit / 8] ^= static_cast<uint8_t>(1U << (bit % 8));
  }
  bad.push_back(command(exoid::SET_ZERO_ID, SERIAL + 1, 0, 16));
  bad.push_back(command(exoid::SET_ZERO_ID, 0, 0, 16));  // only TELL may be to all
  bad.push_back(command(exoid::SET_ZERO_ID, SERIAL, 2049, 16));
  bad.push_back(command(exoid::SET_NODE_ID_ID, SERIAL, 16, 8));
  bad.push_back(command(exoid::SET_BIT_RATE_ID, SERIAL, 9, 8));
  bad.push_back(command(exoid::LOAD_ID, SERIAL, 25, 8));  // no such part
  bad.push_back(command(exoid::LOAD_ID, SERIAL + 1, 0, 8));
  bad.push_back(command(0x208, SERIAL, 0, 16));
  bad.push_back(command(0x1FF, SERIAL, 0, 16));
  bad.push_back(command(exoid::STATE_ID, SERIAL, 0, 16));
  for (const Frame& frame : bad) {
    const std::vector<Frame> frames = after(frame);
    check(only(frames, exoid::REPLY_ID).empty(), "nobody replies");
    check(count_of(frames) == 1000, "nothing changes");
  }
}

void node_id() {
  still_node(1000);
  const std::vector<Frame> frames = set(exoid::SET_NODE_ID_ID, 3, 8);
  check(only(frames, exoid::REPLY_ID + 3 * 16).size() == 1, "it replies as the node it is now");
  world.on_bus.clear();
  run_ms(2000);
  for (const Frame& frame : world.on_bus) {
    check(frame.id >= 0x130 && frame.id < 0x140, "all its frames are those of node 3");
  }
  check(only(world.on_bus, 0x131).size() == 200, "and none is lost");
}

void bit_rate() {
  still_node(1000);
  check(board.can.bit_rate == 500000, "the built-in bit rate is 500 kbit/s");
  check(field(one(set(exoid::SET_BIT_RATE_ID, 8, 8), exoid::REPLY_ID), 44, 1) == 1,
        "8 MHz are too slow for 1 Mbit/s");
  check(field(one(set(exoid::SET_BIT_RATE_ID, 3, 8), exoid::REPLY_ID), 44, 1) == 1,
        "nobody uses 375 kbit/s");
  check(field(one(set(exoid::SET_BIT_RATE_ID, 2, 8), exoid::REPLY_ID), 43, 3) == 0, "250 will do");
  run_ms(1000);
  check(only(world.on_bus, exoid::STATE_ID).size() > 100, "the bus goes on as it is");
  board.can.bit_rate = 250000;
  power_cycle();
  world.on_bus.clear();
  run_ms(1000);
  check(only(world.on_bus, exoid::STATE_ID).size() > 95, "the next start uses the new rate");
}

void flash_that_fails() {
  still_node(1000);
  board.flash.works = false;
  const std::vector<Frame> frames = set(exoid::SET_ZERO_ID, 0, 16);
  check(field(one(frames, exoid::REPLY_ID), 45, 1) == 1, "it says that nothing is kept");
  check(field(one(frames, exoid::SETTINGS_ID), COMMISSIONED, 1) == 0, "now and later");
  check(count_of(frames) == 2048, "the zero counts until the power goes");
  board.flash.works = true;
  const std::vector<Frame> again = set(exoid::SET_ZERO_ID, 0, 16);
  check(field(one(again, exoid::REPLY_ID), 45, 1) == 0, "it can be tried again");
  check(field(one(again, exoid::SETTINGS_ID), COMMISSIONED, 1) == 1, "and then it is kept");
}

}  // namespace

std::vector<Scenario> command_scenarios() {
  return {
      {"zero_here", zero_here},
      {"flash_at_any_time", flash_at_any_time},
      {"zero_at_an_angle", zero_at_an_angle},
      {"zero_without_an_angle", zero_without_an_angle},
      {"not_a_command", not_a_command},
      {"node_id", node_id},
      {"bit_rate", bit_rate},
      {"flash_that_fails", flash_that_fails},
  };
}
