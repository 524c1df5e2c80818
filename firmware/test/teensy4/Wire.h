/// The Teensy's I2C bus: nothing is sent before endTransmission or requestFrom.

#pragma once

#include "Arduino.h"

class TwoWire {
 public:
  void begin();
  void end() {}
  void setClock(uint32_t frequency);
  void beginTransmission(uint8_t address);
  size_t write(const uint8_t* bytes, size_t count);
  uint8_t endTransmission(uint8_t stops = 1);
  uint8_t requestFrom(uint8_t address, uint8_t count, uint8_t stops);
  int available();
  int read();
};

extern TwoWire Wire;
