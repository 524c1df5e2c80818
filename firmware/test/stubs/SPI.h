/// Arduino's SPI bus, with an MCP2515 on it.

#pragma once

#include "Arduino.h"

constexpr uint8_t MSBFIRST = 1, SPI_MODE0 = 0;

struct SPISettings {
  SPISettings(uint32_t clock, uint8_t, uint8_t) : frequency(clock) {}
  const uint32_t frequency;
};

class SPIClass {
 public:
  void begin() {}
  void beginTransaction(const SPISettings& settings);
  uint8_t transfer(uint8_t byte);
  void endTransaction() {}
};

extern SPIClass SPI;
