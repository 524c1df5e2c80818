/// Where the frames go: onto the CAN bus while a controller answers, and to a host on USB that has
/// opened the channel. Commands come by both.

#pragma once

#include "slcan_port.h"

namespace exoid {

/// `Can` has `begin(bit_rate)`, `poll(now_ms)`, `bool is_up()`, `bool send(const Frame&)`, false
/// where frames were lost, and `bool receive(Frame&)`; `Port` is a serial port.
template <class Can, class Port>
class Uplink {
 public:
  Uplink(Can& can, Port& port) : can_(can), port_(port) {}

  /// `bit_rate` is that of the CAN bus [bit/s].
  void begin(uint32_t bit_rate) { can_.begin(bit_rate); }

  /// Keeps frames moving. Returns true where a host has just begun to listen.
  bool poll(uint32_t now_ms) {
    can_.poll(now_ms);
    exchange(slcan_, port_);
    return slcan_.opened();
  }

  bool is_on_can() const { return can_.is_up(); }

  /// Queues a frame; returns false where it, or one before, is lost to whoever listens. A host that
  /// has opened the channel counts alone: the bus may have no listener.
  bool send(const Frame& frame) {
    const bool on_bus = can_.send(frame);
    return slcan_.is_open() ? slcan_.send(frame) : on_bus;
  }

  /// Takes away the next frame that came; returns false where there is none.
  bool receive(Frame& frame) { return slcan_.received(frame) || can_.receive(frame); }

 private:
  Can& can_;
  Port& port_;
  Slcan slcan_;
};

}  // namespace exoid
