// What the node sends with the encoder of config.h: the angle in full, where RAW cannot hold it.

#include "command_frames.h"
#include "config.h"
#include "constants.h"

namespace {

namespace config = exoid::config;

constexpr int32_t TURN = config::ENCODER == exoid::EncoderPart::AS5600 ? 4096 : 16384;  // counts
constexpr bool FINER = TURN > exoid::RAW_TURN;

/// What the sensors were exposed to at the tick of a RAW frame, in counts of FINE.
uint32_t exposed_at(uint32_t tick) {
  const int32_t count = world.leg(tick).count - config::ENCODER_ZERO;
  return static_cast<uint32_t>(count * (exoid::FINE_TURN / TURN) + exoid::FINE_TURN / 2) & 0xFFFFU;
}

void angle_in_full() {
  power_on();
  run_ms(1000);
  const std::vector<Frame> raws = only(world.on_bus, exoid::RAW_ID);
  const std::vector<Frame> fines = only(world.on_bus, exoid::FINE_ID);
  check(raws.size() > 90, "every tick has a RAW");
  check(fines.size() == (FINER ? raws.size() : 0), "a FINE goes with it where RAW is too coarse");
  for (uint32_t at = 0; at < raws.size(); ++at) {
    const uint32_t exact = exposed_at(at + 1);
    const int32_t coarse = static_cast<int32_t>(field(raws[at], 0, 12) * 16);
    const int32_t off = (coarse - static_cast<int32_t>(exact) + 0x8000) % 0x10000 - 0x8000;
    check(off >= -8 && off <= 8, "RAW has the nearest of its counts");
    if (!FINER) {
      check(off == 0, "which is the encoder's own");
      continue;
    }
    check(field(fines[at], 0, 16) == exact, "FINE has the encoder's count");
    check(field(fines[at], 16, 8) % 16 == field(raws[at], 12, 4), "of the same tick");
    check(field(fines[at], 24, 8) == 14, "and how many bits the encoder has");
  }
}

void zero_in_full() {
  constexpr uint32_t COUNT = 2 * TURN / 4 + 3, HANGING = 1024;  // of RAW: a quarter of a turn
  still_node(COUNT);
  const std::vector<Frame> frames = set(exoid::SET_ZERO_ID, 0xFFFFU & (0U - HANGING), 16);
  check(field(one(frames, exoid::REPLY_ID), 43, 3) == 0, "it is done");
  const uint32_t zero = COUNT + TURN / 4, step = TURN / exoid::RAW_TURN;
  const uint32_t told = field(one(frames, exoid::SETTINGS_ID), ZERO_PLACE, ZERO_BITS);
  check(told == (zero + step / 2) / step, "the zero is told in the nearest count of RAW");
  check(count_of(frames) == exoid::RAW_TURN / 2 - HANGING, "the knee hangs");
  if (!FINER) return;
  const Frame fine = only(frames, exoid::FINE_ID).back();
  check(field(fine, 0, 16) == exoid::FINE_TURN / 4, "to the encoder's last count");
}

}  // namespace

std::vector<Scenario> part_scenarios() {
  return {{"angle_in_full", angle_in_full}, {"zero_in_full", zero_in_full}};
}
