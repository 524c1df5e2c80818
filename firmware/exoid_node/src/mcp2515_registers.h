/// The registers of an MCP2515, by the commands of its SPI.

#pragma once

#include <stdint.h>

namespace exoid {

/// `Spi` has `exchange(bytes, count)`, which sends bytes and puts in their place what came back.
template <class Spi>
class Mcp2515Registers {
 public:
  static constexpr uint8_t WRITE = 0x02, READ = 0x03;

  explicit Mcp2515Registers(Spi& spi) : spi_(spi) {}

  void reset() {
    uint8_t bytes[] = {RESET};
    spi_.exchange(bytes, sizeof bytes);
  }

  /// Which buffers are full.
  uint8_t status() {
    uint8_t bytes[] = {READ_STATUS, 0};
    spi_.exchange(bytes, sizeof bytes);
    return bytes[1];
  }

  uint8_t read(uint8_t from) {
    uint8_t bytes[] = {READ, from, 0};
    spi_.exchange(bytes, sizeof bytes);
    return bytes[2];
  }

  void write(uint8_t to, uint8_t value) {
    uint8_t bytes[] = {WRITE, to, value};
    spi_.exchange(bytes, sizeof bytes);
  }

  /// Writes a standard identifier, or a mask of one.
  void write_id(uint8_t to, uint16_t id) {
    const uint8_t high = static_cast<uint8_t>(id >> 3), low = static_cast<uint8_t>(id << 5);
    uint8_t bytes[] = {WRITE, to, high, low, 0, 0};
    spi_.exchange(bytes, sizeof bytes);
  }

 private:
  static constexpr uint8_t RESET = 0xC0, READ_STATUS = 0xA0;

  Spi& spi_;
};

}  // namespace exoid
