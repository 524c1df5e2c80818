/// Register models of the sensors: what a driver reads from and writes to real ones.

#pragma once

#include <stdint.h>

#include "exposure.h"
#include "icm42688p_model.h"

namespace chips {

class As5600Model {
 public:
  static constexpr uint8_t ADDRESS = 0x36;

  void expose(const Exposure& now) {
    silent_ = (now.faults & ENCODER_SILENT) != 0;
    status_ = static_cast<uint8_t>((now.faults & MAGNET_MISSING ? 0 : 0x20) |
                                   (now.faults & MAGNET_WEAK ? 0x10 : 0) |
                                   (now.faults & MAGNET_STRONG ? 0x08 : 0));
    count_ = now.count;
  }

  bool write(uint8_t to, uint8_t value) {
    if (silent_) return false;
    if (to == 0x07 || to == 0x08) conf_[to - 0x07] = value;
    return true;
  }

  /// The address does not run on past the angle: it goes back to the angle's first byte.
  bool read(uint8_t first, uint8_t* bytes, uint8_t count) const {
    if (silent_) return false;
    for (uint8_t at = 0; at < count; ++at) {
      const bool of_angle = first == 0x0C || first == 0x0E;
      bytes[at] = value(of_angle ? static_cast<uint8_t>(first + at % 2)
                                 : static_cast<uint8_t>(first + at));
    }
    return true;
  }

  /// Fast filter, always on, and what a maker left there untouched.
  bool is_set_up() const { return conf_[0] == 0xC3 && conf_[1] == 0xA0; }

 private:
  uint8_t value(uint8_t at) const {
    if (at == 0x07 || at == 0x08) return conf_[at - 0x07];
    if (at == 0x0B) return status_;
    if (at == 0x0C || at == 0x0E) return static_cast<uint8_t>(count_ >> 8);
    return at == 0x0D || at == 0x0F ? static_cast<uint8_t>(count_) : 0;
  }

  bool silent_ = false;
  uint8_t status_ = 0x20;
  uint8_t conf_[2] = {0xE4, 0xAD};  // as made: reserved bits, watchdog, PWM, low power
  uint16_t count_ = 0;
};

class Lsm6ds3Model {
 public:
  static constexpr uint8_t ADDRESS = 0x6A;

  Lsm6ds3Model() { reset(); }

  void expose(const Exposure& now) {
    silent_ = (now.faults & IMU_SILENT) != 0;
    if (now.faults & IMU_RESET) reset();
    if (!runs()) return;
    for (int axis = 0; axis < 3; ++axis) {
      put(0x22 + 2 * axis, now.gyro[axis]);
      put(0x28 + 2 * axis, now.accel[axis]);
    }
    registers_[0x1E] = 0x03;
  }

  bool write(uint8_t to, uint8_t value) {
    if (silent_) return false;
    registers_[to % SIZE] = value;
    return true;
  }

  bool read(uint8_t first, uint8_t* bytes, uint8_t count) {
    if (silent_) return false;
    const bool increments = (registers_[0x12] & 0x04) != 0;
    for (uint8_t at = 0; at < count; ++at) {
      bytes[at] = registers_[(increments ? first + at : first) % SIZE];
    }
    if (first >= 0x22) registers_[0x1E] = 0;
    return true;
  }

 private:
  static constexpr int SIZE = 0x80;

  void reset() {
    for (uint8_t& each : registers_) each = 0;
    registers_[0x0F] = 0x69;
    registers_[0x12] = 0x04;
  }

  bool runs() const { return registers_[0x10] == 0x78 && registers_[0x11] == 0x7C; }

  void put(int at, int16_t value) {
    registers_[at] = static_cast<uint8_t>(value);
    registers_[at + 1] = static_cast<uint8_t>(value >> 8);
  }

  bool silent_ = false;
  uint8_t registers_[SIZE];
};

/// The chips on one bus, as the drivers want it.
class Board {
 public:
  void expose(const Exposure& now) {
    encoder.expose(now);
    imu.expose(now);
    other_imu.expose(now);
  }

  bool write(uint8_t device, uint8_t to, uint8_t value) {
    if (device == As5600Model::ADDRESS) return encoder.write(to, value);
    if (device == Icm42688pModel::ADDRESS) return other_imu.write(to, value);
    return device == Lsm6ds3Model::ADDRESS && imu.write(to, value);
  }

  bool read(uint8_t device, uint8_t first, uint8_t* bytes, uint8_t count) {
    if (device == As5600Model::ADDRESS) return encoder.read(first, bytes, count);
    if (device == Icm42688pModel::ADDRESS) return other_imu.read(first, bytes, count);
    return device == Lsm6ds3Model::ADDRESS && imu.read(first, bytes, count);
  }

  As5600Model encoder;
  Lsm6ds3Model imu;
  Icm42688pModel other_imu;
};

}  // namespace chips
