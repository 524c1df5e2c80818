/// LSM6DS3, the inertial sensor of the shank: 2000 deg/s and 4 g.
///
/// It samples by its own clock, and a tick reads the newest sample: at 833 Hz that is up to 1.2 ms
/// old, which at 14 rad/s^2 (1 Hz, 0.5 rad) is 10 mrad/s rms; at 416 Hz it would be 19.

#pragma once

#include <stdint.h>

#include "constants.h"

namespace exoid {

/// Counts along the chip's own axes: 70 mdps and 0.122 mg each.
struct ImuReading {
  int16_t gyro[3];
  int16_t accel[3];
};

/// `Bus` has `bool write(device, register, value)` and `bool read(device, register, bytes, n)`.
template <class Bus>
class Lsm6ds3 {
 public:
  static constexpr uint8_t ADDRESS = 0x6A;

  explicit Lsm6ds3(Bus& bus) : bus_(bus) {}

  /// Reads one sample. A sample that the chip has not renewed since the last read is a fault: the
  /// chip has lost its settings, which are then looked at before the next read, or is starting.
  /// On a fault returns false and leaves `reading` alone.
  bool read(ImuReading& reading) {
    if (!trusted_ && !keeps_settings() && !configure()) return false;
    uint8_t status = 0;
    uint8_t bytes[BURST];
    trusted_ = bus_.read(ADDRESS, STATUS, &status, 1) && (status & RENEWED) == RENEWED &&
               bus_.read(ADDRESS, OUTPUT_START, bytes, BURST);
    if (!trusted_ || !settled()) return false;
    for (uint8_t axis = 0; axis < 3; ++axis) {
      reading.gyro[axis] = count(bytes + 2 * axis);
      reading.accel[axis] = count(bytes + 6 + 2 * axis);
    }
    return true;
  }

 private:
  static constexpr uint8_t WHO_AM_I = 0x0F;
  static constexpr uint8_t CTRL1_XL = 0x10;
  static constexpr uint8_t CTRL2_G = 0x11;
  static constexpr uint8_t CTRL3_C = 0x12;
  static constexpr uint8_t STATUS = 0x1E;
  static constexpr uint8_t OUTPUT_START = 0x22;  // gyro x y z, then accelerometer x y z
  static constexpr uint8_t BURST = 12;

  static constexpr uint8_t BLOCK_UPDATE_AND_INCREMENT = 0x44;
  static constexpr uint8_t ACCEL_4_G = IMU_RATE | 0x08;
  static constexpr uint8_t GYRO_2000_DPS = IMU_RATE | 0x0C;
  static constexpr uint8_t RENEWED = 0x03;  // gyro and accelerometer data available
  static constexpr uint8_t SETTLING = 8;    // reads; the gyro needs 80 ms to start

  bool keeps_settings() {
    uint8_t now[3] = {0, 0, 0};
    return bus_.read(ADDRESS, CTRL1_XL, now, 3) && now[0] == ACCEL_4_G &&
           now[1] == GYRO_2000_DPS && now[2] == BLOCK_UPDATE_AND_INCREMENT;
  }

  bool configure() {
    uint8_t name = 0;
    const bool done = bus_.read(ADDRESS, WHO_AM_I, &name, 1) && is_known(name) &&
                      bus_.write(ADDRESS, CTRL3_C, BLOCK_UPDATE_AND_INCREMENT) &&
                      bus_.write(ADDRESS, CTRL1_XL, ACCEL_4_G) &&
                      bus_.write(ADDRESS, CTRL2_G, GYRO_2000_DPS);
    if (done) settling_ = SETTLING;
    return done;
  }

  /// LSM6DS3, LSM6DS3TR-C and LSM6DSO: the same registers, ranges and rates.
  static bool is_known(uint8_t name) { return name == 0x69 || name == 0x6A || name == 0x6C; }

  bool settled() {
    if (settling_ == 0) return true;
    --settling_;
    return false;
  }

  static int16_t count(const uint8_t* bytes) {
    return static_cast<int16_t>(bytes[0] | (bytes[1] << 8));
  }

  Bus& bus_;
  bool trusted_ = false;
  uint8_t settling_ = 0;
};

}  // namespace exoid
