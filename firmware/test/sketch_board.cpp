// The simulated board's flash, supply and status LED.

#include <cstring>

#include "board_samd21.h"
#include "flash_samd21.h"
#include "world.h"

namespace exoid {

void ProcessorFlash::read(uint8_t slot, uint8_t* bytes, uint32_t count) const {
  std::memcpy(bytes, world.slots[slot], count);
}

bool ProcessorFlash::write(uint8_t slot, const uint8_t* bytes, uint32_t count) {
  check(count <= sizeof world.slots[slot], "a write fits a page");
  world.now_us += 10000;  // the processor stands still
  if (!world.flash_works) return true;  // it says nothing of it
  std::memset(world.slots[slot], 0xFF, sizeof world.slots[slot]);
  const bool cut = world.bytes_until_cut >= 0;
  std::memcpy(world.slots[slot], bytes, cut ? static_cast<size_t>(world.bytes_until_cut) : count);
  return true;
}

void Board::begin(bool) {}

uint32_t Board::serial() { return 0xC0FFEE01; }

uint32_t Board::supply_mv() { return 3260; }

void Board::light(bool on) { world.lit = on; }

}  // namespace exoid
