/// The SPI bus of an encoder on Arduino's SPI, beside the MCP2515: with a chip select of its own.

#pragma once

#include <Arduino.h>
#include <SPI.h>

#include "config.h"

namespace exoid {

class EncoderLink {
 public:
  void begin() {
    SPI.begin();
    digitalWrite(config::ENCODER_SELECT_PIN, HIGH);
    pinMode(config::ENCODER_SELECT_PIN, OUTPUT);
  }

  /// One frame: sends a word and returns what came back meanwhile.
  uint16_t exchange(uint16_t word) {
    SPI.beginTransaction(SPISettings(FREQUENCY, MSBFIRST, SPI_MODE1));
    digitalWrite(config::ENCODER_SELECT_PIN, LOW);
    delayMicroseconds(SETTLE_US);
    const uint8_t high = SPI.transfer(static_cast<uint8_t>(word >> 8));
    const uint8_t low = SPI.transfer(static_cast<uint8_t>(word));
    digitalWrite(config::ENCODER_SELECT_PIN, HIGH);
    delayMicroseconds(SETTLE_US);
    SPI.endTransaction();
    return static_cast<uint16_t>(high << 8 | low);
  }

 private:
  static constexpr uint32_t FREQUENCY = 8000000;  // Hz; the chips bear 10 MHz
  static constexpr uint32_t SETTLE_US = 1;        // the chips want 350 ns around a frame
};

}  // namespace exoid
