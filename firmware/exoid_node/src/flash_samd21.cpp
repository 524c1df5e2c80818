#include "flash_samd21.h"

#if defined(ARDUINO_ARCH_SAMD)

#include <Arduino.h>

namespace {

constexpr uint32_t SLOTS = 3;
constexpr uint32_t ROW = 256;  // bytes: what is erased at once
constexpr uint32_t PAGE = 64;  // bytes: what is written at once

// In flash, among the program's constants, so that no other part of the program lies there.
alignas(ROW) const uint8_t rows[SLOTS][ROW] = {};

// Read as volatile: the program never assigns what changes here.
volatile uint8_t* begin_of(uint8_t slot) {
  return const_cast<volatile uint8_t*>(rows[slot % SLOTS]);
}

void wait_for_flash() {
  while (NVMCTRL->INTFLAG.bit.READY == 0) {
  }
}

void command(uint32_t what) {
  NVMCTRL->CTRLA.reg = static_cast<uint16_t>(NVMCTRL_CTRLA_CMDEX_KEY | what);
  wait_for_flash();
}

}  // namespace

namespace exoid {

void ProcessorFlash::read(uint8_t slot, uint8_t* bytes, uint32_t count) const {
  const volatile uint8_t* from = begin_of(slot);
  for (uint32_t at = 0; at < count && at < ROW; ++at) bytes[at] = from[at];
}

bool ProcessorFlash::write(uint8_t slot, const uint8_t* bytes, uint32_t count) {
  if (count > PAGE) return false;
  volatile uint8_t* to = begin_of(slot);
  wait_for_flash();
  // Erratum 10804: a command may fault a processor whose cache is on.
  NVMCTRL->CTRLB.bit.CACHEDIS = 1;
  NVMCTRL->CTRLB.bit.MANW = 1;  // a page is written by the command, not by its last word
  NVMCTRL->ADDR.reg = static_cast<uint32_t>(reinterpret_cast<uintptr_t>(to) / 2);
  command(NVMCTRL_CTRLA_CMD_ER);
  command(NVMCTRL_CTRLA_CMD_PBC);
  // The page buffer takes 16 or 32 bits at a time.
  for (uint32_t at = 0; at < count; at += 4) {
    uint32_t word = 0xFFFFFFFF;
    for (uint32_t byte = 0; byte < 4 && at + byte < count; ++byte) {
      word &= ~(0xFFU << (8 * byte));
      word |= static_cast<uint32_t>(bytes[at + byte]) << (8 * byte);
    }
    *reinterpret_cast<volatile uint32_t*>(to + at) = word;
  }
  command(NVMCTRL_CTRLA_CMD_WP);
  command(NVMCTRL_CTRLA_CMD_INVALL);  // what is read back then comes from the flash
  NVMCTRL->CTRLB.bit.CACHEDIS = 0;
  return true;
}

}  // namespace exoid

#endif
