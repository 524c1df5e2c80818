/// Where the frames go: onto the CAN bus, or to the host on USB where no CAN controller answers.

#pragma once

#include "slcan.h"

namespace exoid {

/// `Can` has `bool begin()`, `bool send(const Frame&)` and `poll()`; `Port` is a serial port.
template <class Can, class Port>
class Uplink {
 public:
  Uplink(Can& can, Port& port) : can_(can), port_(port) {}

  void begin() { on_can_ = can_.begin(); }

  /// Keeps frames moving. Returns true where a host has just begun to listen.
  bool poll() {
    if (on_can_) {
      can_.poll();
      return false;
    }
    exchange(slcan_, port_);
    return slcan_.opened();
  }

  /// Queues a frame; returns false where it is lost.
  bool send(const Frame& frame) { return on_can_ ? can_.send(frame) : slcan_.send(frame); }

 private:
  Can& can_;
  Port& port_;
  Slcan slcan_;
  bool on_can_ = false;
};

}  // namespace exoid
