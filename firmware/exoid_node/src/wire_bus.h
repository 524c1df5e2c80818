/// The I2C bus of both sensors. Whatever fails, the bus is let go afterwards, and the next transfer
/// finds it idle or is refused.

#pragma once

#include <Arduino.h>
#include <Wire.h>

#include "config.h"
#if defined(__IMXRT1062__)
#include "i2c_teensy4.h"
#else
#include "i2c_samd21.h"
#endif

namespace exoid {

class WireBus {
 public:
  void begin() {
    Wire.begin();
    Wire.setClock(config::I2C_FREQUENCY);
    master_.begin();
  }

  /// Writes one register. Returns false where the device did not take it.
  bool write(uint8_t device, uint8_t to, uint8_t value) {
    const uint8_t bytes[] = {to, value};
    return or_released(is_ready() && master_.write(device, bytes, sizeof bytes) && master_.stop());
  }

  /// Reads `count` registers from `first` on. Returns false where not all of them came.
  bool read(uint8_t device, uint8_t first, uint8_t* bytes, uint8_t count) {
    return or_released(is_ready() && master_.write(device, &first, 1) &&
                       master_.read(device, bytes, count));
  }

  /// Transfers that failed.
  uint32_t releases() const { return releases_; }

 private:
  static constexpr uint8_t PULSES = 9;  // eight bits and their acknowledgement
  static constexpr uint32_t HALF_PULSE_US = 5;
  static constexpr uint32_t LONGEST_STOP_US = 50;  // from its command until both lines are high

  static bool is_idle() {
    return digitalRead(PIN_WIRE_SDA) == HIGH && digitalRead(PIN_WIRE_SCL) == HIGH;
  }

  /// Whether both lines are high and the last stop is over. They are high, too, in the bit before
  /// that stop, by which a read is ended.
  bool is_free() const {
    const uint32_t began_us = micros();
    while (!is_idle() || !master_.is_idle()) {
      if (micros() - began_us > LONGEST_STOP_US) return false;
    }
    return true;
  }

  bool is_ready() { return is_free() || release(); }

  /// A transfer that failed may have left the SERCOM or a device in the middle of one.
  bool or_released(bool done) {
    if (!done) {
      ++releases_;
      release();
    }
    return done;
  }

  /// Clocks a device that holds the data line through the byte it believes it sends, ends with a
  /// stop and sets the SERCOM up again. Returns whether both lines are free.
  bool release() {
    Wire.end();
    let_go(PIN_WIRE_SCL);
    let_go(PIN_WIRE_SDA);
    for (uint8_t pulse = 0; pulse < PULSES && digitalRead(PIN_WIRE_SDA) == LOW; ++pulse) {
      pull_down(PIN_WIRE_SCL);
      let_go(PIN_WIRE_SCL);
    }
    pull_down(PIN_WIRE_SDA);
    let_go(PIN_WIRE_SDA);
    const bool freed = is_idle();
    begin();
    return freed;
  }

  static void pull_down(uint8_t pin) {
    digitalWrite(pin, LOW);
    pinMode(pin, OUTPUT);
    delayMicroseconds(HALF_PULSE_US);
  }

  static void let_go(uint8_t pin) {
    pinMode(pin, INPUT_PULLUP);
    delayMicroseconds(HALF_PULSE_US);
  }

  I2cMaster master_;
  uint32_t releases_ = 0;
};

}  // namespace exoid
