/// The I2C bus of both sensors on Arduino's Wire, which waits for ever on a line that is held down.

#pragma once

#include <Arduino.h>
#include <Wire.h>

#include "config.h"

namespace exoid {

class WireBus {
 public:
  void begin() {
    Wire.begin();
    Wire.setClock(config::I2C_FREQUENCY);
  }

  /// Writes one register. Returns false where the device did not take it.
  bool write(uint8_t device, uint8_t to, uint8_t value) {
    if (!idle() && !release()) return false;
    Wire.beginTransmission(device);
    Wire.write(to);
    Wire.write(value);
    return Wire.endTransmission() == 0;
  }

  /// Reads `count` registers from `first` on. Returns false where not all of them came.
  bool read(uint8_t device, uint8_t first, uint8_t* bytes, uint8_t count) {
    if (!idle() && !release()) return false;
    Wire.beginTransmission(device);
    Wire.write(first);
    if (Wire.endTransmission(false) != 0) return false;
    if (Wire.requestFrom(device, count) != count) return false;
    for (uint8_t at = 0; at < count; ++at) bytes[at] = static_cast<uint8_t>(Wire.read());
    return true;
  }

 private:
  static constexpr uint8_t PULSES = 9;  // eight bits and their acknowledgement
  static constexpr uint32_t HALF_PULSE_US = 5;

  static bool idle() {
    return digitalRead(PIN_WIRE_SDA) == HIGH && digitalRead(PIN_WIRE_SCL) == HIGH;
  }

  /// Clocks a device that holds the data line through the byte it believes it sends, and ends with
  /// a stop. Returns whether both lines are free.
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
    const bool freed = idle();
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
};

}  // namespace exoid
