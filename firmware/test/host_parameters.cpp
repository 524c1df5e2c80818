// The parameters of the torque in a flash whose power is cut after any byte, whose bits fall over,
// and in a memory whose bits do.

#include <cstring>
#include <initializer_list>

#include "host_check.h"
#include "received_parameters.h"

namespace {

using exoid::TorqueParameters;
using Record = exoid::Record<TorqueParameters>;

constexpr TorqueParameters LEG = {8.0F, 0.1F, 2.0F, 0.3F, 0.2F, 0.3F,
                                  1.0F, 0.5F, 0.5F, 0.5F, 5.0F, 50.0F};

/// One slot; the power goes after so many bytes of an erasure and the write behind it.
struct Flash {
  uint8_t bytes[64];
  uint32_t power;  // bytes for which it lasts

  void read(uint8_t, uint8_t* to, uint32_t count) const { std::memcpy(to, bytes, count); }

  bool write(uint8_t, const uint8_t* from, uint32_t count) {
    check(count <= sizeof bytes, "they fit a page");
    for (uint32_t at = 0; at < sizeof bytes && power > 0; ++at, --power) bytes[at] = 0xFF;
    for (uint32_t at = 0; at < count && power > 0; ++at, --power) bytes[at] = from[at];
    return power > 0;
  }
};

Flash filled(uint8_t byte) {
  Flash flash = {};
  std::memset(flash.bytes, byte, sizeof flash.bytes);
  flash.power = 1000000;
  return flash;
}

/// What a node finds that starts with this flash.
exoid::KeptParameters<Flash> started(Flash& flash) {
  exoid::KeptParameters<Flash> kept(flash);
  kept.load();
  return kept;
}

Flash holding(const TorqueParameters& leg) {
  Flash flash = filled(0xFF);
  exoid::KeptParameters<Flash> kept = started(flash);
  check(kept.save(leg) && kept.are_whole(), "they are stored");
  return flash;
}

void fresh_flash_holds_none() {
  for (uint32_t byte = 0; byte < 256; ++byte) {
    Flash flash = filled(static_cast<uint8_t>(byte));
    check(!started(flash).are_held(), "no filler is a leg");
  }
}

void they_outlive_the_power() {
  Flash flash = holding(LEG);
  const exoid::KeptParameters<Flash> kept = started(flash);
  check(kept.are_whole() && exoid::are_equal(kept.now(), LEG), "the next start finds them");
  check(kept.crc() == exoid::crc_of(LEG), "with the CRC that the host computes");
  flash.power = 0;
  exoid::KeptParameters<Flash> again = started(flash);
  check(again.save(LEG), "the same once more wear nothing");
}

/// After a cut there are the new ones or none: a leg of before would be another one's.
void a_cut_leaves_none() {
  TorqueParameters other = LEG;
  other.gravity = 9.0F;
  for (uint32_t power = 1; power < sizeof(Flash::bytes) + Record::SIZE; ++power) {
    Flash flash = holding(LEG);
    exoid::KeptParameters<Flash> kept = started(flash);
    flash.power = power;
    check(!kept.save(other), "the cut is noticed where anybody still runs");
    check(exoid::are_equal(kept.now(), other) && !kept.are_stored(), "until then they count");
    check(!started(flash).are_held(), "and the next start finds none");
  }
}

void no_bit_of_flash_falls_unseen() {
  const Flash flash = holding(LEG);
  for (uint32_t bit = 0; bit < 8 * Record::SIZE; ++bit) {
    Flash damaged = flash;
    damaged.bytes[bit / 8] ^= static_cast<uint8_t>(1U << bit % 8);
    check(!started(damaged).are_held(), "there are none");
  }
}

void no_bit_of_memory_falls_unseen() {
  Flash flash = holding(LEG);
  exoid::KeptParameters<Flash> kept = started(flash);
  for (uint32_t bit = 0; bit < 8 * sizeof LEG; ++bit) {
    auto* bytes = reinterpret_cast<uint8_t*>(const_cast<TorqueParameters*>(&kept.now()));
    bytes[bit / 8] ^= static_cast<uint8_t>(1U << bit % 8);
    check(!kept.are_whole(), "they are whole no more");
    bytes[bit / 8] ^= static_cast<uint8_t>(1U << bit % 8);
    check(kept.are_whole(), "and are again");
  }
}

/// What is whole and no leg's, as another program may have written it.
void nonsense_is_not_held() {
  for (uint32_t place = 0; place < exoid::PARAMETERS; ++place) {
    for (float number : {-2.0F, 1000.0F, __builtin_nanf(""), __builtin_huge_valf()}) {
      TorqueParameters leg = LEG;
      std::memcpy(reinterpret_cast<uint8_t*>(&leg) + 4 * place, &number, sizeof number);
      check(!exoid::is_plausible(leg), "it is no leg's");
      Flash flash = filled(0xFF);
      const Record record = exoid::record_of(leg, 0);
      flash.write(0, record.bytes, sizeof record.bytes);
      check(!started(flash).are_held(), "and not held");
    }
  }
}

}  // namespace

int main() {
  fresh_flash_holds_none();
  they_outlive_the_power();
  a_cut_leaves_none();
  no_bit_of_flash_falls_unseen();
  no_bit_of_memory_falls_unseen();
  nonsense_is_not_held();
  return 0;
}
