// The driver of the AS5047P and the AS5048A on their register models.

#include "as504x.h"
#include "as504x_model.h"
#include "drivers.h"

namespace {

using chips::As504xModel;
using exoid::EncoderReading;

template <class Map>
struct Pair {
  As504xModel chip{Map::DIAGNOSTICS};
  exoid::As504x<As504xModel, Map> driver{chip};

  /// One read of a chip that is exposed to a count and to faults.
  bool read(EncoderReading& reading, uint16_t count, uint16_t faults = 0) {
    const auto held = chip.from_chip;
    chip.expose({count, faults, {}, {}});
    if (faults == 0) chip.from_chip = held;
    return driver.read(reading);
  }
};

template <class Map>
void counts_for() {
  Pair<Map> pair;
  for (uint16_t count = 0; count < 16384; ++count) {
    EncoderReading reading = {};
    check(pair.read(reading, count), "a well chip is read from its first frame on");
    check(reading.count == count, "the count is this read's, not that of the read before");
    check(!reading.magnet_missing && !reading.magnet_strength, "its magnet is well");
  }
}

void every_count() {
  counts_for<exoid::As5047pMap>();
  counts_for<exoid::As5048aMap>();
  check(exoid::As504x<As504xModel, exoid::As5047pMap>::TURN == 16384, "a turn has 14 bits");
}

/// A fault costs the reads in which it is there, and leaves the reading alone.
template <class Fault, class Cure>
void check_costs_one_read(Fault fault, Cure cure) {
  Pair<exoid::As5047pMap> pair;
  EncoderReading reading = {};
  check(pair.read(reading, 5000), "the chip is well");
  fault(pair.chip);
  check(!pair.read(reading, 6000), "the fault is told");
  check(reading.count == 5000, "and leaves the reading alone");
  cure(pair.chip);
  check(pair.read(reading, 7000) && reading.count == 7000, "the next read is right");
}

/// A link on which a glitch turns bits of one of the frames of a read.
struct Glitch {
  As504xModel& chip;
  int frame;
  uint16_t to_chip, from_chip;

  uint16_t exchange(uint16_t word) {
    if (frame-- == 0) {
      chip.flips_to_chip = to_chip;
      chip.flips_from_chip = from_chip;
    }
    return chip.exchange(word);
  }
};

/// Reads three times, the second with a glitch in one frame.
void check_glitch(int frame, uint16_t to_chip, uint16_t from_chip, bool costs) {
  As504xModel chip(exoid::As5047pMap::DIAGNOSTICS);
  Glitch link = {chip, -1, to_chip, from_chip};
  exoid::As504x<Glitch, exoid::As5047pMap> driver(link);
  EncoderReading reading = {};
  chip.expose({5000, 0, {}, {}});
  check(driver.read(reading), "the chip is well");
  link.frame = frame;
  chip.expose({6001, 0, {}, {}});
  check(driver.read(reading) != costs, "a bit that was turned is told");
  check(reading.count == (costs ? 5000 : 6001), "and never becomes an angle");
  link.frame = -1;
  chip.expose({7000, 0, {}, {}});
  const bool well = driver.read(reading) || driver.read(reading);
  check(well && reading.count == 7000, "two reads later all is well");
}

void wrong_parity_of_answers() {
  for (int bit = 0; bit < 16; ++bit) {
    const uint16_t flip = static_cast<uint16_t>(1 << bit);
    check_glitch(0, 0, flip, false);  // the answer to the read before, which nobody uses
    for (int frame : {1, 2, 3}) check_glitch(frame, 0, flip, true);
  }
}

void wrong_parity_of_commands() {
  for (int bit = 0; bit < 16; ++bit) {
    const uint16_t flip = static_cast<uint16_t>(1 << bit);
    for (int frame : {0, 1, 2}) check_glitch(frame, flip, 0, true);
    check_glitch(3, flip, 0, false);  // too late for this read; the next tells it
  }
}

void error_flag() {
  Pair<exoid::As5047pMap> pair;
  EncoderReading reading = {};
  check(pair.read(reading, 5000), "the chip is well");
  pair.chip.cut();
  check(!pair.read(reading, 6000) && reading.count == 5000, "an error flag is told");
  check(pair.read(reading, 7000) && reading.count == 7000, "its register is read, which clears it");
}

void lines_that_are_stuck() {
  for (const auto line : {As504xModel::HELD_LOW, As504xModel::HELD_HIGH}) {
    check_costs_one_read([=](As504xModel& chip) { chip.from_chip = line; },
                         [](As504xModel& chip) { chip.from_chip = As504xModel::FREE; });
    check_costs_one_read([=](As504xModel& chip) { chip.to_chip = line; },
                         [](As504xModel& chip) { chip.to_chip = As504xModel::FREE; });
  }
}

void offsets_not_ready() {
  check_costs_one_read([](As504xModel& chip) { chip.offsets_done = false; },
                       [](As504xModel& chip) { chip.offsets_done = true; });
}

template <class Map>
void magnets_for() {
  Pair<Map> pair;
  EncoderReading reading = {};
  check(pair.read(reading, 5000, chips::MAGNET_MISSING) && reading.magnet_missing, "none is told");
  check(pair.read(reading, 5000, chips::MAGNET_STRONG), "a strong one is read");
  check(!reading.magnet_missing && reading.magnet_strength, "and told");
  pair.chip.overflows = true;
  check(pair.read(reading, 5000) && reading.magnet_missing, "an overflow has no angle");
  pair.chip.overflows = false;
  check(pair.read(reading, 5000) && !reading.magnet_missing, "and goes by");
}

void magnets() {
  magnets_for<exoid::As5047pMap>();
  magnets_for<exoid::As5048aMap>();
}

/// An AS5048A keeps no diagnostics where an AS5047P does, and calls the command invalid.
void the_other_chip() {
  As504xModel as5048a(exoid::As5048aMap::DIAGNOSTICS);
  exoid::As504x<As504xModel, exoid::As5047pMap> for_as5047p(as5048a);
  EncoderReading reading = {};
  check(!for_as5047p.read(reading) && !for_as5047p.read(reading), "it is never read");
}

}  // namespace

std::vector<Scenario> encoder_scenarios() {
  return {
      {"every_count", every_count},
      {"wrong_parity_of_answers", wrong_parity_of_answers},
      {"wrong_parity_of_commands", wrong_parity_of_commands},
      {"error_flag", error_flag},
      {"lines_that_are_stuck", lines_that_are_stuck},
      {"offsets_not_ready", offsets_not_ready},
      {"magnets", magnets},
      {"the_other_chip", the_other_chip},
  };
}
