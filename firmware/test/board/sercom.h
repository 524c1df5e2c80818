/// SERCOM4 as an I2C master: its registers, its two lines and the chips on them. Time passes where
/// the program waits. As the real one, it never finishes a byte while somebody holds the clock.

#pragma once

#include <stdint.h>

#include "chips.h"

namespace simulated {

enum SercomRegister : uint8_t { CTRLA, CTRLB, STATUS, INTFLAG, SYNCBUSY, ADDR, DATA };

class Sercom {
 public:
  Sercom(uint64_t& now_us, chips::Board& chips) : now_us_(now_us), chips_(chips) {}

  // What others do to the lines.
  int data_held_for = 0;       // clock pulses until a device lets the data line go
  bool clock_held = false;     // by a device
  bool slow_clock = false;     // of the time-outs, as the program started it
  bool has_timeouts = true;    // false: as if their clock stood still
  uint32_t set_ups = 0;        // by Wire

  /// A start without a stop was seen: the bus looks busy, though both lines are high.
  void glitch() { become_busy(); }

  /// So many bytes from now a device holds a line; 0 is never.
  void hold_clock_after(uint32_t bytes) { clock_in_ = bytes; }
  void hold_data_after(uint32_t bytes, int pulses) {
    data_in_ = bytes;
    pulses_ = pulses;
  }

  /// What Wire does at its begin, and at each new frequency.
  void set_up(uint32_t frequency);
  void disable() { enabled_ = false; operation_ = NONE; stopping_ = false; }

  uint32_t read(SercomRegister from);
  void write(SercomRegister to, uint32_t value);

  // The pins as general inputs and outputs.
  void pull_data(bool pulled) { data_pulled_ = pulled; }
  void pull_clock(bool pulled);
  bool data_is_low();
  bool clock_is_low() const { return clock_pulled_ || clock_held; }

 private:
  enum Operation : uint8_t { NONE, ADDRESS, SEND, FETCH };
  enum State : uint8_t { UNKNOWN, IDLE, OWNER, BUSY };

  void become_busy();
  void begin(Operation operation);
  void settle();
  void count_byte();
  void finish();
  void finish_address();
  void time_out();
  void command(uint32_t value);
  uint32_t status();
  uint32_t flags();
  uint8_t fetched();

  uint64_t& now_us_;
  chips::Board& chips_;
  bool enabled_ = false, data_pulled_ = false, clock_pulled_ = false, stopping_ = false;
  uint32_t settings_ = 0, errors_ = 0, byte_us_ = 90;
  uint8_t flags_ = 0, address_ = 0, sent_ = 0, data_ = 0, first_ = 0, count_ = 0;
  Operation operation_ = NONE;
  State state_ = UNKNOWN;
  uint64_t done_us_ = 0, busy_us_ = 0, stop_us_ = 0;
  uint32_t clock_in_ = 0, data_in_ = 0;
  int pulses_ = 0;
};

}  // namespace simulated
