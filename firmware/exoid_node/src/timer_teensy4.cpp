#include "sampling_timer.h"

#if defined(__IMXRT1062__)

#include <Arduino.h>

#include "constants.h"
#include "tick_count.h"

namespace {

IntervalTimer timer;  // one of the processor's four, which count its 24 MHz
exoid::TickCount counted;

void tick() { counted.tick(micros()); }

}  // namespace

namespace exoid {

void SamplingTimer::begin() { timer.begin(tick, TICK_US); }

uint32_t SamplingTimer::ticks() const { return counted.count(); }

uint32_t SamplingTimer::age_us() const { return counted.age_us(micros); }

}  // namespace exoid

#endif
