/// One free movement of the leg: what it tells, and whether that can be believed.

#pragma once

#include "leg_filter.h"
#include "surprise.h"

namespace exoid {

/// The leg at a moment of a movement.
struct Kept {
  Leg leg;
  int32_t age;     // ticks of the movement until then
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

  void predict() {
    filter_.predict();
    used_ = refused_ = false;
  }

  void see_angle(float angle) {
    const Correction seen = filter_.see_angle(angle);
    surprise_.see_angle(seen);
    count(seen);
  }

  void see_rate(float rate) {
    const Correction seen = filter_.see_rate(rate);
    surprise_.see_rate(seen);
    count(seen);
  }

  /// All that a tick showed was taken in.
  void end_tick() {
    if (refused_) {
      ++astray_;
    } else if (used_) {
      astray_ = 0;
    }
    ++age_;
    ++since_;
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
  static constexpr uint32_t MOST = 20000;  // of which squares are summed

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
  int32_t age_ = 0;     // ticks
  int32_t since_ = 0;   // ticks since the last keeping
  int32_t astray_ = 0;  // ticks in a row that cannot be the leg's
  bool used_ = false, refused_ = false;
};

/// Does what is known of a leg at such a moment count?
inline bool counts(const Kept& kept, int32_t turns) {
  return kept.explained && kept.age > learning::SHORTEST && turns > 0 &&
         kept.leg.belief.mean[LEVEL] > learning::LEAST_GRAVITY;
}

}  // namespace exoid
