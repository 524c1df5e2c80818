/// Arduino's SPI bus, with an MCP2515 and an encoder on it.

#pragma once

#include "Arduino.h"

constexpr uint8_t MSBFIRST = 1, SPI_MODE0 = 0, SPI_MODE1 = 1;

struct SPISettings {
  SPISettings(uint32_t clock, uint8_t, uint8_t edges) : frequency(clock), mode(edges) {}
  const uint32_t frequency;
  const uint8_t mode;
};

class SPIClass {
 public:
  void begin() {}
  void beginTransaction(const SPISettings& settings);
  uint8_t transfer(uint8_t byte);
  void endTransaction() {}
};

extern SPIClass SPI;
