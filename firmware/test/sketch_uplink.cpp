// How the frames leave the node: on CAN, on USB, and when nobody takes them.

#include "constants.h"
#include "world.h"

namespace {

using exoid::Frame;

constexpr auto DEAD = simulated::Mcp2515Model::DEAD_HIGH;

/// What the node says to a command.
std::string answer_to(const std::string& command) {
  world.to_host.clear();
  board.usb.type(command.c_str());
  run_ms(1);
  return world.to_host;
}

/// A settled node whose channel a host has opened.
void open_channel() {
  power_on();
  run_ms(302);
  check(answer_to("C\rS6\r\rO\r").find("\a\r\r\r") == 0, "it opens as python-can opens it");
  world.to_host.clear();
}

/// The same without a CAN controller.
void open_usb() {
  board.can.set_answer(DEAD);
  open_channel();
}

void check_in_order(const std::vector<Frame>& all, uint32_t ticks) {
  std::vector<Frame> frames;
  for (const Frame& frame : all) {
    if (frame.id >= exoid::STATE_ID && frame.id <= exoid::ACC_ID) frames.push_back(frame);
  }
  const std::vector<Frame> states = only(frames, exoid::STATE_ID);
  check(states.size() >= ticks - 1 && states.size() <= ticks, "every tick has its frames");
  uint16_t expected = frames.front().id;
  for (const Frame& frame : frames) {
    check(frame.id == expected, "STATE, RAW and ACC come in this order");
    expected = expected == exoid::ACC_ID ? exoid::STATE_ID : static_cast<uint16_t>(expected + 1);
  }
  for (size_t at = 1; at < states.size(); ++at) {
    const uint32_t step = field(states[at], 48, 8) - field(states[at - 1], 48, 8);
    check((step & 255U) == 1, "no counter is left out");
  }
}

void can_order() {
  power_on();
  run_ms(300);
  world.on_bus.clear();
  run_ms(3000);
  check_in_order(world.on_bus, 300);
  const std::vector<Frame> times = only(world.on_bus, exoid::TIME_ID);
  check(times.size() == 30, "the clock comes ten times a second");
  for (const Frame& time : times) {
    const uint32_t tick = field(time, 0, 32) / exoid::TICK_US;
    check((tick & 255U) == field(time, 32, 8), "clock and counter tell of the same tick");
    check(field(time, 48, 16) == exoid::CONFIG_CRC, "the CRC is this configuration's");
    check(field(time, 40, 8) == 0, "no tick was missed");
  }
  check(world.to_host.empty(), "USB is silent while frames go over CAN");
}

void time_half_a_period_off() {
  power_on();
  for (int pass = 0; pass < 500; ++pass) {
    const size_t before = only(world.on_bus, exoid::TIME_ID).size();
    run_ms(1);
    if (only(world.on_bus, exoid::TIME_ID).size() == before) continue;
    const uint64_t in_tick_us = (board.now_us - board.begin_us) % exoid::TICK_US;
    check(in_tick_us > 5000 && in_tick_us < 6500, "the clock is sent between the ticks");
  }
}

void can_without_acknowledgement() {
  power_on();
  run_ms(300);
  board.can.acknowledged = false;
  run_ms(500);
  const size_t before = world.on_bus.size();
  board.can.acknowledged = true;
  run_ms(500);
  const std::vector<Frame> after(world.on_bus.begin() + static_cast<long>(before),
                                 world.on_bus.end());
  const std::vector<Frame> states = only(after, exoid::STATE_ID);
  uint32_t overruns = 0, gaps = 0;
  for (size_t at = 1; at < states.size(); ++at) {
    const uint32_t step = field(states[at], 48, 8) - field(states[at - 1], 48, 8);
    const bool jumps = (step & 255U) != 1;
    check(!jumps || status(states[at], OVERRUN), "the first STATE after a gap tells of it");
    overruns += status(states[at], OVERRUN);
    gaps += jumps;
  }
  check(gaps == 1 && overruns >= 1 && overruns <= 3, "one gap, told once, then all is well");
  check(!status(states.back(), OVERRUN), "the bit goes out again");
}

void slcan_fallback() {
  board.can.set_answer(DEAD);
  power_on();
  run_ms(302);
  check(world.to_host.empty(), "the node is silent until a host opens the channel");
  check(answer_to("V\r") == "V0101\r" && answer_to("N\r") == "NEXO1\r", "it says what it is");
  check(answer_to("F\r") == "F00\r" && answer_to("\r") == "\r", "it says how it is");
  check(answer_to("t1008\r") == "\a" && answer_to("x\r") == "\a", "it refuses what it cannot do");
  check(answer_to(std::string(100, 'V') + "\r") == "\a", "an endless command does no harm");
  check(answer_to("C\rS6\r\rO\rO\r").find("\a\r\r\r\a") == 0, "a host opens the channel once");
  world.to_host.clear();
  run_ms(3000);
  const std::vector<Frame> frames = frames_in(world.to_host);
  check_in_order(frames, 300);
  const Frame first = only(frames, exoid::STATE_ID).front();
  check(status(first, FILTER_RESET), "who begins to listen hears the filter's start");
  check(answer_to("C\r") == "\r", "the channel closes");
  run_ms(100);
  check(world.to_host == "\r", "and is silent then");
}

void host_that_does_not_read() {
  open_usb();
  run_ms(500);
  board.usb.reads = false;
  run_ms(2000);
  board.usb.reads = true;
  run_ms(500);
  const std::vector<Frame> states = only(frames_in(world.to_host), exoid::STATE_ID);
  uint32_t overruns = 0;
  for (const Frame& state : states) overruns += status(state, OVERRUN);
  check(overruns >= 1 && !status(states.back(), OVERRUN), "lost frames are told");
  const std::vector<Frame> times = only(frames_in(world.to_host), exoid::TIME_ID);
  check(field(times.back(), 40, 8) == 0, "and no tick is missed for them");
  check(answer_to("F\r").find("F02\r") != std::string::npos, "the host can ask for the loss");
}

void host_that_comes_back() {
  open_usb();
  run_ms(100);
  board.usb.unplug();
  run_ms(5000);
  board.usb.plugged = true;
  world.to_host.clear();
  board.usb.type("C\rS6\r\rO\r");
  run_ms(200);
  const std::string text = world.to_host.substr(world.to_host.rfind("\r\r\r") + 3);
  const std::vector<Frame> frames = frames_in(text);
  check_in_order(frames, 20);
  check(status(only(frames, exoid::STATE_ID).front(), FILTER_RESET), "a new recording begins anew");
}

/// A program that says no goodbye: who listens on CAN is told of no loss, and the next program on
/// USB hears nothing that was said before it came.
void program_that_is_killed() {
  open_channel();
  run_ms(500);
  board.usb.reads = false;
  run_ms(200);
  board.usb.let_go();
  run_ms(100);
  world.on_bus.clear();
  run_ms(5000);
  for (const Frame& state : only(world.on_bus, exoid::STATE_ID)) {
    check(!status(state, OVERRUN), "what nobody waits for is not lost");
  }
  world.to_host.clear();
  board.usb.take();
  run_ms(2000);  // for which python-can waits
  check(world.to_host.empty(), "nothing of before is said");
  check(answer_to("C\rS6\r\rO\r").find("\a\r\r\r") == 0, "it opens the channel");
  world.to_host.clear();
  run_ms(500);
  check_in_order(frames_in(world.to_host), 50);
}

/// A host on USB beside one on CAN: it hears the same, and the other is not disturbed.
void usb_beside_can() {
  open_channel();
  world.on_bus.clear();
  run_ms(1000);
  check_in_order(world.on_bus, 100);
  check_in_order(frames_in(world.to_host), 100);
  for (const Frame& state : only(world.on_bus, exoid::STATE_ID)) {
    check(field(state, 56, 8) == 0, "the filter goes on for who listened before");
  }
  board.can.acknowledged = false;
  run_ms(500);
  world.to_host.clear();
  run_ms(500);
  for (const Frame& state : only(frames_in(world.to_host), exoid::STATE_ID)) {
    check(!status(state, OVERRUN), "a bus without listeners is no loss to a host on USB");
  }
}

}  // namespace

std::vector<Scenario> uplink_scenarios() {
  return {
      {"can_order", can_order},
      {"time_half_a_period_off", time_half_a_period_off},
      {"can_without_acknowledgement", can_without_acknowledgement},
      {"slcan_fallback", slcan_fallback},
      {"host_that_does_not_read", host_that_does_not_read},
      {"host_that_comes_back", host_that_comes_back},
      {"program_that_is_killed", program_that_is_killed},
      {"usb_beside_can", usb_beside_can},
  };
}
