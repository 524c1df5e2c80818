/// The simulated Nano 33 IoT with its chips, for programs with and without an operating system.

#pragma once

#include "mcp2515_model.h"
#include "sercom.h"
#include "spi_encoder.h"
#include "usb_model.h"
#include "watchdog_model.h"

namespace simulated {

/// The three rows of flash.
struct FlashModel {
  uint8_t slots[3][64] = {};
  bool works = true;  // else it takes nothing, and says nothing of it
};

struct Board {
  uint64_t now_us = 0;
  chips::Board chips;
  Sercom i2c{now_us, chips};
  Mcp2515Model can{now_us};
  SpiEncoder encoder;
  UsbModel usb{now_us};
  WatchdogModel watchdog{now_us};
  FlashModel flash;
  bool lit = false;           // the status LED
  uint8_t reset_cause = 1;    // bits of RCAUSE: its supply was turned on
  bool timer_stands = false;  // the sampling timer ticks no more, until it is begun again

  /// The sampling timer begins.
  void begin_timer();

  /// Lets ticks and frames come that are due.
  void advance();

  uint32_t ticks = 0;        // since `begin_timer`
  uint64_t ticked_us = 0;    // when the last one came
  uint64_t begin_us = 0;     // of the timer

 private:
  uint64_t due_us_ = 0;
};

extern Board board;

}  // namespace simulated
