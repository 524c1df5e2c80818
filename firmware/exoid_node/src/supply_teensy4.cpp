#include "supply_teensy4.h"

#if defined(__IMXRT1062__)

#include <Arduino.h>

#include "config.h"

namespace exoid {

void Board::begin() { pinMode(config::STATUS_LED_PIN, OUTPUT); }

uint32_t Board::serial() {
  constexpr uint32_t ODD = 2654435761U;  // spreads the bits of what differs least
  const uint32_t number = HW_OCOTP_CFG0 ^ HW_OCOTP_CFG1 * ODD;
  return number == 0 ? 1 : number;
}

void Board::light(bool on) { digitalWrite(config::STATUS_LED_PIN, on ? HIGH : LOW); }

}  // namespace exoid

#endif
