/// Whether the node may command a torque: nothing stands against it, and a host says so again and
/// again.

#pragma once

#include <stdint.h>

namespace exoid {

/// What stands against a torque, a bit each. The first eight are the bits of EXO_STATE.
constexpr uint32_t ANGLE_STALE = 1U << 8;    // encoder and gyro do not agree, or the filter begins
constexpr uint32_t NO_PARAMETERS = 1U << 9;  // none that are whole
constexpr uint32_t NOT_FINITE = 1U << 10;    // the torque is no number
constexpr uint32_t HOST_SILENT = 1U << 11;
constexpr uint32_t SWITCHED_OFF = 1U << 12;  // by the host

enum class Permit : uint8_t { DISABLED, ARMED, ENABLED };

/// What a host wishes.
enum class Wish : uint8_t { OFF, ARM, ENABLE };

/// Ticks for which a host may be silent. It speaks every 20 ms, so that four frames in a row may be
/// lost; a leg that is let go falls by 10 deg meanwhile.
constexpr uint32_t LONGEST_UNHEARD = 10;

/// Any doubt disables at the tick that shows it: at once and not by a ramp, as nobody knows then
/// whether a torque on the way would be right, and a drive that hears nothing more stops so, too. Only
/// a new ARM without any doubt leads back, and only an ENABLE behind it to a torque.
class Permission {
 public:
  /// A frame of the host, which numbers them; one with the number before is an echo, and no sign
  /// that a host lives. Returns whether it counts.
  bool hear(Wish wish, uint32_t number) {
    if (wish == Wish::OFF) wish_ = wish;
    if (heard_ && number == number_) return false;
    heard_ = true;
    number_ = number;
    unheard_ = 0;
    wish_ = wish;
    arming_ = wish == Wish::ARM;
    return true;
  }

  /// What it was armed for is no more: disabled, for such doubts, until a host arms it anew.
  void forbid(uint32_t doubts) {
    if (permit_ != Permit::DISABLED) cut_by_ = doubts;
    permit_ = Permit::DISABLED;
    wish_ = Wish::OFF;
    arming_ = false;
  }

  /// Once a tick, with the doubts that are not about the host.
  Permit judge(uint32_t doubts) {
    if (unheard_ <= LONGEST_UNHEARD) ++unheard_;
    if (unheard_ > LONGEST_UNHEARD) doubts |= HOST_SILENT;
    if (wish_ == Wish::OFF) doubts |= SWITCHED_OFF;
    if (doubts != 0) {
      if (arming_ || permit_ != Permit::DISABLED) cut_by_ = doubts;
      permit_ = Permit::DISABLED;
    } else if (arming_) {
      cut_by_ = 0;
      permit_ = Permit::ARMED;
    } else if (wish_ == Wish::ENABLE && permit_ == Permit::ARMED) {
      permit_ = Permit::ENABLED;
    }
    arming_ = false;
    return permit_;
  }

  Permit permit() const { return permit_; }

  /// The doubts that disabled it last, or kept it from being armed; 0 once it is armed.
  uint32_t cut_by() const { return cut_by_; }

 private:
  uint32_t unheard_ = LONGEST_UNHEARD;  // ticks since a host was heard
  uint32_t number_ = 0;                 // of its last frame
  uint32_t cut_by_ = 0;
  Permit permit_ = Permit::DISABLED;
  Wish wish_ = Wish::OFF;
  bool heard_ = false;   // ever
  bool arming_ = false;  // since the last tick
};

}  // namespace exoid
