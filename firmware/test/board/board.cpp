// What the stubs of Arduino's libraries do to the simulated board, and it to them.

#include "board.h"

#include <Arduino.h>
#include <SPI.h>
#include <Wire.h>

#include "constants.h"
#include "sampling_timer.h"
#include "sinks.h"

UsbSerial Serial;
TwoWire Wire;
SPIClass SPI;
GenericClock generic_clock;
Sercom4 sercom4;
WatchdogTimer watchdog_timer;
UsbRegisters usb_registers;
PowerManager power_manager;

namespace simulated {

Board board;

void Board::begin_timer() {
  timer_stands = false;
  ticks = 0;
  begin_us = ticked_us = now_us;
  due_us_ = now_us + exoid::TICK_US;
}

void Board::advance() {
  can.advance();
  while (!timer_stands && due_us_ != 0 && now_us >= due_us_) {
    ticked_us = due_us_;
    due_us_ += exoid::TICK_US;
    ++ticks;
    const chips::Exposure now = exposed_to(ticks);
    chips.expose(now);
    encoder.expose(now);
  }
}

uint32_t read(Where where, uint8_t at) {
  switch (where) {
    case IN_SERCOM: return board.i2c.read(static_cast<SercomRegister>(at));
    case IN_USB: return board.usb.is_full() ? USB_DEVICE_EPSTATUS_BK1RDY : 0;
    case IN_WATCHDOG_STATUS:
      board.now_us += 1;
      return board.watchdog.is_busy();
    case IN_RESET_CAUSE: return board.reset_cause;
    default: return 0;
  }
}

void write(Where where, uint8_t at, uint32_t value) {
  switch (where) {
    case IN_SERCOM: board.i2c.write(static_cast<SercomRegister>(at), value); break;
    case IN_USB_CLEAR:
      if ((value & USB_DEVICE_EPSTATUSCLR_BK1RDY) != 0) board.usb.withdraw();
      break;
    case IN_WATCHDOG_CONTROL: board.watchdog.enable((value & WDT_CTRL_ENABLE) != 0); break;
    case IN_WATCHDOG_CLEAR: board.watchdog.feed(static_cast<uint8_t>(value)); break;
    case IN_CLOCK_CONTROL: {
      const uint32_t slow = GCLK_CLKCTRL_CLKEN | GCLK_CLKCTRL_GEN_GCLK1 |
                            GCLK_CLKCTRL_ID_SERCOMX_SLOW;
      if (value == slow) board.i2c.slow_clock = true;
      break;
    }
    default: break;
  }
}

}  // namespace simulated

using simulated::board;
using simulated::violated;

void pinMode(uint8_t pin, PinMode mode) {
  const bool pulled = mode == OUTPUT;
  if (pin == PIN_WIRE_SCL) board.i2c.pull_clock(pulled);
  if (pin == PIN_WIRE_SDA) board.i2c.pull_data(pulled);
}

void digitalWrite(uint8_t pin, PinStatus level) {
  if (pin == CAN_SELECT) {
    if (board.encoder.mode() != SPI_MODE0) violated("the MCP2515 does SPI mode 0");
    return level == LOW ? board.can.select() : board.can.deselect();
  }
  if (pin == ENCODER_SELECT) {
    return level == LOW ? board.encoder.select() : board.encoder.deselect();
  }
  if (level != LOW) violated("the sketch never drives an I2C line high");
}

PinStatus digitalRead(uint8_t pin) {
  board.now_us += 1;
  return (pin == PIN_WIRE_SDA ? board.i2c.data_is_low() : board.i2c.clock_is_low()) ? LOW : HIGH;
}

void delayMicroseconds(uint32_t time) { board.now_us += time; }

uint32_t micros() { return static_cast<uint32_t>(++board.now_us); }

uint32_t millis() { return static_cast<uint32_t>(board.now_us / 1000); }

void TwoWire::begin() { board.i2c.set_up(100000); }

void TwoWire::end() { board.i2c.disable(); }

void TwoWire::setClock(uint32_t frequency) {
  if (frequency != 400000) simulated::violated("the I2C bus runs at 400 kHz");
  board.i2c.set_up(frequency);
}

void SPIClass::beginTransaction(const SPISettings& settings) {
  // The core divides 48 MHz by an even number, rounded towards the faster side.
  const uint32_t made = 24000000 / (24000000 / settings.frequency);
  if (made > 10000000) simulated::violated("the SPI bus is no faster than the MCP2515's 10 MHz");
  board.encoder.set_mode(settings.mode);
}

uint8_t SPIClass::transfer(uint8_t byte) {
  return board.encoder.is_selected() ? board.encoder.transfer(byte) : board.can.transfer(byte);
}

int UsbSerial::available() { return board.usb.available(); }

int UsbSerial::read() { return board.usb.read(); }

bool UsbSerial::dtr() { return board.usb.is_held(); }

size_t UsbSerial::write(const uint8_t* bytes, size_t count) {
  return board.usb.write(bytes, count);
}

namespace exoid {

void SamplingTimer::begin() { board.begin_timer(); }

uint32_t SamplingTimer::ticks() const {
  board.advance();
  return board.ticks;
}

uint32_t SamplingTimer::age_us() const {
  return static_cast<uint32_t>(board.now_us - board.ticked_us);
}

}  // namespace exoid
