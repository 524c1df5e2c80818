// The sketch on the simulated board, on this machine or on an emulated Cortex-M0: the events of
// in.bin befall it, and what is heard of it goes to out.bin.

#include <Arduino.h>

#include "board/board.h"
#include "board/sinks.h"
#include "world_report.h"

#include "../exoid_node/exoid_node.ino"

#include "fresh_start.h"

using simulated::board;
using world_events::Event;
using world_files::File;

namespace {

constexpr uint32_t BOOT_US = 600000;  // the boot loader waits 500 ms for a second reset

world_events::Report* report = nullptr;
uint16_t sensor_faults = 0;
uint32_t pass_us = 20;
uint64_t longest_pass_us = 0;

void restart(uint8_t cause, uint32_t dark_us) {
  board.reset_cause = cause;
  report->write(board.now_us, world_events::RESTARTED, board.ticks, &cause, 1);
  board.watchdog.enable(false);
  board.i2c.disable();
  board.i2c.slow_clock = false;
  board.now_us += BOOT_US + dark_us;
  build_anew();
  setup();
}

void brown_out(uint32_t dark_us) {
  board.can.set_answer(simulated::Mcp2515Model::DEAD_LOW);
  board.can.set_answer(simulated::Mcp2515Model::ANSWERS);
  chips::Exposure dark = {};
  dark.faults = chips::IMU_RESET;
  board.chips.expose(dark);
  restart(PM_RCAUSE_BOD33, dark_us);
}

void type(uint16_t letter) {
  const char text[] = {static_cast<char>(letter), '\r', '\0'};
  board.usb.type(text);
}

void befall_bus(const Event& event) {
  const uint32_t value = static_cast<uint16_t>(event.value);
  switch (event.kind) {
    case world_events::SENSORS: sensor_faults = static_cast<uint16_t>(value); break;
    case world_events::CLOCK_HELD: board.i2c.clock_held = value != 0; break;
    case world_events::CLOCK_HELD_AFTER: board.i2c.hold_clock_after(value); break;
    case world_events::DATA_HELD_AFTER:
      board.i2c.hold_data_after(value / 16, static_cast<int>(value % 16));
      break;
    case world_events::GLITCH:
      board.i2c.has_timeouts = value != 0;
      board.i2c.glitch();
      break;
    default: break;
  }
}

void befall_can(const Event& event) {
  const uint32_t value = static_cast<uint16_t>(event.value);
  switch (event.kind) {
    case world_events::CONTROLLER:
      board.can.set_answer(static_cast<simulated::Mcp2515Model::Answer>(value));
      break;
    case world_events::ACKNOWLEDGED: board.can.acknowledged = value != 0; break;
    case world_events::SHORTED:
      board.can.shorted = value != 0;
      board.can.stays_off = value == 2 || (value == 0 && board.can.stays_off);
      break;
    case world_events::FOREIGN:
      for (uint8_t length = 15; length > 0; --length) {
        board.can.hear(value, false, length);
        board.can.hear(value << 18, true, length);
      }
      break;
    default: break;
  }
}

void befall(const Event& event) {
  const uint32_t value = static_cast<uint16_t>(event.value);
  befall_bus(event);
  befall_can(event);
  switch (event.kind) {
    case world_events::USB_READS: board.usb.reads = value != 0; break;
    case world_events::USB_PLUGGED:
      if (value == 0) board.usb.unplug();
      board.usb.plugged = value != 0;
      break;
    case world_events::USB_HELD: value == 0 ? board.usb.let_go() : board.usb.take(); break;
    case world_events::TYPED: type(static_cast<uint16_t>(value)); break;
    case world_events::TIMER_STANDS: board.timer_stands = true; break;
    case world_events::BROWN_OUT: brown_out(value * 1000); break;
    case world_events::PASS: pass_us = value; break;
    case world_events::QUIET: report->quiet = true; break;
    default: break;
  }
}

void run_until(uint64_t end_us) {
  while (board.now_us < end_us) {
    const uint64_t began_us = board.now_us;
    loop();
    if (board.now_us - began_us > longest_pass_us) longest_pass_us = board.now_us - began_us;
    board.now_us += pass_us;
    if (board.watchdog.barks()) restart(PM_RCAUSE_WDT, 0);
  }
}

}  // namespace

namespace simulated {

void on_can_frame(const exoid::Frame& frame, uint64_t at_us) { report->frame(at_us, frame); }

void on_usb_packet(const uint8_t* bytes, size_t count) {
  report->packet(board.now_us, bytes, static_cast<uint32_t>(count));
}

/// A leg that swings by 0.3 rad with an acceleration that changes its sign in the middle.
chips::Exposure exposed_to(uint32_t tick) {
  const int32_t at = static_cast<int32_t>(tick % 400), out = at < 200 ? at - 100 : 300 - at;
  const int32_t turned = (10000 - out * out) / 50;
  chips::Exposure now = {};
  now.count = static_cast<uint16_t>(1500 + (at < 200 ? turned : -turned));
  now.gyro[1] = static_cast<int16_t>(out * 5022 / 1000);
  now.accel[0] = -8000;
  now.faults = sensor_faults;
  return now;
}

void violated(const char* sentence) {
  world_files::tell(sentence);
  world_files::end(96);
}

}  // namespace simulated

int main() {
  File input("in.bin", 6, world_files::TO_READ);
  File output("out.bin", 7, world_files::TO_WRITE);
  world_events::Report to_file(output);
  report = &to_file;
  setup();
  Event event = {};
  while (input.read(&event, sizeof event) && event.kind != world_events::END) {
    run_until(event.at_ms * 1000ULL);
    befall(event);
  }
  run_until(event.at_ms * 1000ULL);
  const uint32_t longest = static_cast<uint32_t>(longest_pass_us);
  report->write(board.now_us, world_events::LONGEST_PASS, board.ticks,
                reinterpret_cast<const uint8_t*>(&longest), sizeof longest);
  return 0;
}
