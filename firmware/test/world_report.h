/// Writes what is heard of the node; when told to be quiet, only what is not as it should be.

#pragma once

#include "exo_can.h"
#include "world_events.h"
#include "world_files.h"

namespace world_events {

class Report {
 public:
  explicit Report(world_files::File& file) : file_(file) {}

  bool quiet = false;

  void write(uint64_t at_us, Link link, uint32_t id, const uint8_t* data, uint32_t count) {
    Heard heard = {static_cast<uint32_t>(at_us / 1000), link, static_cast<uint16_t>(id), {}};
    for (uint32_t at = 0; at < count; ++at) heard.data[at] = data[at];
    if (!file_.write(&heard, sizeof heard)) world_files::end(97);
  }

  void frame(uint64_t at_us, const exoid::Frame& frame) {
    if (!quiet || is_news(frame)) write(at_us, ON_CAN, frame.id, frame.data, 8);
  }

  /// A packet in pieces of eight bytes.
  void packet(uint64_t at_us, const uint8_t* bytes, uint32_t count) {
    for (uint32_t at = 0; at < count; at += 8) {
      const uint32_t piece = count - at < 8 ? count - at : 8;
      write(at_us, ON_USB, piece, bytes + at, piece);
    }
  }

 private:
  /// A status bit, a counter that jumps, and a number of missed ticks that changes.
  bool is_news(const exoid::Frame& frame) {
    if (frame.id == exoid::STATE_ID) {
      const bool jumps = static_cast<uint8_t>(counter_ + 1) != frame.data[6];
      counter_ = frame.data[6];
      return jumps || frame.data[7] != 0;
    }
    if (frame.id != exoid::TIME_ID) return false;
    const bool more = missed_ != frame.data[5];
    missed_ = frame.data[5];
    return more;
  }

  world_files::File& file_;
  uint8_t counter_ = 0, missed_ = 0;
};

}  // namespace world_events
