/// The simulated Teensy 4: its timers, its I2C bus with both chips, its CAN controller and its USB.

#pragma once

#include <functional>
#include <string>

#include "chips.h"
#include "flexcan_model.h"

namespace teensy {

struct Board {
  uint64_t now_us = 0;
  chips::Board chips;
  simulated::FlexCanModel can{now_us};
  std::function<chips::Exposure(uint32_t tick)> leg;

  bool clock_held = false;     // the I2C bus's, by a device
  uint32_t pulses_to_free = 0;  // the data line, which a device holds
  int refuses_read = 0;        // which one from now on is not acknowledged
  bool holds_read = false;     // in the next one a device pulls the clock down
  uint64_t held_us = 0;        // spent in Wire on a bus that was not free

  std::string to_host, typed;  // on USB
  int room = 2048;             // for a host
  bool held = true;            // by a program: DTR

  uint64_t fed_us = 0, fed_last_us = 0;  // longest time between two feeds, and the last
  uint32_t ticks = 0;

  /// Lets ticks come that are due.
  void advance();
  void begin_timer(void (*call)(), uint32_t period_us);
  void watchdog(uint32_t value);
  void violated(const char* sentence);

 private:
  void (*tick_)() = nullptr;
  uint64_t due_us_ = 0;
  uint32_t period_us_ = 0;
};

extern Board board;

}  // namespace teensy
