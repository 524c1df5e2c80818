/// The parameters of the torque as they come from a host, part by part, and as they are kept.

#pragma once

#include "leg_torque.h"
#include "record.h"

namespace exoid {

/// The bytes that keep them.
template <>
struct Coding<TorqueParameters> {
  static constexpr uint8_t FORMAT = 1;
  static constexpr uint32_t SIZE = PARAMETER_BYTES;
  static constexpr uint16_t SEED = PARAMETERS_SEED;

  static void put(const TorqueParameters& parameters, uint8_t* bytes) {
    __builtin_memcpy(bytes, &parameters, SIZE);
  }

  static TorqueParameters get(const uint8_t* bytes) {
    TorqueParameters parameters;
    __builtin_memcpy(&parameters, bytes, SIZE);
    return parameters;
  }
};

/// As the host computes it.
inline uint16_t crc_of(const TorqueParameters& parameters) {
  uint8_t bytes[PARAMETER_BYTES];
  Coding<TorqueParameters>::put(parameters, bytes);
  return checksum(bytes, sizeof bytes, PARAMETERS_SEED);
}

inline bool are_alike(const TorqueParameters& one, const TorqueParameters& other) {
  uint32_t words[2][PARAMETERS];
  __builtin_memcpy(words[0], &one, sizeof one);
  __builtin_memcpy(words[1], &other, sizeof other);
  for (uint32_t at = 0; at < PARAMETERS; ++at) {
    if (words[0][at] != words[1][at]) return false;
  }
  return true;
}

/// Gathers the parts in their order.
class ReceivedParameters {
 public:
  /// A part of two bytes. Returns false, and forgets those before it, where it is neither the next
  /// one nor the last one again, which a host sends that has missed the reply.
  bool take(uint32_t place, uint32_t data) {
    if (place == 0) next_ = 0;
    if (place >= PARTS || (place != next_ && place + 1 != next_)) return refuse();
    for (uint32_t at = 0; at < PART_BYTES; ++at) {
      bytes_[PART_BYTES * place + at] = static_cast<uint8_t>(data >> 8 * at);
    }
    next_ = place + 1;
    return true;
  }

  /// The last part. Returns false, and forgets all, where they are not whole.
  bool end(uint32_t crc, TorqueParameters& parameters) {
    if (next_ != PARTS || checksum(bytes_, sizeof bytes_, PARAMETERS_SEED) != crc) return refuse();
    parameters = Coding<TorqueParameters>::get(bytes_);
    return true;
  }

 private:
  bool refuse() {
    next_ = 0;
    return false;
  }

  uint8_t bytes_[PARAMETER_BYTES] = {};
  uint32_t next_ = 0;  // place of the next part
};

/// Those that the node goes by, in one slot of flash: where that is damaged, or the power went while
/// it was written, there are none, and not those of some leg before. `Flash` has
/// `read(slot, bytes, count)` and `write(slot, bytes, count)`.
template <class Flash>
class KeptParameters {
 public:
  explicit KeptParameters(Flash& flash) : flash_(flash) {}

  /// Takes over what was stored, if it is whole and plausible.
  void load() {
    stored_ = read(now_) && is_plausible(now_);
    if (stored_) hold(now_);
  }

  /// Goes by these from now on. Returns whether the next start will find them.
  bool save(const TorqueParameters& parameters) {
    if (stored_ && are_equal(parameters, now_)) return true;
    hold(parameters);
    const Record<TorqueParameters> record = record_of(parameters, 0);
    TorqueParameters found;
    stored_ = flash_.write(SLOT, record.bytes, sizeof record.bytes) && read(found) &&
              are_equal(found, parameters);
    return stored_;
  }

  /// Whether there are some, and memory still holds them as they came: two copies are alike, which
  /// costs a tenth of their CRC.
  bool are_whole() const { return held_ && are_alike(now_, copy_); }

  bool are_held() const { return held_; }
  bool are_stored() const { return stored_; }
  uint16_t crc() const { return crc_; }
  const TorqueParameters& now() const { return now_; }

 private:
  static constexpr uint8_t SLOT = 2;  // behind the settings

  void hold(const TorqueParameters& parameters) {
    now_ = copy_ = parameters;
    crc_ = crc_of(parameters);
    held_ = true;
  }

  bool read(TorqueParameters& parameters) const {
    Record<TorqueParameters> record = {};
    uint16_t change = 0;
    flash_.read(SLOT, record.bytes, sizeof record.bytes);
    return read_record(record, parameters, change);
  }

  Flash& flash_;
  TorqueParameters now_ = {}, copy_ = {};
  uint16_t crc_ = 0;
  bool held_ = false;
  bool stored_ = false;
};

}  // namespace exoid
