/// The learner over a file of ticks, the same on every machine: what comes out is compared bit by
/// bit.

#pragma once

#include "learned.h"

namespace exoid {

/// A tick, in words of 32 bits.
struct Tick {
  int32_t count, gyro;
  uint32_t sees_angle, sees_rate, missed;
  uint32_t forget;  // another leg begins
};

/// What is compared, at every tenth tick but one: all work of a look is then done.
struct Told {
  uint32_t phase, trust, drops;
  Kept now;
  Learned learned;
};

constexpr uint32_t TOLD_EVERY = 10;  // ticks

/// `Input` and `Output` have `bool read(bytes, size)` and `bool write(bytes, size)`.
template <class Input, class Output>
bool run_learner(LegLearner& learner, Input& input, Output& output) {
  Tick tick;
  for (uint32_t ticks = 1; input.read(&tick, sizeof tick); ++ticks) {
    if (tick.forget) learner.forget();
    learner.take({tick.count, tick.gyro, tick.sees_angle != 0, tick.sees_rate != 0, tick.missed});
    if (ticks % TOLD_EVERY != TOLD_EVERY - 1) continue;
    while (learner.work()) {
    }
    const ReadOff read = read_off(learner);
    const Learned found = learned(read);
    Told told = {static_cast<uint32_t>(read.phase), static_cast<uint32_t>(trust(read, found)),
                 read.drops,
                 learner.movement().now(), found};
    if (!output.write(&told, sizeof told)) return false;
  }
  return true;
}

}  // namespace exoid
