// A serial port that, as the board's core does, loses what it had taken and says SIZE_MAX.

#include "slcan_port.h"
#include "world.h"

namespace {

using exoid::Frame;

constexpr uint8_t FRAMES = 60;
constexpr size_t LINE = 21;  // of a frame, without its end

/// What was written last before write `lost_at` never gets to the host.
struct LosingPort {
  LosingPort(size_t most, uint32_t lost) : room(most), lost_at(lost) {}

  const size_t room;
  const uint32_t lost_at;
  std::string got;
  uint32_t writes = 0;
  size_t last = 0;

  int available() { return 0; }
  int read() { return -1; }
  int availableForWrite() { return static_cast<int>(room); }
  bool hung_up() { return false; }
  size_t write(const uint8_t* bytes, size_t count) {
    if (++writes == lost_at) {
      got.resize(got.size() - last);
      return SIZE_MAX;
    }
    last = count;
    got.append(reinterpret_cast<const char*>(bytes), count);
    return count;
  }
};

/// Sends frames of eight equal bytes each; returns how many losses were told.
uint32_t send_all(LosingPort& port) {
  exoid::Slcan slcan;
  for (char character : {'O', '\r'}) slcan.receive(character);
  uint32_t told = 0;
  for (uint8_t at = 0; at < FRAMES; ++at) {
    told += !slcan.send(Frame{0x101, {at, at, at, at, at, at, at, at}});
    for (int poll = 0; poll < 30; ++poll) exchange(slcan, port);
  }
  return told;
}

/// The lines that look like frames, each of which must be one that was sent.
size_t whole_lines(const std::string& text) {
  size_t whole = 0;
  for (size_t at = 0, end; (end = text.find('\r', at)) != std::string::npos; at = end + 1) {
    const std::string line = text.substr(at, end - at);
    check(line.size() <= LINE, "no piece of a line runs into the next");
    check(line.empty() || line[0] == 't', "no piece of a line comes without its begin");
    if (line.size() < LINE) continue;
    ++whole;
    for (size_t byte = 5; byte < LINE; byte += 2) {
      check(line.substr(byte, 2) == line.substr(5, 2), "a whole line is one frame");
    }
  }
  return whole;
}

void check_loss(size_t room, uint32_t lost_at) {
  LosingPort port(room, lost_at);
  check(send_all(port) == 1, "the loss is told, once");
  const size_t touched = (room + LINE) / (LINE + 1) + 1;  // lines that a packet is part of
  check(whole_lines(port.got) + touched + 1 >= FRAMES, "no more is lost than that, and a line");
}

void port_that_loses() {
  for (size_t room = 1; room < 64; ++room) {
    for (uint32_t lost_at = 2; lost_at < 40; ++lost_at) check_loss(room, lost_at);
  }
}

void loss_where_the_count_wraps() {
  const size_t room = 7;  // a frame is four packets, and the count wraps in its 47th
  for (uint32_t lost_at = 180; lost_at < 200; ++lost_at) check_loss(room, lost_at);
}

}  // namespace

std::vector<Scenario> port_scenarios() {
  return {
      {"port_that_loses", port_that_loses},
      {"loss_where_the_count_wraps", loss_where_the_count_wraps},
  };
}
