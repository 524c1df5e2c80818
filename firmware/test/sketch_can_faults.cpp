// What the CAN controller, its bus and its wires may do, and what the node makes of it.

#include "can_timing.h"
#include "constants.h"
#include "exo_commands.h"
#include "mcp2515.h"
#include "spi_link.h"
#include "world.h"

namespace {

using exoid::Frame;
using simulated::Mcp2515Model;

constexpr uint32_t LONGEST_PASS_US = 2 * exoid::TICK_US;

std::vector<Frame> states_of(uint32_t ticks) {
  world.on_bus.clear();
  run_ms(ticks * 10);
  return only(world.on_bus, exoid::STATE_ID);
}

uint32_t counter(const Frame& state) { return field(state, 48, 8); }

/// A gap of the counters is told by the first STATE after it, and by no later one.
void check_gap_is_told(const std::vector<Frame>& states, uint32_t last) {
  check(!states.empty() && counter(states.front()) != ((last + 1) & 255U), "frames were lost");
  bool told = false;
  for (uint32_t at = 0; at < 30 && at < states.size(); ++at) {
    told = told || status(states[at], OVERRUN);
  }
  check(told, "Overrun tells that frames were lost");
  check(!status(states.back(), OVERRUN), "and goes out again");
  check(field(states.back(), 56, 7) == 0, "the sensors know nothing of it");
}

void check_no_tick_was_missed() {
  check(world.longest_pass_us < LONGEST_PASS_US, "no pass of the loop takes two ticks");
  const Frame time = only(world.on_bus, exoid::TIME_ID).back();
  check(field(time, 40, 8) == 0, "no tick was missed");
}

void controller_that_dies() {
  power_on();
  for (const auto answer : {Mcp2515Model::DEAD_LOW, Mcp2515Model::DEAD_HIGH}) {
    for (uint32_t time_ms : {5U, 60U, 5000U}) {
      const uint32_t last = counter(states_of(60).back());
      board.can.set_answer(answer);
      check(states_of(1).size() <= 1, "a dead controller sends nothing");
      run_ms(time_ms);
      board.can.set_answer(Mcp2515Model::ANSWERS);
      check_gap_is_told(states_of(60), last);
    }
  }
  check_no_tick_was_missed();
}

void controller_that_comes_late() {
  board.can.set_answer(Mcp2515Model::DEAD_HIGH);
  power_on();
  run_ms(60000);
  board.can.set_answer(Mcp2515Model::ANSWERS);
  const std::vector<Frame> states = states_of(30);
  check(states.size() >= 24, "it is found within 60 ms");
  for (const Frame& state : states) check(!status(state, OVERRUN), "nobody lost a frame before");
  check_no_tick_was_missed();
}

/// A dip of its supply: it answers, but knows nothing of its settings any more.
void controller_that_forgets() {
  power_on();
  const uint32_t last = counter(states_of(60).back());
  board.can.set_answer(Mcp2515Model::DEAD_LOW);
  board.can.set_answer(Mcp2515Model::ANSWERS);
  check_gap_is_told(states_of(60), last);
  const uint32_t later = counter(states_of(60).back());
  board.can.fall_out();
  check_gap_is_told(states_of(60), later);
  check_no_tick_was_missed();
}

void bus_that_is_shorted() {
  power_on();
  for (const bool stays_off : {false, true}) {
    const uint32_t last = counter(states_of(60).back());
    board.can.stays_off = stays_off;
    board.can.shorted = true;
    check(states_of(100).empty(), "nothing comes through");
    board.can.shorted = false;
    check_gap_is_told(states_of(100), last);
  }
  check_no_tick_was_missed();
}

void cable_that_is_pulled() {
  power_on();
  for (uint32_t time_ms : {100U, 10000U}) {
    uint32_t last = counter(states_of(60).back());
    const uint32_t starts = board.can.starts();
    board.can.acknowledged = false;
    check(states_of(time_ms / 10).empty(), "nobody hears it");
    board.can.acknowledged = true;
    const std::vector<Frame> states = states_of(60);
    check(counter(states.front()) == ((last + 1) & 255U), "the frames that waited come first");
    auto behind = states.begin();
    for (; behind != states.end() && counter(*behind) == ((last + 1) & 255U); ++behind) {
      last = counter(*behind);
    }
    check_gap_is_told({behind, states.end()}, last);
    check(board.can.starts() == starts, "the controller needs no new start for that");
  }
  check_no_tick_was_missed();
}

void foreign_frames() {
  power_on();
  run_ms(300);
  for (uint32_t id = 0; id < 0x7FF; ++id) {
    for (uint8_t length : {0, 8, 15}) {
      if (!exoid::CommandIds::has(static_cast<uint16_t>(id))) board.can.hear(id, false, length);
      board.can.hear(id << 18 | 0x2A5A5U, true, length);
    }
  }
  check(board.can.received() == 0, "the controller lets no frame of others in");
  board.can.hear(exoid::NO_CAN_ID, false, 15);  // which no bus carries
  check(states_of(30).size() >= 29, "and one that came in all the same does no harm");
  check_no_tick_was_missed();
}

/// A node that understands two identifiers hears these alone, whole and in order.
void frames_that_are_understood() {
  exoid::SpiLink spi;
  exoid::Mcp2515<exoid::SpiLink, 8000000, exoid::CanIds<0x110, 0x7>> can(spi);
  Frame frame = {};
  can.begin(500000);
  for (uint32_t time = 0; time < 20; ++time) {
    can.poll(time);
    board.now_us += 1000;
  }
  check(can.is_up() && !can.receive(frame), "nothing came yet");
  for (uint32_t id = 0; id < 0x7FF; ++id) board.can.hear(id, id % 2 == 0 && id != 0x110, 8);
  check(can.receive(frame) && frame.id == 0x7 && frame.data[7] == 0xE7, "the one");
  check(can.receive(frame) && frame.id == 0x110 && frame.data[0] == 0xE0, "and the other");
  check(!can.receive(frame), "and no more");
  for (uint8_t length : {0, 7, 9, 15}) {
    board.can.hear(0x110, false, length);
    check(!can.receive(frame), "a frame of another length is not understood");
  }
  board.can.hear(0x110, false, 8);
  check(can.receive(frame), "and stands in no other's way");
  board.can.hears_all = true;
  board.can.hear(0x111, false, 8);
  board.can.hear(0x110U << 18, true, 8);
  check(!can.receive(frame) && !can.receive(frame), "a foreign frame is refused by the node, too");
}

/// By the registers, as the chip's data sheet has them.
void check_timing(uint32_t crystal, uint32_t rate, uint32_t lowest, uint32_t highest) {
  const exoid::CanRegisters to = exoid::can_registers(crystal, rate);
  const uint32_t prescaler = (to.cnf1 & 63U) + 1, jump = (to.cnf1 >> 6U) + 1;
  const uint32_t propagation = (to.cnf2 & 7U) + 1, phase_1 = (to.cnf2 >> 3U & 7U) + 1;
  const uint32_t phase_2 = (to.cnf3 & 7U) + 1;
  const uint32_t before = 1 + propagation + phase_1, quanta = before + phase_2;
  check(crystal == 2 * rate * prescaler * quanta, "the bit rate is exact");
  const uint32_t at = 1000 * before / quanta;
  check(at >= lowest && at <= highest, "the sample point is as near to 87.5 % as the chip can");
  check(phase_2 >= 2 && phase_2 > jump, "the chip can do it");
  check((to.cnf2 & 0x80U) != 0 && to.cnf3 < 8, "CNF3 says the second phase, and nothing else");
}

void timing() {
  check_timing(8000000, 500000, 750, 750);  // eight quanta, and two after the sample point at least
  check_timing(8000000, 250000, 875, 875);
  check_timing(8000000, 125000, 875, 875);
  check_timing(16000000, 1000000, 750, 750);
  check_timing(16000000, 500000, 875, 875);
  check_timing(20000000, 500000, 800, 900);
}

}  // namespace

std::vector<Scenario> can_fault_scenarios() {
  return {
      {"controller_that_dies", controller_that_dies},
      {"controller_that_comes_late", controller_that_comes_late},
      {"controller_that_forgets", controller_that_forgets},
      {"bus_that_is_shorted", bus_that_is_shorted},
      {"cable_that_is_pulled", cable_that_is_pulled},
      {"foreign_frames", foreign_frames},
      {"frames_that_are_understood", frames_that_are_understood},
      {"timing", timing},
  };
}
