#include "timer_teensy4.h"

#if defined(__IMXRT1062__)

#include <Arduino.h>

#include "constants.h"

namespace {

IntervalTimer timer;  // one of the processor's four, which count its 24 MHz
volatile uint32_t tick_count = 0;
volatile uint32_t tick_time_us = 0;

void tick() {
  tick_time_us = micros();
  tick_count = tick_count + 1;
}

}  // namespace

namespace exoid {

void SamplingTimer::begin() { timer.begin(tick, TICK_US); }

uint32_t SamplingTimer::ticks() const { return tick_count; }

uint32_t SamplingTimer::age_us() const { return micros() - tick_time_us; }

}  // namespace exoid

#endif
