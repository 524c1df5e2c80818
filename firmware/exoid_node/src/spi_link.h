/// The MCP2515's SPI bus on Arduino's SPI.

#pragma once

#include <Arduino.h>
#include <SPI.h>

#include "config.h"

namespace exoid {

class SpiLink {
 public:
  void begin() {
    SPI.begin();
    digitalWrite(config::CAN_SELECT_PIN, HIGH);
    pinMode(config::CAN_SELECT_PIN, OUTPUT);
  }

  /// One command: sends the bytes and puts what came back in their place.
  void exchange(uint8_t* bytes, uint8_t count) {
    SPI.beginTransaction(SPISettings(FREQUENCY, MSBFIRST, SPI_MODE0));
    digitalWrite(config::CAN_SELECT_PIN, LOW);
    for (uint8_t at = 0; at < count; ++at) bytes[at] = SPI.transfer(bytes[at]);
    digitalWrite(config::CAN_SELECT_PIN, HIGH);
    SPI.endTransaction();
  }

 private:
  // The chip bears 10 MHz. The board divides 48 MHz by an even number, and makes 12 MHz of 10.
  static constexpr uint32_t FREQUENCY = 8000000;  // Hz
};

}  // namespace exoid
