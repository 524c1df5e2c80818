// What commands do to a node, and what it tells of itself.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>

#include "blink.h"
#include "checksum.h"
#include "constants.h"
#include "world.h"

namespace {

using exoid::Frame;

constexpr uint32_t SERIAL = 0xC0FFEE01;
constexpr uint32_t SETTLED_MS = 300;
constexpr uint32_t ZERO_PLACE = 32, ZERO_BITS = 12, REVERSED = 44, COMMISSIONED = 45, CHANGES = 56;

/// A command with its check.
Frame command(uint16_t id, uint32_t serial, uint32_t value, uint32_t bits) {
  Frame frame = {id, {}};
  put(frame, 0, 32, serial);
  put(frame, 32, bits, value);
  put(frame, 56, 8, exoid::checksum(frame.data, exoid::CHECKED_BYTES) & 255U);
  return frame;
}

/// The frames that the node sends within 100 ms of a command.
std::vector<Frame> after(const Frame& frame) {
  world.on_bus.clear();
  world.to_node.push_back(frame);
  run_ms(100);
  return world.on_bus;
}

std::vector<Frame> set(uint16_t id, uint32_t value, uint32_t bits) {
  return after(command(id, SERIAL, value, bits));
}

Frame one(const std::vector<Frame>& frames, uint16_t id) {
  const std::vector<Frame> found = only(frames, id);
  check(found.size() == 1, "there is one such frame");
  return found.front();
}

uint32_t count_of(const std::vector<Frame>& frames) {
  return field(only(frames, exoid::RAW_ID).back(), 0, 12);
}

/// A leg that stands still at this count of the encoder.
void hold(uint16_t count) {
  world.leg = [=](uint32_t) {
    chips::Exposure now = {};
    now.count = count;
    return now;
  };
}

void still_node(uint16_t count) {
  hold(count);
  power_on();
  run_ms(SETTLED_MS);
}

void told_once_a_second() {
  power_on();
  run_ms(5000);
  const std::vector<Frame> settings = only(world.on_bus, exoid::SETTINGS_ID);
  const std::vector<Frame> beats = only(world.on_bus, exoid::HEARTBEAT_ID);
  check(settings.size() == 5 && beats.size() == 5, "it tells how it is once a second");
  check(field(settings[0], 0, 32) == SERIAL, "it tells its serial number");
  check(field(settings[0], ZERO_PLACE, ZERO_BITS) == 2048, "and the zero it was built with");
  check(field(settings[0], COMMISSIONED, 1) == 0, "and that nobody has commissioned it");
  check(field(settings[0], 48, 8) * 125000 == world.bit_rate, "and the bit rate");
  for (uint32_t part = 0; part < 3; ++part) {
    check(field(beats[0], 8 * part, 8) == exoid::FIRMWARE_VERSION[part], "and its version");
  }
  check(field(beats[0], 24, 8) * 20 == 3260, "and its supply");
  check(field(beats[4], 56, 3) == 4, "and that it is well and on CAN");
}

void errors_told() {
  power_on();
  run_ms(SETTLED_MS);
  world.transmit_errors = 130;
  world.bus_off = true;
  world.leg = [](uint32_t tick) {
    chips::Exposure now = swinging(tick);
    now.faults = chips::MAGNET_MISSING;
    return now;
  };
  run_ms(1000);
  const Frame beat = only(world.on_bus, exoid::HEARTBEAT_ID).back();
  check(field(beat, 32, 8) == 130 && field(beat, 40, 8) == 0, "it tells the error counters");
  check(field(beat, 56, 2) == 3, "and the missing magnet, and that it is off the bus");
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
  hold(900);
  run_ms(20);
  check(count_of(world.on_bus) == 1948, "the angle is measured from there");
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
  bad.push_back(command(0x207, SERIAL, 0, 16));
  bad.push_back(command(exoid::SET_ZERO_ID + 8, SERIAL, 0, 16));
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
  check(world.bit_rate == 500000, "the built-in bit rate is 500 kbit/s");
  check(field(one(set(exoid::SET_BIT_RATE_ID, 8, 8), exoid::REPLY_ID), 44, 1) == 1,
        "8 MHz are too slow for 1 Mbit/s");
  check(field(one(set(exoid::SET_BIT_RATE_ID, 3, 8), exoid::REPLY_ID), 44, 1) == 1,
        "nobody uses 375 kbit/s");
  check(field(one(set(exoid::SET_BIT_RATE_ID, 2, 8), exoid::REPLY_ID), 43, 3) == 0, "250 will do");
  check(world.bit_rate == 500000, "the bus goes on as it is");
  power_on();
  check(world.bit_rate == 250000, "the next start uses the new rate");
}

void flash_that_fails() {
  still_node(1000);
  world.flash_works = false;
  const std::vector<Frame> frames = set(exoid::SET_ZERO_ID, 0, 16);
  check(field(one(frames, exoid::REPLY_ID), 45, 1) == 1, "it says that nothing is kept");
  check(field(one(frames, exoid::SETTINGS_ID), COMMISSIONED, 1) == 0, "now and later");
  check(count_of(frames) == 2048, "the zero counts until the power goes");
  world.flash_works = true;
  const std::vector<Frame> again = set(exoid::SET_ZERO_ID, 0, 16);
  check(field(one(again, exoid::REPLY_ID), 45, 1) == 0, "it can be tried again");
  check(field(one(again, exoid::SETTINGS_ID), COMMISSIONED, 1) == 1, "and then it is kept");
}

void blinks() {
  still_node(1000);
  const auto flashes = [] {
    uint32_t count = 0;
    for (int pass = 0; pass < 1000; ++pass) {
      const bool before = world.lit;
      run_ms(1);
      count += world.lit && !before;
    }
    return count;
  };
  check(flashes() == 1, "half a second on, half a second off");
  set(exoid::IDENTIFY_ID, 2, 8);
  check(flashes() == 10, "somebody who looks for it finds it");
  run_ms(2000);
  check(flashes() == 1, "for as long as it was told");
  world.leg = [](uint32_t) {
    chips::Exposure now = {};
    now.faults = chips::ENCODER_SILENT;
    return now;
  };
  run_ms(100);
  check(flashes() == 2, "two flashes: a sensor");
  world.bus_off = true;
  run_ms(1000);
  check(flashes() == 3, "three flashes: the bus");
}

/// A line that sends this frame.
std::string line_of(const Frame& frame) {
  char text[32];
  std::snprintf(text, sizeof text, "t%03X8", frame.id);
  std::string line = text;
  for (uint8_t byte : frame.data) {
    std::snprintf(text, sizeof text, "%02x", byte);
    line += text;
  }
  return line + "\r";
}

void over_usb() {
  world.has_controller = false;
  still_node(1000);
  world.from_host = line_of(command(exoid::SET_ZERO_ID, SERIAL, 0, 16));
  run_ms(50);
  check(world.to_host == "\a", "a closed channel takes no command");
  world.from_host = "O\r";
  run_ms(1000);
  check(world.to_host.find("t1048") != std::string::npos, "who listens is told the settings");
  world.to_host.clear();
  world.from_host = line_of(command(exoid::SET_ZERO_ID, SERIAL, 0, 16));
  run_ms(50);
  check(world.to_host.find("t106801EEFFC00102") != std::string::npos, "it replies");
  check(world.to_host.find("t104801EEFFC0E823") != std::string::npos, "and tells the new zero");
}

}  // namespace

std::vector<Scenario> command_scenarios() {
  return {
      {"told_once_a_second", told_once_a_second},
      {"errors_told", errors_told},
      {"zero_here", zero_here},
      {"zero_at_an_angle", zero_at_an_angle},
      {"zero_without_an_angle", zero_without_an_angle},
      {"not_a_command", not_a_command},
      {"node_id", node_id},
      {"bit_rate", bit_rate},
      {"flash_that_fails", flash_that_fails},
      {"blinks", blinks},
      {"over_usb", over_usb},
  };
}
