// The settings' flash on a model of the SAMD21's controller: what is written reaches the flash by
// commands alone, and a page that was not erased takes only zeros.

#define ARDUINO_ARCH_SAMD

#include <Arduino.h>

#include <cstdint>
#include <cstring>

#define const  // so that the rows lie in memory that can be written
#include "flash_samd21.cpp"
#undef const

#include "host_check.h"

namespace {

FlashController controller;
uint8_t kept[sizeof rows];  // what the flash holds; `rows` is the page buffer over it
uint32_t erased = 0;

uint8_t* row_of(uint32_t address) {
  const auto begin = static_cast<uint32_t>(reinterpret_cast<uintptr_t>(rows) / 2);
  check((address - begin) % 128 == 0 && address - begin < 256, "a row's half address is given");
  return kept + 2 * (address - begin);
}

}  // namespace

FlashController* const NVMCTRL = &controller;

void FlashCommand::operator=(uint16_t command) {
  check((command & 0xFF00) == NVMCTRL_CTRLA_CMDEX_KEY, "every command has the key");
  check(controller.CTRLB.bit.CACHEDIS, "no command is given while the cache is on");
  uint8_t* row = row_of(controller.ADDR.reg);
  uint8_t* buffer = reinterpret_cast<uint8_t*>(rows) + (row - kept);
  switch (command & 0xFF) {
    case NVMCTRL_CTRLA_CMD_ER:
      std::memset(row, 0xFF, 256);
      std::memset(buffer, 0xFF, 256);
      ++erased;
      return;
    case NVMCTRL_CTRLA_CMD_PBC: return;
    case NVMCTRL_CTRLA_CMD_WP:
      check(controller.CTRLB.bit.MANW, "pages are written by command");
      for (int at = 0; at < 64; ++at) row[at] &= buffer[at];
      std::memcpy(buffer, row, 256);
      return;
    default: check((command & 0xFF) == NVMCTRL_CTRLA_CMD_INVALL, "no other command is given");
  }
}

int main() {
  controller.INTFLAG.bit.READY = true;
  exoid::ProcessorFlash flash;
  uint8_t first[11], second[10], read[11];
  for (uint8_t at = 0; at < 11; ++at) first[at] = static_cast<uint8_t>(3 * at + 1);
  for (uint8_t at = 0; at < 10; ++at) second[at] = static_cast<uint8_t>(200 - at);
  check(flash.write(0, first, 11) && flash.write(1, second, 10), "both slots are written");
  flash.read(0, read, 11);
  check(std::memcmp(read, first, 11) == 0, "the first slot holds all its bytes, a part word too");
  flash.read(1, read, 10);
  check(std::memcmp(read, second, 10) == 0, "the second slot is another one");
  check(!controller.CTRLB.bit.CACHEDIS, "the program has its cache again");
  check(kept[11] == 0xFF, "what was not written is left erased");
  check(flash.write(0, second, 10), "a slot is written again");
  flash.read(0, read, 10);
  check(std::memcmp(read, second, 10) == 0 && erased == 3, "after it was erased");
  check(!flash.write(0, first, 65) && erased == 3, "more than a page is refused");
  return 0;
}
