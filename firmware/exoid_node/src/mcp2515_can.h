/// The CAN bus by an MCP2515 and the library ACAN2515, whose queue keeps frames in order.

#pragma once

#include <ACAN2515.h>
#include <SPI.h>

#include "config.h"
#include "frame.h"

namespace exoid {

class Mcp2515Can {
 public:
  /// Sets the controller up. Returns false where none answers or the bus holds it down.
  bool begin() {
    SPI.begin();
    ACAN2515Settings settings(config::CAN_CRYSTAL, config::CAN_BIT_RATE);
    settings.mReceiveBufferSize = 1;  // the node does not listen
    return driver_.begin(settings, nullptr) == 0;
  }

  /// Queues a frame; returns false where the queue is full, as it is when nobody acknowledges.
  bool send(const Frame& frame) {
    CANMessage message;
    message.id = frame.id;
    message.len = sizeof(frame.data);
    for (uint8_t at = 0; at < sizeof(frame.data); ++at) message.data[at] = frame.data[at];
    return driver_.tryToSend(message);
  }

  /// Hands the next queued frame to the controller when it has sent the last one.
  void poll() { driver_.poll(); }

 private:
  static constexpr uint8_t NO_INTERRUPT_PIN = 255;

  ACAN2515 driver_{config::CAN_SELECT_PIN, SPI, NO_INTERRUPT_PIN};
};

}  // namespace exoid
