// What commands do to a node on a Teensy, which has no store for its settings.

#include <cstdio>

#include "checksum.h"
#include "config.h"
#include "listener.h"
#include "supply_teensy4.h"

namespace {

using teensy::board;

void type(uint16_t id, uint32_t value, uint32_t bits) {
  Frame frame = {id, {}};
  put(frame, 0, 32, exoid::Board::serial());
  put(frame, 32, bits, value);
  put(frame, 56, 8, exoid::checksum(frame.data, exoid::CHECKED_BYTES) & 255U);
  char line[32];
  int length = std::snprintf(line, sizeof line, "t%03X8", id);
  for (uint8_t byte : frame.data) {
    length += std::snprintf(line + length, sizeof line - length, "%02X", byte);
  }
  on_bus.clear();
  board.typed = std::string(line) + "\r";
  run_ms(100);
}

Frame last(uint16_t id) {
  Frame found = {};
  for (const Frame& each : on_bus) found = each.id == id ? each : found;
  check(found.id == id, "there is such a frame");
  return found;
}

void settings_that_cannot_be_stored() {
  power_on();
  board.leg = [](uint32_t) {
    chips::Exposure now = {};
    now.count = 1000;
    return now;
  };
  run_ms(300);
  board.typed = "O\r";
  run_ms(100);
  type(exoid::SET_ZERO_ID, 0, 16);
  check(field(last(exoid::REPLY_ID), 32, 11) == exoid::SET_ZERO_ID, "it replies");
  check(field(last(exoid::REPLY_ID), 43, 3) == 4, "that nothing is kept, and no more");
  check(field(last(exoid::SETTINGS_ID), 32, 12) == 1000, "the zero is where the knee is");
  check(field(last(exoid::SETTINGS_ID), 45, 1) == 0, "but nobody has commissioned it");
  check(field(last(exoid::RAW_ID), 0, 12) == 2048, "and counts until the power goes");
  check(field(last(exoid::HEARTBEAT_ID), 24, 8) == 0, "the supply is told as not measured");
}

void bit_rates_of_the_oscillator() {
  power_on();
  run_ms(300);
  board.typed = "O\r";
  run_ms(100);
  type(exoid::SET_BIT_RATE_ID, 8, 8);
  check(field(last(exoid::REPLY_ID), 43, 3) == 4, "1 Mbit/s is possible, and not kept");
  type(exoid::SET_BIT_RATE_ID, 3, 8);
  check(field(last(exoid::REPLY_ID), 43, 3) == 2, "nobody uses 375 kbit/s");
}

}  // namespace

std::vector<Scenario> command_scenarios() {
  return {
      {"settings_that_cannot_be_stored", settings_that_cannot_be_stored},
      {"bit_rates_of_the_oscillator", bit_rates_of_the_oscillator},
  };
}
