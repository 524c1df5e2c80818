#include "watchdog_teensy4.h"

#if defined(__IMXRT1062__)

#include <Arduino.h>

namespace {

// IMXRT1060RM 58.5.1.1, page 3205 (WDOG3, which counts 32.768 kHz), and 21.8, page 1284 (SRC); the words
// as in WDT_T4.
constexpr uint32_t UNLOCK = 0xD928C520, REFRESH = 0xB480A602;
constexpr uint32_t LOW_POWER_OSCILLATOR = 1;
constexpr uint32_t LONGEST = 4096;  // counts: 125 ms

}  // namespace

namespace exoid {

void Watchdog::begin() {
  has_reset_ = (SRC_SRSR & SRC_SRSR_WDOG3_RST_B) != 0;
  SRC_SRSR = SRC_SRSR_WDOG3_RST_B;  // writing 1 clears it
  CCM_CCGR5 |= CCM_CCGR5_WDOG3(CCM_CCGR_ON);
  __disable_irq();  // it must be set within 255 clocks of the bus
  WDOG3_CNT = UNLOCK;
  WDOG3_WIN = 0;
  WDOG3_TOVAL = LONGEST;
  WDOG3_CS = WDOG_CS_EN | WDOG_CS_CLK(LOW_POWER_OSCILLATOR) | WDOG_CS_CMD32EN | WDOG_CS_UPDATE;
  __enable_irq();
}

void Watchdog::feed() { WDOG3_CNT = REFRESH; }

}  // namespace exoid

#endif
