/// Settings that outlive the power: two slots of flash, of which the newer whole one counts.

#pragma once

#include "node_settings.h"

namespace exoid {

/// `Flash` has two slots: `read(slot, bytes, count)`, and `write(slot, bytes, count)`, which erases
/// the slot first. Power that goes while one slot is written leaves the other as it was.
template <class Flash>
class SettingsStore {
 public:
  explicit SettingsStore(Flash& flash) : flash_(flash) {}

  /// Takes over what was stored last.
  void load() {
    for (uint8_t slot = 0; slot < SLOTS; ++slot) {
      NodeSettings found = BUILT_IN;
      uint16_t change = 0;
      if (!read(slot, found, change) || (stored_ && !is_newer(change, changes_))) continue;
      stored_ = true;
      slot_ = slot;
      settings_ = found;
      changes_ = change;
    }
  }

  /// Uses these settings from now on. Returns false where the flash did not take them: then what
  /// was stored before is what the next start finds.
  bool save(const NodeSettings& settings) {
    if (stored() && are_equal(settings, settings_)) return true;
    settings_ = settings;
    const uint8_t slot = static_cast<uint8_t>(stored_ ? 1 - slot_ : 0);
    const uint16_t change = static_cast<uint16_t>(changes_ + 1);
    const Record<NodeSettings> record = record_of(settings, change);
    NodeSettings found = BUILT_IN;
    uint16_t kept = 0;
    if (!flash_.write(slot, record.bytes, sizeof record.bytes) || !read(slot, found, kept) ||
        !are_equal(found, settings) || kept != change) {
      unstored_ = true;
      return false;
    }
    stored_ = true;
    unstored_ = false;
    slot_ = slot;
    changes_ = change;
    return true;
  }

  const NodeSettings& settings() const { return settings_; }

  /// Whether the next start will find these settings.
  bool stored() const { return stored_ && !unstored_; }

  uint16_t changes() const { return changes_; }

 private:
  static constexpr uint8_t SLOTS = 2;

  bool read(uint8_t slot, NodeSettings& settings, uint16_t& change) {
    Record<NodeSettings> record = {};
    flash_.read(slot, record.bytes, sizeof record.bytes);
    return read_record(record, settings, change);
  }

  /// The count of changes wraps; of two slots one is a single change ahead.
  static bool is_newer(uint16_t change, uint16_t than) {
    return static_cast<int16_t>(static_cast<uint16_t>(change - than)) > 0;
  }

  Flash& flash_;
  NodeSettings settings_ = BUILT_IN;
  uint16_t changes_ = 0;
  uint8_t slot_ = 0;
  bool stored_ = false;
  bool unstored_ = false;  // in use, but not taken by the flash
};

}  // namespace exoid
