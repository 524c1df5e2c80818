/// The library ACAN2515 as far as the sketch uses it: one transmit buffer of an MCP2515 and a queue
/// of 16 frames before it, on a bus that may acknowledge or not.

#pragma once

#include "Arduino.h"
#include "SPI.h"

struct CANMessage {
  uint32_t id = 0;
  bool ext = false;
  bool rtr = false;
  uint8_t len = 0;
  uint8_t data[8] = {};
};

struct ACAN2515Settings {
  ACAN2515Settings(uint32_t crystal, uint32_t rate) : crystal_frequency(crystal), bit_rate(rate) {}
  const uint32_t crystal_frequency, bit_rate;
  uint16_t mReceiveBufferSize = 32;
  uint16_t mTransmitBuffer0Size = 16;
};

struct ACAN2515Mask {
  uint16_t identifier;
};

inline ACAN2515Mask standard2515Mask(uint16_t identifier, uint8_t, uint8_t) { return {identifier}; }
inline ACAN2515Mask standard2515Filter(uint16_t identifier, uint8_t, uint8_t) {
  return {identifier};
}

struct ACAN2515AcceptanceFilter {
  const ACAN2515Mask mMask;
  void (*const mCallBack)(const CANMessage&);
};

class ACAN2515 {
 public:
  ACAN2515(uint8_t select, SPIClass&, uint8_t interrupt) : select_(select), interrupt_(interrupt) {}

  uint16_t begin(const ACAN2515Settings& settings, void (*service)(), ACAN2515Mask mask,
                 const ACAN2515AcceptanceFilter filters[], uint8_t filter_count);
  bool tryToSend(const CANMessage& message);
  bool receive(CANMessage& message);
  void poll();
  uint8_t transmitErrorCounter();
  uint8_t receiveErrorCounter() { return 0; }
  uint8_t errorFlagRegister();

 private:
  const uint8_t select_, interrupt_;
  static constexpr size_t LONGEST = 17;  // the queue and the frame that is being sent
  uint16_t mask_ = 0, filter_ = 0;  // of what the controller lets in
  size_t queue_size_ = 0;
  CANMessage waiting_[LONGEST];  // a ring
  size_t head_ = 0, tail_ = 0;   // frames ever queued, ever sent; the one at `tail_` is being sent
  uint64_t started_us_ = 0;
};
