// The driver of the FlexCAN module on its register model.

#include "can_timing.h"
#include "drivers.h"
#include "flexcan.h"
#include "flexcan_model.h"

namespace {

using exoid::Frame;
using simulated::FlexCanModel;
constexpr uint32_t CLOCK = 48000000, RATE = 500000;
using Ids = exoid::CanIds<0x110, 0x7>;

struct Bus {
  uint64_t now_us = 0;
  FlexCanModel chip{now_us};
  exoid::FlexCan<FlexCanModel, CLOCK, Ids> can{chip};
  std::vector<Frame> heard;

  Bus() {
    chip.on_frame = [this](const Frame& frame) { heard.push_back(frame); };
    can.begin(RATE);
  }

  void run_ms(uint32_t time) {
    const uint64_t end = now_us + time * 1000ULL;
    for (; now_us < end; now_us += 50) can.poll(static_cast<uint32_t>(now_us / 1000));
  }

  /// Four frames a tick for so long; returns how often one was said to be lost.
  int send_for(uint32_t ticks) {
    int lost = 0;
    for (uint32_t tick = 0; tick < ticks; ++tick) {
      for (uint16_t id = 0x101; id < 0x105; ++id) lost += can.send(frame(id, tick)) ? 0 : 1;
      run_ms(10);
    }
    return lost;
  }

  static Frame frame(uint16_t id, uint32_t tick) {
    const uint8_t first = static_cast<uint8_t>(tick);
    return {id, {first, 1, 2, 3, 4, 5, 6, static_cast<uint8_t>(id)}};
  }
};

void timing_of_the_oscillator() {
  for (uint32_t rate : {125000U, 250000U, 500000U, 1000000U}) {
    const uint32_t quanta = exoid::best_quanta(CLOCK, rate);
    check(quanta != 0 && CLOCK / 2 % (quanta * rate) == 0, "the bit is exact");
    const uint32_t nearest = rate < 1000000 ? 875 : 833;  // of 12 quanta, as 24 are too many
    check(exoid::sample_point(quanta) == nearest, "and sampled at seven eighths of it or near");
  }
}

void frames_in_their_order() {
  Bus bus;
  bus.run_ms(20);
  check(bus.can.is_up() && bus.can.starts() == 1, "it comes up");
  check(bus.send_for(100) == 0, "no frame is lost");
  check(bus.heard.size() == 400, "all are on the bus");
  for (uint32_t at = 0; at < 400; ++at) {
    const Frame sent = Bus::frame(static_cast<uint16_t>(0x101 + at % 4), at / 4);
    check(bus.heard[at].id == sent.id, "in their order");
    for (int byte = 0; byte < 8; ++byte) {
      check(bus.heard[at].data[byte] == sent.data[byte], "whole");
    }
  }
}

void frames_of_others() {
  Bus bus;
  bus.run_ms(20);
  Frame frame = {};
  for (uint32_t id = 0; id < 0x800; ++id) {
    if (Ids::has(static_cast<uint16_t>(id))) continue;
    bus.chip.hear(id, false, false, 8);
    bus.chip.hear(id << 18, true, false, 8);
  }
  for (bool remote : {false, true}) bus.chip.hear(0x110, false, remote, remote ? 8 : 7);
  bus.chip.hear(0x110U << 18, true, false, 8);
  check(!bus.can.receive(frame), "no frame of others is taken");
  bus.chip.hear(0x7, false, false, 8);
  bus.chip.hear(0x110, false, false, 8);
  check(bus.can.receive(frame) && frame.id == 0x110, "what it understands is");
  for (int byte = 0; byte < 8; ++byte) check(frame.data[byte] == byte + 1, "whole");
  check(bus.can.receive(frame) && frame.id == 0x7, "each");
  check(!bus.can.receive(frame), "once");
}

void frame_that_is_put_into_its_mailbox() {
  Bus bus;
  bus.run_ms(20);
  Frame frame = {};
  bus.chip.hear(0x110, false, false, 8);
  bus.chip.moves_in = true;
  check(!bus.can.receive(frame), "a frame of which half may be another's is not taken");
  bus.chip.moves_in = false;
  check(bus.can.receive(frame) && frame.id == 0x110, "but when it is whole");
}

void nobody_acknowledges() {
  Bus bus;
  bus.run_ms(20);
  bus.chip.acknowledged = false;
  check(bus.send_for(100) > 0 && bus.heard.empty(), "what has no room is told to be lost");
  check(bus.can.transmit_errors() > 127 && bus.can.starts() == 1, "it counts errors, no more");
  bus.chip.acknowledged = true;
  check(bus.send_for(5) > 0 && bus.send_for(50) == 0, "then all is well");
  check(bus.can.transmit_errors() == 0, "and forgotten");
}

void bus_that_is_shorted() {
  Bus bus;
  bus.run_ms(20);
  for (bool stays_off : {false, true}) {
    bus.chip.shorted = true;
    bus.chip.stays_off = stays_off;
    bus.send_for(10);
    check(bus.can.is_off(), "it has left the bus");
    const uint32_t starts = bus.can.starts();
    bus.send_for(50);
    check(bus.can.starts() > starts, "one that is off for long is set up again");
    bus.chip.shorted = bus.chip.stays_off = false;
    bus.send_for(5);
    bus.heard.clear();
    check(bus.send_for(50) == 0 && bus.heard.size() >= 196, "and sends when the bus is free");
    check(!bus.can.is_off(), "on which it is");
  }
}

void controller_that_forgets() {
  Bus bus;
  bus.run_ms(20);
  for (int way = 0; way < 2; ++way) {
    const uint32_t starts = bus.can.starts();
    if (way == 0) bus.chip.fall_out();
    if (way == 1) bus.chip.forget();
    check(bus.send_for(5) > 0, "lost frames are told");
    check(bus.send_for(50) == 0 && bus.can.starts() == starts + 1, "it is set up again, once");
  }
}

void request_that_is_overlooked() {
  Bus bus;
  bus.run_ms(20);
  bus.chip.overlooks = true;
  check(bus.send_for(5) == 0 && bus.heard.size() == 20, "the spare mailbox wakes the sender");
}

void controller_that_is_dead() {
  for (const auto answer : {FlexCanModel::DEAD_LOW, FlexCanModel::DEAD_HIGH}) {
    Bus bus;
    bus.chip.answer = answer;
    bus.run_ms(1000);
    check(!bus.can.is_up() && bus.can.starts() == 0, "it never seems to be up");
    check(bus.send_for(10) == 0, "and nothing is lost to nobody");
    bus.chip.answer = FlexCanModel::ANSWERS;
    bus.run_ms(50);
    check(bus.can.is_up(), "it comes up when it answers");
    bus.chip.answer = answer;
    check(bus.send_for(10) > 0 && !bus.can.is_up(), "and its loss is told");
  }
}

}  // namespace

std::vector<Scenario> flexcan_scenarios() {
  return {
      {"timing_of_the_oscillator", timing_of_the_oscillator},
      {"frames_in_their_order", frames_in_their_order},
      {"frames_of_others", frames_of_others},
      {"frame_that_is_put_into_its_mailbox", frame_that_is_put_into_its_mailbox},
      {"nobody_acknowledges", nobody_acknowledges},
      {"bus_that_is_shorted", bus_that_is_shorted},
      {"controller_that_forgets", controller_that_forgets},
      {"request_that_is_overlooked", request_that_is_overlooked},
      {"controller_that_is_dead", controller_that_is_dead},
  };
}
