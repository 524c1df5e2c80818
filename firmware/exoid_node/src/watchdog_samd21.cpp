#include "watchdog_samd21.h"

#if defined(ARDUINO_ARCH_SAMD)

#include <Arduino.h>

namespace {

constexpr uint32_t GENERATOR = 2;  // the core uses 0, 1 and 3
constexpr uint32_t DIVIDER = 4;    // 2^(4 + 1): 32 kHz become 1 kHz
constexpr uint8_t KEY = 0xA5;

void wait_for_clock() {
  while (GCLK->STATUS.bit.SYNCBUSY) {
  }
}

void wait_for_watchdog() {
  while (WDT->STATUS.bit.SYNCBUSY) {
  }
}

}  // namespace

namespace exoid {

void Watchdog::begin() {
  GCLK->GENDIV.reg = GCLK_GENDIV_ID(GENERATOR) | GCLK_GENDIV_DIV(DIVIDER);
  wait_for_clock();
  GCLK->GENCTRL.reg = GCLK_GENCTRL_ID(GENERATOR) | GCLK_GENCTRL_SRC_OSCULP32K |
                      GCLK_GENCTRL_GENEN | GCLK_GENCTRL_DIVSEL;
  wait_for_clock();
  GCLK->CLKCTRL.reg =
      static_cast<uint16_t>(GCLK_CLKCTRL_CLKEN | GCLK_CLKCTRL_GEN_GCLK2 | GCLK_CLKCTRL_ID_WDT);
  wait_for_clock();
  WDT->CONFIG.reg = WDT_CONFIG_PER_128;
  wait_for_watchdog();
  WDT->CTRL.reg = WDT_CTRL_ENABLE;
  wait_for_watchdog();
}

void Watchdog::feed() {
  // A write while the last one is still on its way would stop the processor for milliseconds.
  if (!WDT->STATUS.bit.SYNCBUSY) WDT->CLEAR.reg = KEY;
}

bool Watchdog::has_reset() const { return (PM->RCAUSE.reg & PM_RCAUSE_WDT) != 0; }

bool Watchdog::supply_dipped() const {
  return (PM->RCAUSE.reg & (PM_RCAUSE_BOD12 | PM_RCAUSE_BOD33)) != 0;
}

}  // namespace exoid

#endif
