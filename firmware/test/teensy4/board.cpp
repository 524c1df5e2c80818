// What the stubs of the Teensy's core do to the simulated board, and it to them.

#include "board.h"

#include <Arduino.h>
#include <SPI.h>
#include <Wire.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "config.h"
#include "flexcan_teensy4.h"

volatile uint32_t HW_OCOTP_CFG0 = 1, HW_OCOTP_CFG1 = 2;
volatile uint32_t CCM_CSCMR2, CCM_CCGR0, CCM_CCGR5, SRC_SRSR;
Told WDOG3_CNT, WDOG3_CS, WDOG3_WIN, WDOG3_TOVAL;
TwoWire Wire;
SPIClass SPI;

namespace teensy {

Board board;

void Board::begin_timer(void (*call)(), uint32_t period_us) {
  tick_ = call;
  period_us_ = period_us;
  due_us_ = now_us + period_us;
}

void Board::advance() {
  can.advance();
  while (tick_ != nullptr && now_us >= due_us_) {
    const uint64_t late_us = now_us;
    now_us = due_us_;  // the interrupt comes when it is due
    due_us_ += period_us_;
    ++ticks;
    chips.expose(leg(ticks));
    tick_();
    now_us = late_us;
  }
}

void Board::watchdog(uint32_t value) {
  if (value != 0xB480A602) return;
  fed_us = std::max(fed_us, now_us - fed_last_us);
  fed_last_us = now_us;
}

void Board::violated(const char* sentence) {
  std::fprintf(stderr, "it does not hold that %s\n", sentence);
  std::exit(1);
}

}  // namespace teensy

using teensy::board;

namespace {

constexpr uint64_t BYTE_US = 23;       // of I2C at 400 kHz
constexpr uint64_t NOT_IDLE_US = 16000;  // for which Wire waits for a bus that is not free
constexpr uint64_t STUCK_US = 50000;     // for which it waits within a transfer

uint8_t addressed = 0, sent[32], received[32];
size_t sent_count = 0, received_count = 0, received_at = 0;
bool begun = false, clock_low = false;

bool is_free() { return !board.clock_held && board.pulses_to_free == 0; }

/// Whether a transfer can begin; Wire waits for it.
bool waits_for_idle() {
  if (is_free()) return true;
  board.now_us += NOT_IDLE_US;
  board.held_us += NOT_IDLE_US;
  return false;
}

bool is_there(uint8_t device) {
  uint8_t byte = 0;
  return board.chips.read(device, 0, &byte, 0);
}

}  // namespace

void Told::operator=(uint32_t given) {
  value = given;
  if (this == &WDOG3_CNT) board.watchdog(given);
}

void pinMode(uint8_t pin, uint8_t mode) {
  if (pin != PIN_WIRE_SCL) return;
  if (mode == OUTPUT) clock_low = true;
  if (mode != OUTPUT && clock_low) {
    clock_low = false;
    if (board.pulses_to_free > 0) --board.pulses_to_free;
  }
}

void digitalWrite(uint8_t pin, uint8_t level) {
  if (pin == exoid::config::STATUS_LED_PIN) return;
  if (level != LOW) board.violated("the sketch never drives an I2C line high");
}

uint8_t digitalRead(uint8_t pin) {
  board.now_us += 1;
  const bool low = pin == PIN_WIRE_SCL ? board.clock_held : board.pulses_to_free > 0;
  return low ? LOW : HIGH;
}

void delayMicroseconds(uint32_t time) { board.now_us += time; }
uint32_t micros() {
  ++board.now_us;
  board.advance();
  return static_cast<uint32_t>(board.now_us);
}

uint32_t millis() {
  board.advance();
  return static_cast<uint32_t>(board.now_us / 1000);
}

void __disable_irq() {}
void __enable_irq() {}
bool IntervalTimer::begin(void (*call)(), uint32_t period_us) {
  board.begin_timer(call, period_us);
  return true;
}

void TwoWire::begin() { begun = true; }

void TwoWire::setClock(uint32_t frequency) {
  if (frequency != 400000) board.violated("the I2C bus runs at 400 kHz");
}

void TwoWire::beginTransmission(uint8_t address) {
  addressed = address;
  sent_count = 0;
}

size_t TwoWire::write(const uint8_t* bytes, size_t count) {
  const size_t taken = std::min(count, sizeof sent - sent_count);
  std::copy(bytes, bytes + taken, sent + sent_count);
  sent_count += taken;
  return taken;
}

uint8_t TwoWire::endTransmission(uint8_t stops) {
  if (!begun || !waits_for_idle()) return 4;
  board.now_us += BYTE_US * (1 + sent_count);
  if (!is_there(addressed)) return 2;
  if (stops != 0 && sent_count == 2) board.chips.write(addressed, sent[0], sent[1]);
  return 0;
}

uint8_t TwoWire::requestFrom(uint8_t address, uint8_t count, uint8_t) {
  if (!waits_for_idle()) return 4;
  received_count = received_at = 0;
  if (board.holds_read) {
    board.clock_held = true;
    board.holds_read = false;
    board.now_us += STUCK_US;
    return 0;
  }
  if (board.refuses_read > 0 && --board.refuses_read == 0) return 0;
  board.now_us += BYTE_US * (1U + count);
  if (!board.chips.read(address, sent[0], received, count)) return 0;
  received_count = count;
  return count;
}

int TwoWire::available() { return static_cast<int>(received_count - received_at); }

int TwoWire::read() { return received_at < received_count ? received[received_at++] : -1; }

namespace exoid {

void FlexCanRegisters::begin() { board.can.begin(); }
uint32_t FlexCanRegisters::read(uint32_t offset) { return board.can.read(offset); }
void FlexCanRegisters::write(uint32_t offset, uint32_t value) { board.can.write(offset, value); }

}  // namespace exoid
