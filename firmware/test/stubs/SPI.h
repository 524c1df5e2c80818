/// Arduino's SPI bus, with an MCP2515 and an encoder on it.

#pragma once

#include "Arduino.h"

enum BitOrder { LSBFIRST, MSBFIRST };
enum SPIMode : uint8_t { SPI_MODE0, SPI_MODE1 };

struct SPISettings {
  SPISettings(uint32_t clock, BitOrder, SPIMode edges) : frequency(clock), mode(edges) {}
  const uint32_t frequency;
  const SPIMode mode;
};

class SPIClass {
 public:
  void begin() {}
  void beginTransaction(const SPISettings& settings);
  uint8_t transfer(uint8_t byte);
  void endTransaction() {}
};

extern SPIClass SPI;
