// The driver of the ICM-42688-P on its register model.

#include <cmath>
#include <cstdlib>

#include "chips.h"
#include "drivers.h"
#include "icm42688p.h"

namespace {

using exoid::ImuReading;

constexpr int SETTLED = 10;  // reads

struct Pair {
  chips::Board board;
  exoid::Icm42688p<chips::Board> driver{board};

  /// One read, a tick after the last.
  bool read(ImuReading& reading, int16_t gyro, int16_t accel, uint16_t faults = 0) {
    board.other_imu.show({0, faults, {gyro, gyro, gyro}, {accel, accel, accel}});
    return driver.read(reading);
  }

  void settle() {
    ImuReading reading = {};
    for (int tick = 0; tick < SETTLED; ++tick) read(reading, 0, 0);
    check(read(reading, 0, 0), "the chip is well");
  }
};

void starts() {
  Pair pair;
  ImuReading reading = {};
  int refused = 0;
  while (refused < 100 && !pair.read(reading, 100, 100)) ++refused;
  check(refused == 9, "the tick that sets it up and eight more, 80 ms, are for the gyro to start");
}

/// 16.4 counts per deg/s are sent as counts of 70 mdps, 8192 counts per g as counts of 0.122 mg.
void scales() {
  Pair pair;
  pair.settle();
  for (int count = -32765; count <= 32765; ++count) {
    ImuReading reading = {};
    const auto raw = static_cast<int16_t>(count);
    check(pair.read(reading, raw, raw), "the chip is well");
    const double rate = count / 16.4 / 0.07, force = count / 8192.0 / 0.122e-3;
    // Half a count for the rounding, and what a float of 24 bits is off at 32767.
    check(std::fabs(reading.gyro[1] - rate) <= 0.5 + 0.005, "the rate is the nearest count");
    const bool fits = std::fabs(force) < 32767.0;
    check(!fits || std::fabs(reading.accel[2] - force) <= 0.5 + 0.005, "so is the force");
    check(fits || std::abs(reading.accel[2]) == 32767, "and the limit where it does not fit");
  }
}

void axes() {
  Pair pair;
  pair.settle();
  pair.board.other_imu.show({0, 0, {287, 574, -861}, {15616, -15616, 0}});
  ImuReading reading = {};
  check(pair.driver.read(reading), "the chip is well");
  check(reading.gyro[0] == 250 && reading.gyro[1] == 500 && reading.gyro[2] == -750, "x, y, z");
  check(reading.accel[0] == 15625 && reading.accel[1] == -15625 && reading.accel[2] == 0, "twice");
}

void ends_of_the_range() {
  Pair pair;
  pair.settle();
  ImuReading reading = {};
  for (int16_t raw : {32766, 32767}) {
    check(pair.read(reading, raw, 0) && reading.gyro[1] == 32767, "the end is the wire's end");
    check(pair.read(reading, static_cast<int16_t>(-raw), 0), "on both sides");
    check(reading.gyro[1] == -32767, "with its sign");
  }
}

void wrong_name() {
  for (uint8_t name : {0x00, 0x6A, 0xFF}) {
    Pair pair;
    pair.board.other_imu.name = name;
    ImuReading reading = {};
    for (int tick = 0; tick < SETTLED; ++tick) {
      check(!pair.read(reading, 1, 1), "another chip, or a bus let go, is never read");
    }
    uint8_t power = 0xFF;
    pair.board.read(chips::Icm42688pModel::ADDRESS, 0x4E, &power, 1);
    check(power == 0, "nor is it written to");
  }
}

void silence() {
  Pair pair;
  pair.settle();
  ImuReading reading = {};
  check(pair.read(reading, 287, 0), "the chip is well");
  check(!pair.read(reading, 574, 0, chips::IMU_SILENT), "a chip that does not answer is told");
  check(reading.gyro[1] == 250, "and leaves the reading alone");
  check(pair.read(reading, 861, 0) && reading.gyro[1] == 750, "one that kept its settings is read");
}

void lost_settings() {
  Pair pair;
  pair.settle();
  ImuReading reading = {};
  check(!pair.read(reading, 1, 1, chips::IMU_RESET), "a chip that was reset is told");
  int refused = 1;
  while (refused < 100 && !pair.read(reading, 287, 0)) ++refused;
  check(refused == 10 && reading.gyro[1] == 250, "it is set up again and settles as at its start");
}

void stale_sample() {
  Pair pair;
  pair.settle();
  ImuReading reading = {};
  check(!pair.driver.read(reading), "what was not renewed since the last read is no sample");
  check(pair.read(reading, 287, 0) && reading.gyro[1] == 250, "the next one is");
}

void sample_that_comes_while_it_is_read() {
  Pair pair;
  pair.settle();
  ImuReading reading = {};
  pair.board.other_imu.renews_while_read = 1;
  check(pair.read(reading, 287, 0), "it is read once more");
  check(reading.gyro[0] == reading.gyro[1] && reading.gyro[0] == 473, "all of it is the new one");
  pair.board.other_imu.renews_while_read = 2;
  check(!pair.read(reading, 287, 0), "one that comes twice is none");
}

void no_sample_yet() {
  Pair pair;
  pair.settle();
  ImuReading reading = {};
  pair.board.other_imu.has_sample = false;
  check(!pair.read(reading, 287, 0), "-32768 is no value");
  pair.board.other_imu.has_sample = true;
  check(pair.read(reading, 287, 0) && reading.gyro[1] == 250, "the next is");
}

}  // namespace

std::vector<Scenario> imu_scenarios() {
  return {
      {"starts", starts},
      {"scales", scales},
      {"axes", axes},
      {"ends_of_the_range", ends_of_the_range},
      {"wrong_name", wrong_name},
      {"silence", silence},
      {"lost_settings", lost_settings},
      {"stale_sample", stale_sample},
      {"sample_that_comes_while_it_is_read", sample_that_comes_while_it_is_read},
      {"no_sample_yet", no_sample_yet},
  };
}
