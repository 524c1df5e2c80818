/// The serial port on USB as the board's core has it: it always claims room for a packet, waits for a
/// host that does not read, loses what it had taken then, and returns SIZE_MAX.

#pragma once

#include <stddef.h>
#include <stdint.h>

namespace simulated {

class UsbModel {
 public:
  explicit UsbModel(uint64_t& now_us) : now_us_(now_us) {}

  // What the host does.
  bool plugged = true;
  bool reads = true;
  void type(const char* text);
  void unplug();
  void let_go();  // its program ends, at once: nobody reads on, and DTR falls
  void take();    // another one begins
  bool is_held() const { return held_; }  // DTR

  // The port.
  int available() const { return static_cast<int>(typed_ - read_); }
  int read() { return typed_ == read_ ? -1 : input_[read_++ % LONGEST_INPUT]; }
  size_t write(const uint8_t* bytes, size_t count);

  /// Whether a packet waits for the host.
  bool is_full();
  void withdraw() { full_ = false; }

  uint32_t timeouts() const { return timeouts_; }

 private:
  static constexpr size_t PACKET = 64, LONGEST_INPUT = 256;

  void deliver();

  uint64_t& now_us_;
  uint8_t packet_[PACKET] = {};
  size_t count_ = 0;
  bool full_ = false, was_late_ = false, held_ = true;
  uint64_t taken_us_ = 0;
  char input_[LONGEST_INPUT] = {};
  size_t typed_ = 0, read_ = 0;
  uint32_t timeouts_ = 0;
};

}  // namespace simulated
