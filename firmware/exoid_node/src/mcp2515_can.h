/// The CAN bus by an MCP2515 and the library ACAN2515, whose queue keeps frames in order.

#pragma once

#include <ACAN2515.h>
#include <SPI.h>

#include "bus_health.h"
#include "config.h"
#include "exo_commands.h"

namespace exoid {

class Mcp2515Can {
 public:
  /// Sets the controller up. Returns false where none answers or the bus holds it down.
  bool begin(uint32_t bit_rate) {
    SPI.begin();
    ACAN2515Settings settings(config::CAN_CRYSTAL, bit_rate);
    settings.mReceiveBufferSize = 4;  // commands, which the controller parts from all else
    const ACAN2515Mask mask = standard2515Mask(COMMANDS_MASK, 0, 0);
    const ACAN2515AcceptanceFilter commands[] = {{standard2515Filter(COMMANDS_ID, 0, 0), nullptr}};
    return driver_.begin(settings, nullptr, mask, commands, 1) == 0;
  }

  /// Queues a frame; returns false where the queue is full, as it is when nobody acknowledges.
  bool send(const Frame& frame) {
    CANMessage message;
    message.id = frame.id;
    message.len = sizeof(frame.data);
    for (uint8_t at = 0; at < sizeof(frame.data); ++at) message.data[at] = frame.data[at];
    return driver_.tryToSend(message);
  }

  /// Takes away the next frame that could be a command; returns false where there is none.
  bool receive(Frame& frame) {
    CANMessage message;
    if (!driver_.receive(message)) return false;
    if (message.ext || message.rtr || message.len != sizeof(frame.data)) return false;
    frame.id = static_cast<uint16_t>(message.id);
    for (uint8_t at = 0; at < sizeof(frame.data); ++at) frame.data[at] = message.data[at];
    return true;
  }

  BusHealth health() {
    return {true, driver_.transmitErrorCounter(), driver_.receiveErrorCounter(),
            (driver_.errorFlagRegister() & BUS_OFF) != 0};
  }

  /// Hands the next queued frame to the controller when it has sent the last one.
  void poll() { driver_.poll(); }

 private:
  static constexpr uint8_t NO_INTERRUPT_PIN = 255;
  static constexpr uint8_t BUS_OFF = 0x20;  // TXBO of EFLG

  ACAN2515 driver_{config::CAN_SELECT_PIN, SPI, NO_INTERRUPT_PIN};
};

}  // namespace exoid
