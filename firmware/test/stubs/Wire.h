/// Arduino's I2C bus, on which the register models of chips.h answer.

#pragma once

#include "Arduino.h"

class TwoWire {
 public:
  void begin();
  void end();
  void setClock(uint32_t frequency);
  void beginTransmission(uint8_t device);
  size_t write(uint8_t byte);
  uint8_t endTransmission(bool stop = true);
  uint8_t requestFrom(uint8_t device, size_t count);
  int read();

 private:
  uint8_t device_ = 0;
  uint8_t sent_[4] = {};
  size_t sent_count_ = 0;
  uint8_t received_[32] = {};
  size_t received_count_ = 0, taken_ = 0;
};

extern TwoWire Wire;
