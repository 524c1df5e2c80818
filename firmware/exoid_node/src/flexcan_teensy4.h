/// The registers of CAN1 of a Teensy 4: its pins 22 (TX) and 23 (RX).

#pragma once

#include <stdint.h>

namespace exoid {

class FlexCanRegisters {
 public:
  void begin();
  uint32_t read(uint32_t offset);
  void write(uint32_t offset, uint32_t value);
};

}  // namespace exoid
