/// Register model of the ICM-42688-P: what a driver reads from and writes to a real one.
///
/// After TDK InvenSense DS-000347 revision 1.8, bank 0: reset values, the output from 0x1F on with
/// the high byte first (INTF_CONFIG0 0x30), DATA_RDY_INT in bit 3 of INT_STATUS, which a read
/// clears, and -32768 in the output until there is a sample.

#pragma once

#include <stdint.h>

#include "exposure.h"

namespace chips {

class Icm42688pModel {
 public:
  static constexpr uint8_t ADDRESS = 0x68;

  Icm42688pModel() { reset(); }

  uint8_t name = 0x47;
  uint8_t renews_while_read = 0;  // bursts in whose middle the next sample comes
  bool has_sample = true;         // else what there is of one is not valid

  /// Rates of 70 mdps a count and forces of 0.122 mg, which it shows in its own counts.
  void expose(const Exposure& now) {
    Exposure own = now;
    for (int16_t& each : own.gyro) each = own_count(each, 16.4 * 0.07);
    for (int16_t& each : own.accel) each = own_count(each, 8192 * 0.122e-3);
    show(own);
  }

  /// What its counts are from now on.
  void show(const Exposure& own) {
    silent_ = (own.faults & IMU_SILENT) != 0;
    if (own.faults & IMU_RESET) reset();
    now_ = own;
    if (runs()) renew();
  }

  bool write(uint8_t to, uint8_t value) {
    if (silent_) return false;
    registers_[to % SIZE] = value;
    return true;
  }

  /// The address runs on by itself.
  bool read(uint8_t first, uint8_t* bytes, uint8_t count) {
    if (silent_) return false;
    for (uint8_t at = 0; at < count; ++at) {
      const uint8_t from = static_cast<uint8_t>(first + at) % SIZE;
      if (from == GYRO_Y && renews_while_read > 0) {
        --renews_while_read;
        for (int16_t& each : now_.gyro) each = static_cast<int16_t>(each + 256);
        renew();
      }
      bytes[at] = from == 0x75 ? name : registers_[from];
      if (from == STATUS) registers_[STATUS] = 0;
    }
    return true;
  }

 private:
  static constexpr int SIZE = 0x80;
  static constexpr uint8_t GYRO_Y = 0x27, STATUS = 0x2D;

  void reset() {
    for (uint8_t& each : registers_) each = 0;
    for (int at = 0x1F; at < 0x2B; at += 2) registers_[at] = 0x80;
    registers_[0x4C] = 0x30;
    registers_[0x4D] = 0x91;
    registers_[0x4F] = registers_[0x50] = 0x06;
    registers_[0x51] = 0x16;
    registers_[0x52] = 0x11;
  }

  bool runs() const {
    return registers_[0x4E] == 0x0F && registers_[0x4F] == 0x0F && registers_[0x50] == 0x4F;
  }

  static int16_t own_count(int16_t count, double ratio) {
    const double own = count * ratio + (count < 0 ? -0.5 : 0.5);
    return own >= 32767.0 ? 32767 : own <= -32767.0 ? -32767 : static_cast<int16_t>(own);
  }

  void renew() {
    for (int axis = 0; axis < 3; ++axis) {
      put(0x1F + 2 * axis, has_sample ? now_.accel[axis] : INT16_MIN);
      put(0x25 + 2 * axis, has_sample ? now_.gyro[axis] : INT16_MIN);
    }
    registers_[STATUS] = 0x08;
  }

  void put(int at, int16_t value) {
    registers_[at] = static_cast<uint8_t>(value >> 8);
    registers_[at + 1] = static_cast<uint8_t>(value);
  }

  Exposure now_ = {};
  bool silent_ = false;
  uint8_t registers_[SIZE];
};

}  // namespace chips
