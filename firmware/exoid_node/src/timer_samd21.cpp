#include "sampling_timer.h"

#if defined(ARDUINO_ARCH_SAMD)

#include <Arduino.h>

#include "constants.h"
#include "tick_count.h"

namespace {

constexpr uint32_t DIVIDER = 64;
constexpr uint32_t FREQUENCY = 1000000 / exoid::TICK_US;  // Hz
constexpr uint32_t COUNTS = VARIANT_MCK / DIVIDER / FREQUENCY;
static_assert(COUNTS <= 65536, "TC3 counts 16 bits");

exoid::TickCount counted;

void wait_for_timer() {
  while (TC3->COUNT16.STATUS.bit.SYNCBUSY) {
  }
}

/// The time that the timer has counted since the tick, whose interrupt is late while another one
/// runs or the flash is written; then micros stands still, too.
uint32_t late_us() {
  TC3->COUNT16.READREQ.reg = TC_READREQ_RREQ | TC_READREQ_ADDR(TC_COUNT16_COUNT_OFFSET);
  wait_for_timer();
  const uint32_t count = TC3->COUNT16.COUNT.reg;
  const bool is_match = count == COUNTS - 1;  // seen before the timer begins anew
  return is_match ? 0 : count * DIVIDER / (VARIANT_MCK / 1000000);
}

}  // namespace

extern "C" void TC3_Handler() {
  TC3->COUNT16.INTFLAG.reg = TC_INTFLAG_MC0;
  counted.tick(micros() - late_us());
}

namespace exoid {

void SamplingTimer::begin() {
  GCLK->CLKCTRL.reg = static_cast<uint16_t>(GCLK_CLKCTRL_CLKEN | GCLK_CLKCTRL_GEN_GCLK0 |
                                            GCLK_CLKCTRL_ID_TCC2_TC3);
  while (GCLK->STATUS.bit.SYNCBUSY) {
  }
  TC3->COUNT16.CTRLA.reg = TC_CTRLA_SWRST;
  wait_for_timer();
  while (TC3->COUNT16.CTRLA.bit.SWRST) {
  }
  TC3->COUNT16.CTRLA.reg = TC_CTRLA_MODE_COUNT16 | TC_CTRLA_WAVEGEN_MFRQ | TC_CTRLA_PRESCALER_DIV64;
  wait_for_timer();
  TC3->COUNT16.CC[0].reg = static_cast<uint16_t>(COUNTS - 1);
  wait_for_timer();
  TC3->COUNT16.INTENSET.reg = TC_INTENSET_MC0;
  NVIC_EnableIRQ(TC3_IRQn);
  TC3->COUNT16.CTRLA.reg |= TC_CTRLA_ENABLE;
  wait_for_timer();
}

uint32_t SamplingTimer::ticks() const { return counted.count(); }

uint32_t SamplingTimer::age_us() const { return counted.age_us(micros); }

}  // namespace exoid

#endif
