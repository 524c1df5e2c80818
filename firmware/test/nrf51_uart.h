/// The serial port of QEMU's microbit, with the four functions of Arduino's serial ports.

#pragma once

#include <stddef.h>
#include <stdint.h>

namespace exoid {

class Nrf51Uart {
 public:
  void begin() {
    at(ENABLE) = 4;
    at(START_TRANSMITTER) = 1;
    at(START_RECEIVER) = 1;
  }

  int available() const { return at(RECEIVED) != 0 ? 1 : 0; }

  int read() {
    at(RECEIVED) = 0;
    return static_cast<int>(at(RECEIVE) & 0xFFU);
  }

  int availableForWrite() const { return is_ready() ? LONGEST_WRITE : 0; }
  bool hung_up() const { return false; }

  /// Writes what the host takes now; returns how much that was.
  size_t write(const uint8_t* bytes, size_t count) {
    size_t taken = 0;
    for (; taken < count && is_ready(); ++taken) {
      at(SENT) = 0;
      at(SEND) = bytes[taken];
      busy_ = true;
    }
    return taken;
  }

 private:
  static constexpr uint32_t START_RECEIVER = 0x000, START_TRANSMITTER = 0x008;
  static constexpr uint32_t RECEIVED = 0x108, SENT = 0x11C;
  static constexpr uint32_t ENABLE = 0x500, RECEIVE = 0x518, SEND = 0x51C;
  static constexpr int LONGEST_WRITE = 1024;

  static volatile uint32_t& at(uint32_t offset) {
    return *reinterpret_cast<volatile uint32_t*>(0x40002000U + offset);
  }

  bool is_ready() const { return !busy_ || at(SENT) != 0; }

  bool busy_ = false;
};

}  // namespace exoid
