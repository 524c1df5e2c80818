/// Tells what is learned of a leg, ten times a second: a part of the work a tick, so that no tick has
/// much more of it than others.

#pragma once

#include "exo_can.h"
#include "learned.h"

namespace exoid {

inline Ratios ratios_of(const Learned& found) {
  return {found.ratio[GRAVITY_RATIO], found.ratio[STIFFNESS_RATIO], found.ratio[DAMPING_RATIO],
          found.ratio[TORQUE_RATIO]};
}

inline RatioErrors errors_of(const Learned& found) {
  return {found.error[GRAVITY_RATIO], found.error[STIFFNESS_RATIO], found.error[DAMPING_RATIO],
          found.error[TORQUE_RATIO]};
}

inline Friction friction_of(const Learned& found) {
  return {found.ratio[FRICTION_RATIO], found.error[FRICTION_RATIO]};
}

/// Of what was read off at a tick.
inline Learning learning_of(const ReadOff& read, const Learned& found, uint32_t tick) {
  constexpr float COUNTS = 16.0F, MOST = 255.0F;  // of Surprise
  const float surprise = found.surprise * COUNTS;
  return {tick & 255U,
          static_cast<uint32_t>(trust(read, found)),
          static_cast<uint32_t>(read.phase),
          read.drops,
          static_cast<uint32_t>(surprise < MOST ? surprise : MOST),
          LEARNING_CRC};
}

class LegTeller {
 public:
  /// What was read off and not yet sent is of before.
  void restart() { part_ = Part::READ; }

  /// Does what is due at a tick, once in each. `send(frame)` is called for each frame.
  template <class Send>
  void run(const LegLearner& learner, uint32_t tick, Send send) {
    if (tick == tick_) return;
    tick_ = tick;
    switch (part_) {
      case Part::READ:
        if (tick - read_at_ < TICKS_PER_LEARNED) return;
        read_at_ = tick;
        read_ = read_off(learner);
        part_ = Part::WEIGH;
        return;
      case Part::WEIGH:
        found_ = learned(read_);
        part_ = Part::RATIOS;
        return;
      case Part::RATIOS:
        send(pack(ratios_of(found_)));
        part_ = Part::ERRORS;
        return;
      case Part::ERRORS:
        send(pack(errors_of(found_)));
        part_ = Part::FRICTION;
        return;
      case Part::FRICTION:
        send(pack(friction_of(found_)));
        part_ = Part::LEARNING;
        return;
      case Part::LEARNING:
        send(pack(learning_of(read_, found_, read_at_)));
        part_ = Part::READ;
    }
  }

 private:
  enum class Part : uint8_t { READ, WEIGH, RATIOS, ERRORS, FRICTION, LEARNING };

  uint32_t tick_ = 0;
  uint32_t read_at_ = 0U - TICKS_PER_LEARNED / 2;  // tick; between two EXO_TIME
  ReadOff read_ = {};
  Learned found_ = {};
  Part part_ = Part::READ;
};

}  // namespace exoid
