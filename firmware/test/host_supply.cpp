// The measurement of the supply on a model of the SAMD21's converter.

#define ARDUINO_ARCH_SAMD
#include "supply_samd21.cpp"

#include "host_check.h"

namespace {

constexpr uint32_t SUPPLY_MV = 3300, REFERENCE_MV = 1000, COUNTS = 4096;
constexpr uint32_t AFTER_CHANGE = 100;  // counts by which the first conversion is wrong

Converter converter{};
uint32_t conversions = 0;  // since the converter was turned on
bool lit = false, is_output = false;

}  // namespace

Converter* const ADC = &converter;

void Start::operator=(uint8_t) {
  check(converter.CTRLA.reg == ADC_CTRLA_ENABLE, "it converts while it is on");
  check(converter.REFCTRL.reg == ADC_REFCTRL_REFSEL_INT1V, "against its 1 V");
  check((converter.CTRLB.reg & 0x30) == ADC_CTRLB_RESSEL_12BIT, "12 bits");
  check((converter.CTRLB.reg & 0x700) >= 0x300, "at no more than its 2.1 MHz, of 48");
  check(converter.INPUTCTRL.reg == 0x181B, "a quarter of the supply against ground, as it is");
  check(!converter.INTFLAG.bit.RESRDY.is_set, "what was converted before was read");
  const bool is_first = ++conversions == 1;
  converter.RESULT.reg.count = static_cast<uint16_t>(SUPPLY_MV / 4 * COUNTS / REFERENCE_MV +
                                                     (is_first ? AFTER_CHANGE : 0));
  converter.INTFLAG.bit.RESRDY.is_set = true;
}

Count::operator uint32_t() {
  check(converter.INTFLAG.bit.RESRDY.is_set, "a count is read once it is there");
  converter.INTFLAG.bit.RESRDY.is_set = false;
  return count;
}

void pinMode(uint8_t pin, PinMode mode) {
  is_output = pin == exoid::config::STATUS_LED_PIN && mode == OUTPUT;
}

void digitalWrite(uint8_t pin, PinStatus level) {
  lit = is_output && pin == exoid::config::STATUS_LED_PIN && level == HIGH;
}

int main() {
  exoid::Board board;
  for (int time = 0; time < 2; ++time) {
    conversions = 0;
    const uint32_t told = board.supply_mv();
    check(told <= SUPPLY_MV && told + 1 >= SUPPLY_MV, "the supply is told to 1 mV");  // a count
    check(conversions == 2, "of two conversions the first is thrown away");
    check(converter.CTRLA.reg == 0, "the converter is off again");
  }
  board.begin();
  board.light(true);
  check(lit, "the LED is on");
  board.light(false);
  check(!lit, "and off");
  return 0;
}
