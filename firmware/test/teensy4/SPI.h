/// The Teensy's SPI bus, on which nothing hangs.

#pragma once

#include "Arduino.h"

#define MSBFIRST 1
#define SPI_MODE1 4

struct SPISettings {
  SPISettings(uint32_t, uint8_t, uint8_t) {}
};

class SPIClass {
 public:
  void begin() {}
  void beginTransaction(const SPISettings&) {}
  uint8_t transfer(uint8_t byte) { return byte; }
  void endTransaction() {}
};

extern SPIClass SPI;
