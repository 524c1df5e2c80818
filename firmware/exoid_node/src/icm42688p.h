/// ICM-42688-P, an inertial sensor on the sensors' bus: 2000 deg/s and 4 g at 500 Hz.
///
/// Registers: TDK InvenSense DS-000347 revision 1.8, register map of bank 0 (14.36 PWR_MGMT0, page
/// 77: a gyro is on for 45 ms at the least, and nothing is written for 200 us after a sensor is
/// turned on), and the drivers of InvenSense (inv_icm426xx: data ready, -32768 for no sample) and
/// of PX4 (InvenSense_ICM42688P_registers.hpp).

#pragma once

#include "constants.h"
#include "frame.h"
#include "lsm6ds3.h"

namespace exoid {

/// `Bus` has `bool write(device, register, value)` and `bool read(device, register, bytes, n)`.
template <class Bus>
class Icm42688p {
 public:
  static constexpr uint8_t ADDRESS = 0x68;  // its pin AP_AD0 to ground

  explicit Icm42688p(Bus& bus) : bus_(bus) {}

  /// Reads one sample, in counts of the frames RAW and ACC. A sample that the chip has not renewed
  /// since the last read is a fault: the chip has lost its settings, which are then looked at
  /// before the next read, or is starting. On a fault returns false and leaves `reading` alone.
  bool read(ImuReading& reading) {
    if (!trusted_ && !keeps_settings() && !configure()) return false;
    uint8_t status = 0;
    uint8_t bytes[BURST];
    trusted_ = bus_.read(ADDRESS, STATUS, &status, 1) && (status & RENEWED) != 0 &&
               read_whole(bytes);
    if (!trusted_ || !settled()) return false;
    int16_t found[6];
    for (uint8_t at = 0; at < 6; ++at) {
      found[at] = static_cast<int16_t>(bytes[2 * at] << 8 | bytes[2 * at + 1]);
      if (found[at] == NO_SAMPLE) return false;
    }
    for (uint8_t axis = 0; axis < 3; ++axis) {
      reading.accel[axis] = in_counts(found[axis], ACCEL_COUNT / ACCEL_STEP);
      reading.gyro[axis] = in_counts(found[3 + axis], GYRO_COUNT / GYRO_STEP);
    }
    return true;
  }

 private:
  static constexpr uint8_t OUTPUT_START = 0x1F;  // accelerometer x y z, gyro x y z, high byte first
  static constexpr uint8_t STATUS = 0x2D;
  static constexpr uint8_t BURST = STATUS - OUTPUT_START + 1;
  static constexpr uint8_t PWR_MGMT0 = 0x4E;
  static constexpr uint8_t GYRO_CONFIG0 = 0x4F;
  static constexpr uint8_t ACCEL_CONFIG0 = 0x50;
  static constexpr uint8_t WHO_AM_I = 0x75, NAME = 0x47;
  static constexpr uint8_t BANK = 0x76;

  static constexpr uint8_t BOTH_LOW_NOISE = 0x0F;
  static constexpr uint8_t GYRO_500_HZ_2000_DPS = 0x0F;
  static constexpr uint8_t ACCEL_500_HZ_4_G = 0x4F;
  static constexpr uint8_t RENEWED = 0x08;  // and cleared by the read of STATUS
  static constexpr uint8_t SETTLING = 8;    // reads; the gyro needs 45 ms to start

  static constexpr int16_t NO_SAMPLE = -32768;
  static constexpr int16_t LIMIT = 32766;  // counts; the last that the chip tells
  static constexpr float GYRO_COUNT = 3.14159265F / 180.0F / 16.4F;  // rad/s
  static constexpr float ACCEL_COUNT = 9.80665F / 8192.0F;           // m/s^2

  bool keeps_settings() {
    uint8_t now[3] = {0, 0, 0};
    return bus_.read(ADDRESS, PWR_MGMT0, now, 3) && now[0] == BOTH_LOW_NOISE &&
           now[1] == GYRO_500_HZ_2000_DPS && now[2] == ACCEL_500_HZ_4_G;
  }

  bool configure() {
    uint8_t name = 0;
    const bool done = bus_.read(ADDRESS, WHO_AM_I, &name, 1) && name == NAME &&
                      bus_.write(ADDRESS, BANK, 0) &&
                      bus_.write(ADDRESS, GYRO_CONFIG0, GYRO_500_HZ_2000_DPS) &&
                      bus_.write(ADDRESS, ACCEL_CONFIG0, ACCEL_500_HZ_4_G) &&
                      bus_.write(ADDRESS, PWR_MGMT0, BOTH_LOW_NOISE);
    if (done) settling_ = SETTLING;
    return done;
  }

  /// Reads the output up to the status behind it. The chip does not say that it holds a sample
  /// while that is read: where the next came meanwhile, halves of two may stand there, and it reads
  /// again.
  bool read_whole(uint8_t* bytes) {
    for (uint8_t attempt = 0; attempt < 2; ++attempt) {
      if (!bus_.read(ADDRESS, OUTPUT_START, bytes, BURST)) return false;
      if ((bytes[BURST - 1] & RENEWED) == 0) return true;
    }
    return false;
  }

  bool settled() {
    if (settling_ == 0) return true;
    --settling_;
    return false;
  }

  /// The nearest count of the frame; its own end where the chip is at its.
  static int16_t in_counts(int16_t found, float ratio) {
    if (found >= LIMIT) return INT16_MAX;
    if (found <= -LIMIT) return -INT16_MAX;
    const uint32_t bits = quantise(static_cast<float>(found) * ratio, -INT16_MAX, INT16_MAX);
    return static_cast<int16_t>(bits);
  }

  Bus& bus_;
  bool trusted_ = false;
  uint8_t settling_ = 0;
};

}  // namespace exoid
