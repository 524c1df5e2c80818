/// An MCP2515 with a crystal of 8 MHz on a bus, by its SPI commands and registers.

#pragma once

#include <stdint.h>

#include "frame.h"

namespace simulated {

class Mcp2515Model {
 public:
  enum Answer : uint8_t { ANSWERS, DEAD_LOW, DEAD_HIGH };

  explicit Mcp2515Model(uint64_t& now_us) : now_us_(now_us) { power_on(); }

  // What others do.
  bool acknowledged = true;  // somebody else is on the bus
  bool shorted = false;      // the bus
  bool hears_all = false;    // its filters let in what they should not
  bool stays_off = false;    // once off the bus, as some copies of the chip do
  uint32_t bit_rate = 500000;

  /// Unpowered, or its MISO torn off: what the program then reads is the level of the line.
  void set_answer(Answer answer);

  /// A disturbance puts it back into configuration; its settings stay.
  void fall_out() {
    registers_[0x0E] = 0x80;
    registers_[0x0F] = 0x87;
  }

  /// A frame of another node.
  void hear(uint32_t id, bool extended, uint8_t length);
  void hear(const exoid::Frame& frame);

  /// Does what is due on the bus.
  void advance();

  void select();
  void deselect();
  uint8_t transfer(uint8_t byte);

  uint32_t starts() const { return starts_; }       // resets by command
  uint32_t received() const { return received_; }   // frames in a receive buffer

 private:
  void power_on();
  void send(uint64_t at_us);
  void go_off(uint64_t at_us);
  bool is_normal() const { return (registers_[0x0E] & 0xE0) == 0; }
  bool accepts(uint8_t buffer, uint32_t id, bool extended) const;
  void hear(uint32_t id, bool extended, uint8_t length, const uint8_t* data);
  void keep(uint8_t buffer, uint32_t id, bool extended, uint8_t length, const uint8_t* data);
  void count_errors(uint16_t errors);
  void put(uint8_t at, uint8_t value);
  uint8_t command(uint8_t byte);
  uint8_t stored(uint8_t at) const;
  uint8_t status() const;

  uint64_t& now_us_;
  Answer answer_ = ANSWERS;
  uint8_t registers_[128] = {};
  uint8_t command_ = 0, at_ = 0, count_ = 0;
  uint16_t errors_ = 0;  // of transmission
  uint64_t done_us_ = 0;
  uint32_t starts_ = 0, received_ = 0;
};

}  // namespace simulated
