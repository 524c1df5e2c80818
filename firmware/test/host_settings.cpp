// The settings in a flash whose power is cut after any byte, and whose bits fall over.

#include <cstring>

#include "host_check.h"
#include "settings_store.h"

namespace {

using exoid::NodeSettings;
using Record = exoid::Record<NodeSettings>;

bool operator==(const NodeSettings& one, const NodeSettings& other) {
  return exoid::are_equal(one, other);
}

/// Two slots; the power goes after so many bytes of an erasure and the write behind it.
struct Flash {
  uint8_t slots[2][Record::SIZE];
  uint32_t power = 1000;  // bytes for which it lasts

  void read(uint8_t slot, uint8_t* bytes, uint32_t count) const {
    std::memcpy(bytes, slots[slot], count);
  }

  bool write(uint8_t slot, const uint8_t* bytes, uint32_t count) {
    for (uint32_t at = 0; at < count && power > 0; ++at, --power) slots[slot][at] = 0xFF;
    for (uint32_t at = 0; at < count && power > 0; ++at, --power) slots[slot][at] = bytes[at];
    return power > 0;
  }
};

NodeSettings numbered(uint32_t number) {
  return {static_cast<uint16_t>((number * 37) & 4095U), number % 2 == 1,
          static_cast<uint8_t>(number % 16), 4};
}

/// What a node finds that starts with this flash.
exoid::SettingsStore<Flash> started(Flash& flash) {
  exoid::SettingsStore<Flash> store(flash);
  store.load();
  return store;
}

Flash filled(uint8_t byte) {
  Flash flash = {};
  std::memset(flash.slots, byte, sizeof flash.slots);
  flash.power = 1000000;
  return flash;
}

void fresh_flash_holds_nothing() {
  for (int byte = 0; byte < 256; ++byte) {
    Flash flash = filled(static_cast<uint8_t>(byte));
    const exoid::SettingsStore<Flash> store = started(flash);
    check(!store.stored() && store.settings() == exoid::BUILT_IN, "no filler is a record");
  }
}

void the_newest_is_found() {
  Flash flash = filled(0xFF);
  for (uint32_t number = 1; number < 70000; ++number) {
    exoid::SettingsStore<Flash> store = started(flash);
    check(store.save(numbered(number)), "it is stored");
    const exoid::SettingsStore<Flash> next = started(flash);
    check(next.settings() == numbered(number), "the next start finds it, past every wrap");
    check(next.changes() == (number & 0xFFFFU), "changes are counted");
    flash.power = 1000;
  }
}

void a_cut_keeps_the_old_settings() {
  for (uint32_t before = 1; before <= 2; ++before) {
    for (uint32_t power = 0; power < 2 * Record::SIZE; ++power) {
      Flash flash = filled(0xFF);
      for (uint32_t number = 1; number <= before; ++number) {
        exoid::SettingsStore<Flash> store = started(flash);
        store.save(numbered(number));
      }
      exoid::SettingsStore<Flash> store = started(flash);
      flash.power = power;
      check(!store.save(numbered(9)), "the cut is noticed where anybody still runs");
      check(store.settings() == numbered(9) && !store.stored(), "until the end the new ones count");
      flash.power = 1000;
      exoid::SettingsStore<Flash> next = started(flash);
      check(next.settings() == numbered(before), "the next start finds the old settings");
      check(next.save(numbered(9)), "and can store again");
      check(started(flash).settings() == numbered(9), "so that they are found");
    }
  }
}

void no_bit_falls_unseen() {
  Flash flash = filled(0xFF);
  exoid::SettingsStore<Flash> store = started(flash);
  store.save(numbered(1));
  store.save(numbered(2));
  for (uint32_t bit = 0; bit < 8 * Record::SIZE; ++bit) {
    Flash damaged = flash;
    damaged.slots[1][bit / 8] ^= static_cast<uint8_t>(1U << bit % 8);
    check(started(damaged).settings() == numbered(1), "the settings before it are used");
  }
}

void equal_settings_wear_nothing() {
  Flash flash = filled(0xFF);
  exoid::SettingsStore<Flash> store = started(flash);
  check(store.save(exoid::BUILT_IN), "what was built in is stored once");
  flash.power = 0;
  check(store.save(exoid::BUILT_IN) && store.changes() == 1, "and not written again");
}

}  // namespace

int main() {
  fresh_flash_holds_nothing();
  the_newest_is_found();
  a_cut_keeps_the_old_settings();
  no_bit_falls_unseen();
  equal_settings_wear_nothing();
  return 0;
}
