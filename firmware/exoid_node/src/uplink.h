/// Where the frames go: onto the CAN bus, or to the host on USB where no CAN controller answers.

#pragma once

#include "bus_health.h"
#include "slcan.h"

namespace exoid {

/// `Can` has `bool begin(bit_rate)`, `bool send(const Frame&)`, `bool receive(Frame&)`, `poll()`
/// and `BusHealth health()`; `Port` is a serial port.
template <class Can, class Port>
class Uplink {
 public:
  Uplink(Can& can, Port& port) : can_(can), port_(port) {}

  /// `bit_rate` is that of the CAN bus [bit/s].
  void begin(uint32_t bit_rate) { on_can_ = can_.begin(bit_rate); }

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

  /// Takes away the next frame that came; returns false where there is none.
  bool receive(Frame& frame) { return on_can_ ? can_.receive(frame) : slcan_.received(frame); }

  BusHealth health() { return on_can_ ? can_.health() : BusHealth{false, 0, 0, false}; }

 private:
  Can& can_;
  Port& port_;
  Slcan slcan_;
  bool on_can_ = false;
};

}  // namespace exoid
