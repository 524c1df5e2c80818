// The sampling timer on registers that are memory: what it sets, and how it counts.

#define ARDUINO_ARCH_SAMD
#include "timer_samd21.cpp"

#include "host_check.h"

namespace {

GenericClock clock_registers{};
TimerCounter timer_registers{};
bool enabled = false;
uint32_t now_us = 4294967000U;  // shortly before it wraps
uint32_t count = 0;             // by the timer since its last match
bool ticks_meanwhile = false;   // while the time is looked at for the next time

}  // namespace

GenericClock* const GCLK = &clock_registers;
TimerCounter* const TC3 = &timer_registers;

void NVIC_EnableIRQ(Interrupt number) { enabled = number == TC3_IRQn; }

void Requested::operator=(uint16_t request) {
  check(request == 0x8010, "the count is asked for");
  timer_registers.COUNT16.COUNT.reg = count;
}

uint32_t micros() {
  const uint32_t told = now_us;
  if (ticks_meanwhile) {
    ticks_meanwhile = false;
    now_us += 3;
    TC3_Handler();
  }
  return told;
}

namespace {

void begins_and_counts(exoid::SamplingTimer& timer) {
  timer.begin();
  const auto& registers = timer_registers.COUNT16;
  check(enabled && registers.INTENSET.reg == TC_INTENSET_MC0, "a match interrupts");
  check((registers.CTRLA.reg & TC_CTRLA_ENABLE) != 0, "the timer runs");
  check((registers.CTRLA.reg & TC_CTRLA_PRESCALER_DIV64) == TC_CTRLA_PRESCALER_DIV64, "it divides");
  check((registers.CC[0].reg + 1) * 64 * 100 == VARIANT_MCK, "it ticks a hundred times a second");
  check(timer.ticks() == 0, "it has not ticked yet");
  TC3_Handler();
  now_us += 900;
  check(timer.ticks() == 1 && timer.age_us() == 900, "it tells ticks and the time since the last");
  check(registers.INTFLAG.reg == TC_INTFLAG_MC0, "an interrupt is acknowledged");
}

/// As while the flash is written, where micros stands still, too.
void tells_how_late_an_interrupt_is(const exoid::SamplingTimer& timer) {
  count = 3000;  // of 750 a ms
  TC3_Handler();
  check(timer.age_us() == 4000, "a tick is as old as the timer says, and not its interrupt");
  count = 7499;
  TC3_Handler();
  check(timer.age_us() == 0, "an interrupt that comes within the count of its match is not late");
  count = 0;
}

void tells_one_time_of_one_tick(const exoid::SamplingTimer& timer) {
  const uint32_t before = timer.ticks();
  now_us += 9999;
  ticks_meanwhile = true;
  check(timer.age_us() == 0, "a tick that comes while the time is looked at gives no age between");
  check(timer.ticks() == before + 1, "and counts");
}

}  // namespace

int main() {
  exoid::SamplingTimer timer;
  begins_and_counts(timer);
  tells_how_late_an_interrupt_is(timer);
  tells_one_time_of_one_tick(timer);
  return 0;
}
