// What a whole tick costs but for the waiting: sensors, filter, frames, CAN controller and USB.
// in.bin: what befalls each tick. Out: the counts of SysTick, at 62.5 instructions each with
// -icount shift=0.

#include "as504x_model.h"
#include "can_timing.h"
#include "chips.h"
#include "config.h"
#include "mcp2515.h"
#include "semihosting.h"
#include "sensors.h"
#include "systick.h"
#include "tended_node.h"
#include "uplink.h"

namespace {

constexpr uint32_t CRYSTAL = 8000000;  // Hz
constexpr exoid::CanRegisters TIMING = exoid::can_registers(CRYSTAL, 500000);

/// An MCP2515 that has always sent the last frame.
struct WillingSpi {
  void begin() {}
  void exchange(uint8_t* bytes, uint8_t count) {
    const bool from_cnf3 = bytes[0] == 0x03 && bytes[1] == 0x28;
    for (uint8_t at = 1; at < count; ++at) bytes[at] = 0;
    if (!from_cnf3) return;
    bytes[2] = TIMING.cnf3;
    bytes[3] = TIMING.cnf2;
    bytes[4] = TIMING.cnf1;
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

/// A board on which nothing was ever stored, and whose supply is known at once.
struct PlainBoard {
  void read(uint8_t, uint8_t* bytes, uint32_t count) const {
    for (uint32_t at = 0; at < count; ++at) bytes[at] = 0xFF;
  }
  bool write(uint8_t, const uint8_t*, uint32_t) { return false; }
  static void begin() {}
  static uint32_t serial() { return 1; }
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
};

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
    const uint32_t before = exoid::systick_left();
    ++timer.now;
    tick();
    const uint32_t counts = before - exoid::systick_left();
    if (!output.write(&counts, sizeof counts)) return 1;
  }
  return 0;
}
