/// What a leg does by its encoder's counts alone: is it still, since when unseen, how often it turned.

#pragma once

#include "learning.h"

namespace exoid {

class Stillness {
 public:
  /// The count of a tick, or that none was seen; `missed` ticks before it had no sample.
  void see(int32_t count, bool seen, uint32_t missed) {
    const int32_t gap = missed < MOST ? static_cast<int32_t>(missed) : MOST;
    blind_ = seen ? gap : blind_ + 1 + gap;
    if (blind_ > MOST) blind_ = MOST;
    if (is_lost()) {
      still_ = 0;
    } else if (seen) {
      settle(count);
    }
    if (seen) turn(count);
  }

  /// Ticks without a sight of it, over which nobody knows what a hand did.
  bool is_lost() const { return blind_ > learning::LONGEST_BLIND; }

  bool is_at_rest() const { return still_ >= learning::REST; }

  /// Where it rests.
  int32_t place() const { return (low_ + high_) >> 1; }

  /// Turns since `begin`.
  int32_t turns() const { return turns_; }

  /// A movement begins here.
  void begin(int32_t count) {
    turns_ = 0;
    way_ = 0;
    peak_ = count;
  }

 private:
  static constexpr int32_t MOST = 10000;  // ticks, turns

  void settle(int32_t count) {
    const int32_t low = count < low_ ? count : low_, high = count > high_ ? count : high_;
    if (still_ == 0 || high - low > learning::STILL) {
      low_ = high_ = count;
      still_ = 1;
      return;
    }
    low_ = low;
    high_ = high;
    if (still_ < learning::REST) ++still_;
  }

  void turn(int32_t count) {
    const int32_t on = way_ < 0 ? peak_ - count : count - peak_;
    const bool back = on < -learning::DEPARTED, far = on > learning::DEPARTED;
    if (way_ != 0) {
      if (back && turns_ < MOST) ++turns_;
      if (back) way_ = -way_;
      if (back || on > 0) peak_ = count;
    } else if (back || far) {
      way_ = far ? 1 : -1;
      peak_ = count;
    }
  }

  int32_t low_ = 0, high_ = 0;  // counts between which it has been
  int32_t still_ = 0;           // ticks for which it stayed there, up to REST
  int32_t blind_ = MOST;        // ticks since it was seen
  int32_t peak_ = 0;            // count at the end of its way
  int32_t way_ = 0;             // -1, 1, or 0 where none is known
  int32_t turns_ = 0;
};

}  // namespace exoid
