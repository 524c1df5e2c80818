/// An encoder as it sits on the leg: its counts less the mounting zero, positive in extension.

#pragma once

#include "estimator.h"
#include "node_settings.h"

namespace exoid {

/// `Encoder` has `bool read(EncoderReading&)`, and TURN, its counts to a turn.
template <class Encoder>
class MountedEncoder {
 public:
  static constexpr int32_t OWN_TURN = Encoder::TURN;

  MountedEncoder(Encoder& encoder, const NodeSettings& settings)
      : encoder_(encoder), settings_(settings) {}

  /// As the encoder, but in counts of EXO_FINE, of which ZERO_COUNT is the knee fully extended.
  bool read(EncoderReading& reading) {
    EncoderReading found = {};
    const bool answered = encoder_.read(found);
    sees_angle_ = answered && !found.magnet_missing;
    if (!answered) return false;
    count_ = found.count;
    reading = found;
    const int32_t turned = sign() * (static_cast<int32_t>(found.count) - settings_.zero);
    reading.count = static_cast<uint16_t>((turned * FINER + ZERO_COUNT) & (TURN - 1));
    return true;
  }

  /// The zero with which the last reading is this angle [counts of EXO_RAW]. Returns false, and
  /// leaves `zero` alone, where that reading was no angle.
  bool zero_for(int32_t angle, uint16_t& zero) const {
    if (!sees_angle_) return false;
    const int32_t turned = sign() * angle * (OWN_TURN / RAW_TURN);
    zero = static_cast<uint16_t>((count_ - turned) & (OWN_TURN - 1));
    return true;
  }

  /// The zero in the counts of EXO_SETTINGS, which are those of EXO_RAW.
  static uint32_t told_zero(uint16_t zero) { return coarse(zero * FINER); }

 private:
  static constexpr int32_t FINER = TURN / OWN_TURN;

  int32_t sign() const { return settings_.reversed ? -1 : 1; }

  Encoder& encoder_;
  const NodeSettings& settings_;
  int32_t count_ = 0;  // of the last answer, as the encoder says it
  bool sees_angle_ = false;
};

}  // namespace exoid
