/// One free movement of the leg: what it tells, and whether that can be believed.

#pragma once

#include "leg_filter.h"
#include "look.h"
#include "surprise.h"

namespace exoid {

/// The leg at a moment of a movement.
struct Kept {
  Leg leg;
  int32_t age;     // looks of the movement until then
  bool explained;  // until then
};

class Movement {
 public:
  /// A movement of a leg of which so much is known begins with this sample [rad, rad/s].
  void open(const Leg& leg, float angle, float rate) {
    filter_.open(leg, angle, rate);
    surprise_ = {};
    squares_ = leg.squares;
    counted_ = leg.counted;
    if (counted_ > MOST) {
      counted_ = counted_ / 2;
      squares_ = 0.5F * squares_;
    }
    age_ = astray_ = since_ = 0;
    newer_ = older_ = {leg, 0, true};
  }

  /// A look of it: two ticks have the work of it, and the first of them goes half of the way.
  void begin(const Look& seen) {
    seen_ = seen;
    used_ = refused_ = false;
    part_ = Part::PREDICT;
  }

  /// The second half is due; returns whether there is one.
  bool go_on() {
    if (part_ != Part::HALF) return false;
    part_ = Part::ANGLE_ENDS;
    return true;
  }

  /// Does one part of the work that is due; returns whether there was one.
  bool work() {
    switch (part_) {
      case Part::HALF:
      case Part::NONE: return false;
      case Part::PREDICT: filter_.predict(); break;
      case Part::ANGLE:
        if (seen_.sees_angle) filter_.see_angle(seen_.angle());
        break;
      case Part::MORE_ANGLE:
        if (seen_.sees_angle) filter_.go_on();
        break;
      case Part::ANGLE_ENDS:
        if (seen_.sees_angle) finish_angle();
        break;
      case Part::RATE:
        if (seen_.sees_rate) filter_.see_rate(seen_.rate());
        break;
      case Part::RATE_ENDS:
        if (seen_.sees_rate) finish_rate();
        end();
        break;
    }
    part_ = static_cast<Part>(static_cast<uint8_t>(part_) + 1);
    return true;
  }

  /// Is it sure that no free leg moves so?
  bool is_cut() const {
    return surprise_.is_failing() || astray_ >= learning::CAUGHT || !filter_.is_sound();
  }

  /// Keeps the leg as it is known now, from time to time: a hand is seen late.
  void keep() {
    if (since_ < learning::KEPT) return;
    since_ = 0;
    older_ = newer_;
    newer_ = now();
    newer_.explained = surprise_.is_explained();
  }

  /// The leg as it was known a moment ago: no hand had touched it.
  const Kept& before_hand() const { return older_; }

  /// The leg as it is known.
  Kept now() const {
    Kept kept = {{{}, squares_, counted_}, age_, true};
    filter_.read(kept.leg.belief);
    return kept;
  }

 private:
  /// In their order.
  enum class Part : uint8_t { PREDICT, ANGLE, MORE_ANGLE, HALF, ANGLE_ENDS, RATE, RATE_ENDS, NONE };
  static constexpr uint32_t MOST = 20000;  // of which squares are summed

  void finish_angle() {
    const Correction seen = filter_.finish();
    surprise_.see_angle(seen);
    count(seen);
  }

  void finish_rate() {
    filter_.go_on();
    const Correction seen = filter_.finish();
    surprise_.see_rate(seen);
    count(seen);
  }

  /// All that a look showed was taken in.
  void end() {
    if (refused_) {
      ++astray_;
    } else if (used_) {
      astray_ = 0;
    }
    ++age_;
    ++since_;
  }

  void count(const Correction& seen) {
    used_ = used_ || seen.used;
    refused_ = refused_ || !seen.used;
    if (!seen.used) return;
    squares_ = squares_ + seen.square;
    ++counted_;
  }

  LegFilter filter_;
  Surprise surprise_;
  Kept older_ = {}, newer_ = {};
  float squares_ = 0.0F;
  uint32_t counted_ = 0;
  int32_t age_ = 0;     // looks
  int32_t since_ = 0;   // looks since the last keeping
  int32_t astray_ = 0;  // looks in a row that cannot be the leg's
  Look seen_ = {};
  Part part_ = Part::NONE;
  bool used_ = false, refused_ = false;
};

/// Does what is known of a leg at such a moment count?
inline bool counts(const Kept& kept, int32_t turns) {
  return kept.explained && kept.age > learning::SHORTEST && turns > 0 &&
         kept.leg.belief.mean[LEVEL] > learning::LEAST_GRAVITY;
}

}  // namespace exoid
