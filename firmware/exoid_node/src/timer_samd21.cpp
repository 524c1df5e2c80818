#include "timer_samd21.h"

#if defined(ARDUINO_ARCH_SAMD)

#include <Arduino.h>

#include "constants.h"

namespace {

constexpr uint32_t DIVIDER = 64;
constexpr uint32_t FREQUENCY = 1000000 / exoid::TICK_US;  // Hz
constexpr uint32_t COUNTS = VARIANT_MCK / DIVIDER / FREQUENCY;
static_assert(COUNTS <= 65536, "TC3 counts 16 bits");

volatile uint32_t tick_count = 0;
volatile uint32_t tick_time_us = 0;

void wait_for_timer() {
  while (TC3->COUNT16.STATUS.bit.SYNCBUSY) {
  }
}

}  // namespace

extern "C" void TC3_Handler() {
  TC3->COUNT16.INTFLAG.reg = TC_INTFLAG_MC0;
  tick_time_us = micros();
  tick_count = tick_count + 1;
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

uint32_t SamplingTimer::ticks() const { return tick_count; }

uint32_t SamplingTimer::age_us() const { return micros() - tick_time_us; }

}  // namespace exoid

#endif
