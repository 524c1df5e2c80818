#include "supply_samd21.h"

#if defined(ARDUINO_ARCH_SAMD)

#include <Arduino.h>

#include "config.h"

namespace {

constexpr uint32_t SERIAL_WORDS[] = {0x0080A00C, 0x0080A040, 0x0080A044, 0x0080A048};

void wait_for_adc() {
  while (ADC->STATUS.bit.SYNCBUSY) {
  }
}

uint32_t convert() {
  ADC->SWTRIG.bit.START = 1;
  wait_for_adc();
  while (ADC->INTFLAG.bit.RESRDY == 0) {
  }
  return ADC->RESULT.reg;
}

}  // namespace

namespace exoid {

void Board::begin() { pinMode(config::STATUS_LED_PIN, OUTPUT); }

uint32_t Board::serial() {
  constexpr uint32_t BASIS = 2166136261U, PRIME = 16777619U;  // FNV-1a
  uint32_t hash = BASIS;
  for (uint32_t address : SERIAL_WORDS) {
    const uint32_t word = *reinterpret_cast<const volatile uint32_t*>(address);
    for (uint32_t byte = 0; byte < 4; ++byte) hash = (hash ^ ((word >> 8 * byte) & 0xFFU)) * PRIME;
  }
  return hash == 0 ? 1 : hash;
}

uint32_t Board::supply_mv() {
  constexpr uint32_t REFERENCE_MV = 1000, PART = 4, COUNTS = 4096;  // a quarter against 1 V
  wait_for_adc();
  ADC->REFCTRL.reg = ADC_REFCTRL_REFSEL_INT1V;
  ADC->CTRLB.reg = ADC_CTRLB_PRESCALER_DIV64 | ADC_CTRLB_RESSEL_12BIT;
  wait_for_adc();
  ADC->INPUTCTRL.reg =
      ADC_INPUTCTRL_GAIN_1X | ADC_INPUTCTRL_MUXNEG_GND | ADC_INPUTCTRL_MUXPOS_SCALEDIOVCC;
  wait_for_adc();
  ADC->CTRLA.reg = ADC_CTRLA_ENABLE;
  wait_for_adc();
  convert();  // the first one after a change of the reference is to be thrown away
  const uint32_t count = convert();
  ADC->CTRLA.reg = 0;
  wait_for_adc();
  return count * REFERENCE_MV * PART / COUNTS;
}

void Board::light(bool on) {
  digitalWrite(config::STATUS_LED_PIN, on ? HIGH : LOW);
}

}  // namespace exoid

#endif
