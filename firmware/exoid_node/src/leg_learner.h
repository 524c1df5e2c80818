/// The leg's ratios, learned while it moves freely: what the movements so far say of it.
///
/// A sample's work is done in pieces, so that frames and commands do not wait.

#pragma once

#include "look.h"
#include "movement.h"
#include "stillness.h"
#include "stream_health.h"

namespace exoid {

/// What the leg does.
enum class Phase : uint8_t { HELD, WAITING, LEAVING, MOVING, DONE };

class LegLearner {
 public:
  /// Nothing is known of the leg.
  void forget() { *this = LegLearner(); }

  /// The next tick; its work is still to be done. What two ticks show is taken in by two ticks: the
  /// second of them begins, and the one behind it ends.
  void take(const Glimpse& seen) {
    while (work()) {
    }
    stream_.see(seen.gyro, seen.sees_angle, seen.sees_rate, seen.missed);
    stillness_.see(seen.count, seen.sees_angle, seen.missed);
    second_ = !second_;
    if (second_) {
      first_ = seen;
      judges_ = movement_.go_on();
      return;
    }
    seen_ = look_at(first_, seen);
    judges_ = phase_ != Phase::MOVING;
    if (!judges_) movement_.begin(seen_);
  }

  /// Does one piece of work; returns whether there was one.
  bool work() {
    if (movement_.work()) return true;
    if (!judges_) return false;
    judges_ = false;
    judge();
    return true;
  }

  /// The leg as far as it can be told now: of a movement, as if a hand caught it now.
  const Leg& leg() const {
    const Kept& kept = movement_.before_hand();
    const bool tells = phase_ == Phase::MOVING && !anew_ && counts(kept, stillness_.turns());
    return tells ? kept.leg : known_;
  }

  /// The movement that goes on, or the last one.
  const Movement& movement() const { return movement_; }

  Phase phase() const { return phase_; }
  uint32_t drops() const { return drops_; }
  bool has_changed() const { return changed_; }
  bool is_unexplained() const { return unexplained_; }
  bool is_faulty() const { return stream_.is_faulty(); }

 private:
  static constexpr int32_t NEVER = 1000000;  // turns
  static constexpr uint32_t MOST = 255;      // drops, failures

  void judge() {
    switch (phase_) {
      case Phase::MOVING: return move();
      case Phase::WAITING: return wait();
      case Phase::LEAVING: return leave();
      default: return rest();
    }
  }

  /// In a hand, or after a movement.
  void rest() {
    if (stillness_.turns() >= suspected_) {
      unexplained_ = true;
      suspected_ = NEVER;
    }
    if (!settles() && stillness_.is_lost()) phase_ = Phase::HELD;
  }

  /// At rest: is it let go?
  void wait() {
    if (settles()) return;
    if (stillness_.is_lost()) {
      phase_ = Phase::HELD;
      return;
    }
    if (!seen_.sees_angle) return;
    const int32_t off = seen_.count() - hold_;
    const bool departed = off > learning::DEPARTED || off < -learning::DEPARTED;
    away_ = departed ? away_ + 1 : 0;
    if (away_ < TWICE) return;  // one alone may be a spike
    const float fallen = fall(is_doubted() ? expected_leg() : known_, angle_of(hold_));
    const bool falls = off > 0 ? fallen > learning::PULL : fallen < -learning::PULL;
    phase_ = falls ? Phase::LEAVING : Phase::HELD;
    letting_go_ = learning::LETTING_GO;
  }

  /// The hand goes off the leg.
  void leave() {
    if (letting_go_ > 0) --letting_go_;
    if (settles()) return;
    if (stillness_.is_lost()) {
      phase_ = Phase::HELD;
      return;
    }
    const bool sound = seen_.sees_angle && seen_.sees_rate && seen_.missed == 0;
    if (letting_go_ > 0 || !sound) return;
    anew_ = is_doubted();
    movement_.open(anew_ ? expected_leg() : known_, seen_.angle(), seen_.rate());
    stillness_.begin(seen_.count());
    phase_ = Phase::MOVING;
  }

  /// It has come to rest.
  bool settles() {
    if (!stillness_.is_at_rest()) return false;
    phase_ = Phase::WAITING;
    hold_ = stillness_.place();
    away_ = 0;
    suspected_ = NEVER;
    return true;
  }

  void move() {
    const bool torn = stillness_.is_lost() || stream_.is_silent() || seen_.missed > 0;
    const bool caught = movement_.is_cut(), cut = caught || torn;
    if (!cut && !stillness_.is_at_rest()) return movement_.keep();
    const Kept end = cut ? movement_.before_hand() : movement_.now();
    const bool counted = counts(end, stillness_.turns());
    if (counted) {
      learn(end.leg);
    } else if (caught && drops_ > 0 && failures_ < MOST) {
      ++failures_;
    }
    suspected_ = caught ? stillness_.turns() + learning::SWUNG : NEVER;
    phase_ = counted ? Phase::DONE : Phase::HELD;
  }

  /// A movement counts, with what is known by it.
  void learn(Leg leg) {
    if (anew_ || drops_ == 0) widen(leg, learning::FIRST_FADING);
    const bool other = anew_ && differ(known_, leg);
    const float before = covariance(known_.belief, LEVEL, LEVEL);
    const bool better = covariance(leg.belief, LEVEL, LEVEL) < before;
    if (!anew_ || other || better) known_ = leg;
    if (other) drops_ = 0;
    if ((!anew_ || other) && drops_ < MOST) ++drops_;
    changed_ = other;
    unexplained_ = false;
    failures_ = 0;
  }

  bool is_doubted() const { return failures_ >= static_cast<uint32_t>(learning::FAILURES); }

  static constexpr int32_t TWICE = 2;

  Movement movement_;
  Stillness stillness_;
  StreamHealth stream_;
  Leg known_ = expected_leg();
  Look seen_ = {};
  Glimpse first_ = {};                   // tick of the look that goes on
  int32_t hold_ = 0;                     // count where it was last at rest
  int32_t away_ = 0;                     // looks in a row away from there
  int32_t letting_go_ = 0;               // looks
  int32_t suspected_ = NEVER;            // turns from which on a movement was no hand's
  uint32_t drops_ = 0;                   // free movements that count
  uint32_t failures_ = 0;                // movements in a row that no known leg explains
  Phase phase_ = Phase::HELD;
  bool second_ = false;                  // the next tick ends a look
  bool judges_ = false;                  // is still to judge what was seen
  bool anew_ = false;                    // the movement is seen as that of an unknown leg
  bool changed_ = false, unexplained_ = false;
};

}  // namespace exoid
