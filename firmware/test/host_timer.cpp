// The sampling timer on registers that are memory: what it sets, and how it counts.

#define ARDUINO_ARCH_SAMD
#include "timer_samd21.cpp"

#include <cstdio>
#include <cstdlib>

namespace {

GenericClock clock_registers;
TimerCounter timer_registers;
bool enabled = false;
uint32_t now_us = 4294967000U;  // shortly before it wraps

void check(bool holds, const char* sentence) {
  if (holds) return;
  std::fprintf(stderr, "it does not hold that %s\n", sentence);
  std::exit(1);
}

}  // namespace

GenericClock* const GCLK = &clock_registers;
TimerCounter* const TC3 = &timer_registers;

void NVIC_EnableIRQ(Interrupt number) { enabled = number == TC3_IRQn; }

uint32_t micros() { return now_us; }

int main() {
  exoid::SamplingTimer timer;
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
  return 0;
}
