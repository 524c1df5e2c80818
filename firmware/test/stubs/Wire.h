/// Arduino's I2C bus as far as it sets the SERCOM up.

#pragma once

#include "Arduino.h"

class TwoWire {
 public:
  void begin();
  void end();
  void setClock(uint32_t frequency);
};

extern TwoWire Wire;
