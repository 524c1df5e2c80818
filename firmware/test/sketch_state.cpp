// What the node tells of itself, by frames and by its LED, and what it hears over USB.

#include <cstdio>

#include "command_frames.h"

namespace {

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

std::vector<Scenario> state_scenarios() {
  return {
      {"told_once_a_second", told_once_a_second},
      {"errors_told", errors_told},
      {"blinks", blinks},
      {"over_usb", over_usb},
  };
}
