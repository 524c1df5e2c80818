// What the node tells of itself, by frames and by its LED, and what it hears over USB.

#include <cstdio>

#include "command_frames.h"
#include "flash_samd21.h"
#include "sampling_timer.h"
#include "supply_samd21.h"
#include "tended_node.h"

namespace {

void told_once_a_second() {
  power_on();
  run_ms(5000);
  const std::vector<Frame> settings = only(world.on_bus, exoid::SETTINGS_ID);
  const std::vector<Frame> beats = only(world.on_bus, exoid::HEARTBEAT_ID);
  const std::vector<Frame> healths = only(world.on_bus, exoid::HEALTH_ID);
  check(settings.size() == 5 && beats.size() == 5, "it tells how it is once a second");
  check(healths.size() == 5, "and how it fares");
  check(field(settings[0], 0, 32) == SERIAL, "it tells its serial number");
  check(field(settings[0], ZERO_PLACE, ZERO_BITS) == 2048, "and the zero it was built with");
  check(field(settings[0], COMMISSIONED, 1) == 0, "and that nobody has commissioned it");
  check(field(settings[0], 48, 8) * 125000 == board.can.bit_rate, "and the bit rate");
  for (uint32_t part = 0; part < 3; ++part) {
    check(field(beats[0], 8 * part, 8) == exoid::FIRMWARE_VERSION[part], "and its version");
  }
  check(field(beats[0], 24, 8) * 20 == 3260, "and its supply");
  check(field(beats[4], 40, 1) == 0 && field(healths[4], 8, 4) == 4, "that it is well, on CAN");
  check(field(healths[4], 32, 32) == 1, "that the controller was set up once, without an error");
}

void errors_told() {
  power_on();
  run_ms(SETTLED_MS);
  board.can.acknowledged = false;
  world.leg = [](uint32_t tick) {
    chips::Exposure now = swinging(tick);
    now.faults = chips::MAGNET_MISSING;
    return now;
  };
  run_ms(1000);
  board.usb.type("O\r");
  run_ms(100);
  const std::vector<Frame> told = frames_in(world.to_host.substr(1));
  const Frame health = one(told, exoid::HEALTH_ID);
  check(field(health, 48, 8) == 128 && field(health, 56, 8) == 0, "it tells the error counters");
  check(field(one(told, exoid::HEARTBEAT_ID), 40, 1) == 1, "and the missing magnet");
}

void blinks() {
  still_node(1000);
  const auto flashes = [] {
    uint32_t count = 0;
    const uint32_t first = board.ticks + 1;
    while (board.ticks < first) run_ms(1);
    while (board.ticks < first + 100) {
      const bool before = board.lit;
      run_ms(1);
      count += board.lit && !before;
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
  board.can.acknowledged = false;
  run_ms(1000);
  check(flashes() == 3, "three flashes: the bus");
  board.can.acknowledged = true;
  run_ms(5000);
  check(flashes() == 2, "until its errors are few again");
  board.can.set_answer(simulated::Mcp2515Model::DEAD_HIGH);
  run_ms(1000);
  check(flashes() == 3, "three flashes: a controller that is gone");
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
  board.can.set_answer(simulated::Mcp2515Model::DEAD_HIGH);
  still_node(1000);
  board.usb.type(line_of(command(exoid::SET_ZERO_ID, SERIAL, 0, 16)).c_str());
  run_ms(50);
  check(world.to_host == "\a", "a closed channel takes no command");
  board.usb.type("O\r");
  run_ms(1000);
  check(world.to_host.find("t1048") != std::string::npos, "who listens is told the settings");
  world.to_host.clear();
  board.usb.type(line_of(command(exoid::SET_ZERO_ID, SERIAL, 0, 16)).c_str());
  run_ms(50);
  check(world.to_host.find("t106801EEFFC00102") != std::string::npos, "it replies");
  check(world.to_host.find("t104801EEFFC0E823") != std::string::npos, "and tells the new zero");
}

/// Who listens on USB beside a host on CAN hears the settings and commands the node, as that one.
void commands_by_both() {
  still_node(1000);
  board.usb.type("O\r");
  run_ms(50);
  one(frames_in(world.to_host.substr(1)), exoid::SETTINGS_ID);
  for (const bool by_usb : {true, false}) {
    world.to_host.clear();
    const Frame order = command(exoid::SET_DIRECTION_ID, SERIAL, by_usb ? 1 : 0, 1);
    if (by_usb) board.usb.type(line_of(order).c_str());
    const std::vector<Frame> on_can = by_usb ? after({}) : after(order);
    check(world.to_host.find('\a') == std::string::npos, "slcan takes the line");
    for (const auto& heard : {on_can, frames_in(world.to_host)}) {
      check(field(one(heard, exoid::REPLY_ID), 32, 11) == exoid::SET_DIRECTION_ID, "both hear it");
      check(field(one(heard, exoid::SETTINGS_ID), REVERSED, 1) == by_usb, "and what came of it");
    }
  }
}

/// Loses every heartbeat, and nothing else.
struct LosingLink {
  std::vector<Frame> sent;
  void begin(uint32_t) {}
  bool poll(uint32_t) { return false; }
  bool is_on_can() const { return true; }
  bool receive(Frame&) { return false; }
  bool send(const Frame& frame) {
    sent.push_back(frame);
    return frame.id != exoid::HEARTBEAT_ID;
  }
};

struct Well {
  void describe(exoid::Health&) const {}
};

struct LosingKinds {
  using Encoder = exoid::As5600<chips::Board>;
  using Imu = exoid::Lsm6ds3<chips::Board>;
  using Link = LosingLink;
  using Flash = exoid::ProcessorFlash;
  using Board = exoid::Board;
  using Clock = exoid::SamplingTimer;
  using Condition = Well;
};

void loss_of_what_is_told_beside() {
  LosingKinds::Encoder encoder(board.chips);
  LosingKinds::Imu imu(board.chips);
  LosingLink link;
  exoid::ProcessorFlash flash;
  exoid::Board nano;
  exoid::SamplingTimer timer;
  Well well;
  exoid::TendedNode<LosingKinds> node({encoder, imu, link, flash, nano, timer, well});
  node.begin();
  timer.begin();
  for (; board.now_us < 3000000; board.now_us += 500) node.run(0);
  const std::vector<Frame> beats = only(link.sent, exoid::HEARTBEAT_ID);
  uint32_t told = 0;
  for (const Frame& state : only(link.sent, exoid::STATE_ID)) told += status(state, OVERRUN);
  check(beats.size() == 3 && told == 3, "each loss is told by the next STATE");
  check(field(beats.back(), 32, 8) == 2, "and counted by the next heartbeat");
}

}  // namespace

std::vector<Scenario> state_scenarios() {
  return {
      {"told_once_a_second", told_once_a_second},
      {"errors_told", errors_told},
      {"blinks", blinks},
      {"over_usb", over_usb},
      {"commands_by_both", commands_by_both},
      {"loss_of_what_is_told_beside", loss_of_what_is_told_beside},
  };
}
