// What a whole tick costs but for the waiting: sensors, filter, frames, CAN controller and USB.
// in.bin: whether parameters of a torque are stored, and what befalls each tick. Out: the counts of
// SysTick, at 62.5 instructions each with -icount shift=0.

#include "as504x_model.h"
#include "can_timing.h"
#include "chips.h"
#include "config.h"
#include "mcp2515.h"
#include "received_parameters.h"
#include "semihosting.h"
#include "sensors.h"
#include "systick.h"
#include "tended_node.h"
#include "uplink.h"

namespace {

constexpr uint32_t CRYSTAL = 8000000;  // Hz
constexpr exoid::CanRegisters TIMING = exoid::can_registers(CRYSTAL, 500000);
constexpr uint32_t SERIAL = 1;

/// An MCP2515 that has always sent the last frame, and hears one of a host when told to.
struct WillingSpi {
  exoid::Frame heard = {};
  bool hears = false;

  void begin() {}
  void exchange(uint8_t* bytes, uint8_t count) {
    const uint8_t command = bytes[0];
    const bool from_cnf3 = command == 0x03 && bytes[1] == 0x28;
    for (uint8_t at = 1; at < count; ++at) bytes[at] = 0;
    if (command == 0xA0) bytes[1] = hears ? 1 : 0;
    if (command == 0x90) hand_over(bytes + 1);
    if (!from_cnf3) return;
    bytes[2] = TIMING.cnf3;
    bytes[3] = TIMING.cnf2;
    bytes[4] = TIMING.cnf1;
  }

  void hand_over(uint8_t* buffer) {
    buffer[0] = static_cast<uint8_t>(heard.id >> 3);
    buffer[1] = static_cast<uint8_t>(heard.id << 5);
    buffer[4] = sizeof heard.data;
    for (uint8_t at = 0; at < sizeof heard.data; ++at) buffer[5 + at] = heard.data[at];
    hears = false;
  }
};

/// A host that takes every packet, and opens the channel when told to.
struct WillingPort {
  const char* typed = "";
  int available() const { return *typed != '\0' ? 1 : 0; }
  int read() { return *typed++; }
  int availableForWrite() const { return 63; }
  bool hung_up() const { return false; }
  size_t write(const uint8_t*, size_t count) { return count; }
};

struct SetClock {
  uint32_t now = 0, age = 0;
  uint32_t ticks() const { return now; }
  uint32_t age_us() const { return age; }
};

struct Well {
  void describe(exoid::Health&) const {}
};

/// A leg of which a part of all that there is is taken off.
constexpr exoid::TorqueParameters LEG = {8.0F, 0.1F, 2.0F, 0.3F, 0.2F, 0.3F,
                                         0.9F, 0.5F, 0.5F, 0.8F, 5.0F, 50.0F};

/// A board on which parameters were stored and no settings, and whose supply is known at once.
struct PlainBoard {
  bool holds_parameters = false;

  void read(uint8_t slot, uint8_t* bytes, uint32_t count) const {
    const exoid::Record<exoid::TorqueParameters> record = exoid::record_of(LEG, 0);
    const bool kept = holds_parameters && slot == 2;
    for (uint32_t at = 0; at < count; ++at) bytes[at] = kept ? record.bytes[at] : 0xFF;
  }
  bool write(uint8_t, const uint8_t*, uint32_t) { return false; }
  static void begin() {}
  static uint32_t serial() { return SERIAL; }
  static uint32_t supply_mv() { return 3300; }
  static void light(bool) {}
};

using Can = exoid::Mcp2515<WillingSpi, CRYSTAL, exoid::CommandIds>;

namespace config = exoid::config;
using EncoderOf = exoid::EncoderOf<config::ENCODER, chips::Board, chips::As504xModel>;

struct Kinds {
  using Encoder = EncoderOf::Driver;
  using Imu = exoid::ImuOf<config::IMU, chips::Board>::Driver;
  using Link = exoid::Uplink<Can, WillingPort>;
  using Flash = PlainBoard;
  using Board = PlainBoard;
  using Clock = SetClock;
  using Condition = Well;
};

chips::Board chips_on_bus;
chips::As504xModel on_spi(exoid::As5047pMap::DIAGNOSTICS);
Kinds::Encoder encoder(EncoderOf::link(chips_on_bus, on_spi));
Kinds::Imu imu(chips_on_bus);
WillingSpi spi;
Can can(spi);
WillingPort port;
Kinds::Link uplink(can, port);
PlainBoard plain;
SetClock timer;
Well well;
exoid::TendedNode<Kinds> node({encoder, imu, uplink, plain, plain, timer, well});

/// A tick, in words of 16 bits.
struct Given {
  uint16_t opens;  // 1 where a host opens the channel on USB
  uint16_t count;  // of the encoder
  int16_t rate;    // of the gyro, positive in extension
  uint16_t wish;   // of a host on CAN, and 1; 0 for none
};

/// What a host says that has such a wish.
void allow(uint32_t wish, uint32_t number) {
  spi.heard = {exoid::ALLOW_ID, {}};
  put(spi.heard, 0, 32, SERIAL);
  put(spi.heard, 32, 6, wish | (number & 15U) << 2);
  put(spi.heard, 38, 6, 63);
  put(spi.heard, 56, 8, exoid::checksum(spi.heard.data, exoid::CHECKED_BYTES) & 255U);
  spi.hears = true;
}

/// The passes of a loop that have something to do: at the tick, and in the middle between two.
void tick() {
  constexpr uint32_t PASSES = 8;  // as many frames, packets and pieces of work as there are
  for (timer.age = 0; timer.age < exoid::TICK_US; timer.age += exoid::TICK_US / 2) {
    for (uint32_t pass = 0; pass < PASSES; ++pass) node.run(10 * timer.now);
  }
}

}  // namespace

int main() {
  semihosting::File input("in.bin", 6, semihosting::READ_BINARY);
  semihosting::File output("out.bin", 7, semihosting::WRITE_BINARY);
  uint16_t holds = 0;
  input.read(&holds, sizeof holds);
  plain.holds_parameters = holds != 0;
  node.begin();
  exoid::systick_begin(exoid::SYSTICK_LONGEST);
  Given given;
  while (input.read(&given, sizeof given)) {
    if (given.opens) port.typed = "O\r";
    chips::Exposure now = {};
    now.count = given.count;
    now.gyro[1] = static_cast<int16_t>(-given.rate);
    chips_on_bus.expose(now);
    on_spi.expose(now);
    if (given.wish != 0) allow(given.wish - 1U, timer.now);
    const uint32_t before = exoid::systick_left();
    ++timer.now;
    tick();
    const uint32_t counts = before - exoid::systick_left();
    if (!output.write(&counts, sizeof counts)) return 1;
  }
  return 0;
}
