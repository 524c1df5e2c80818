// The simulated board's flash, serial number, supply and status LED.

#include "board.h"
#include "flash_samd21.h"
#include "sinks.h"
#include "supply_samd21.h"

using simulated::board;

namespace exoid {

void ProcessorFlash::read(uint8_t slot, uint8_t* bytes, uint32_t count) const {
  for (uint32_t at = 0; at < count; ++at) bytes[at] = board.flash.slots[slot][at];
}

bool ProcessorFlash::write(uint8_t slot, const uint8_t* bytes, uint32_t count) {
  constexpr uint32_t PAGE = sizeof board.flash.slots[slot], LONGEST_WRITE_US = 10000;
  if (count > PAGE) simulated::violated("a write fits a page");
  board.now_us += LONGEST_WRITE_US;  // the processor stands still
  if (!board.flash.works) return true;
  for (uint32_t at = 0; at < PAGE; ++at) {
    board.flash.slots[slot][at] = at < count ? bytes[at] : 0xFF;
  }
  return true;
}

void Board::begin() {}

uint32_t Board::serial() { return 0xC0FFEE01; }

uint32_t Board::supply_mv() { return 3260; }

void Board::light(bool on) { board.lit = on; }

}  // namespace exoid
