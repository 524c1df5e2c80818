/// Where the frames go: onto the CAN bus while a controller answers, and to a host on USB that has
/// opened the channel.

#pragma once

#include "slcan.h"

namespace exoid {

/// `Can` has `begin()`, `poll(now_ms)`, `bool is_up()` and `bool send(const Frame&)`, false where
/// frames were lost; `Port` is a serial port.
template <class Can, class Port>
class Uplink {
 public:
  Uplink(Can& can, Port& port) : can_(can), port_(port) {}

  void begin() { can_.begin(); }

  /// Keeps frames moving. Returns true where a host has just begun to listen, and nobody else does.
  bool poll(uint32_t now_ms) {
    can_.poll(now_ms);
    exchange(slcan_, port_);
    return slcan_.opened() && !can_.is_up();
  }

  /// Queues a frame; returns false where it, or one before, is lost to whoever listens. A host that
  /// has opened the channel counts alone: the bus may have no listener.
  bool send(const Frame& frame) {
    const bool on_bus = can_.send(frame);
    return slcan_.is_open() ? slcan_.send(frame) : on_bus;
  }

 private:
  Can& can_;
  Port& port_;
  Slcan slcan_;
};

}  // namespace exoid
