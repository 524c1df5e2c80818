/// Flash and board of the emulated node, as files of the machine that runs the emulator.

#pragma once

#include <stdint.h>

#include "semihosting.h"

namespace exoid {

/// Each slot is a file, which must be there; it outlives the emulator.
class HostFlash {
 public:
  void read(uint8_t slot, uint8_t* bytes, uint32_t count) const {
    semihosting::File file(name(slot), LENGTH, semihosting::READ_BINARY);
    if (file.read(bytes, count)) return;
    for (uint32_t at = 0; at < count; ++at) bytes[at] = ERASED;
  }

  bool write(uint8_t slot, const uint8_t* bytes, uint32_t count) {
    semihosting::File file(name(slot), LENGTH, semihosting::WRITE_BINARY);
    return file.write(bytes, count);
  }

 private:
  static constexpr uint32_t LENGTH = 9;
  static constexpr uint8_t ERASED = 0xFF;

  static const char* name(uint8_t slot) {
    static const char* const names[] = {"slot0.bin", "slot1.bin", "slot2.bin"};
    return names[slot];
  }
};

class HostBoard {
 public:
  static void begin() {}

  static uint32_t serial() {
    semihosting::File file("board.bin", 9, semihosting::READ_BINARY);
    uint32_t number = 0;
    if (!file.read(&number, sizeof number)) semihosting::exit(97);
    return number;
  }

  static uint32_t supply_mv() { return 3300; }

  static void light(bool) {}
};

}  // namespace exoid
