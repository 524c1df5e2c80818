// The simulated board: what the stubs of Arduino's libraries do to the world and it to them.

#include "world.h"

#include <ACAN2515.h>
#include <Arduino.h>
#include <SPI.h>
#include <Wire.h>

#include "constants.h"
#include "timer_samd21.h"

World world;
UsbSerial Serial;
TwoWire Wire;
SPIClass SPI;

namespace {

constexpr uint32_t FRAME_US = 270;       // on a CAN bus of 500 kbit/s
constexpr uint32_t USB_TIMEOUT_US = 70000;  // for which the board waits for a host once

bool data_pulled = false, clock_pulled = false;  // by the sketch
uint64_t timer_begin_us = 0;
bool host_was_late = false;

bool data_is_low() { return data_pulled || world.data_held_for > 0; }
bool clock_is_low() { return clock_pulled || world.clock_held; }

/// Shows the sensors the leg, once a tick.
void expose() {
  static uint32_t exposed = 0;
  const uint32_t tick = exoid::SamplingTimer().ticks();
  if (tick == exposed) return;
  exposed = tick;
  world.board.expose(world.leg(tick));
}

/// Time on the bus; a real one would wait for ever on a line that is held down.
void transfer(size_t bytes) {
  check(!data_is_low() && !clock_is_low(), "Wire is never used on a bus that is held down");
  check(world.i2c_frequency == 400000, "the I2C bus runs at 400 kHz");
  world.now_us += bytes * 9 * 1000000 / world.i2c_frequency;
  expose();
}

}  // namespace

void pinMode(uint8_t pin, uint8_t mode) {
  const bool pulled = mode == OUTPUT;
  if (pin == PIN_WIRE_SCL) {
    if (clock_pulled && !pulled && world.data_held_for > 0) --world.data_held_for;
    clock_pulled = pulled;
  }
  if (pin == PIN_WIRE_SDA) data_pulled = pulled;
}

void digitalWrite(uint8_t, uint8_t level) {
  check(level == LOW, "the sketch never drives an I2C line high");
}

int digitalRead(uint8_t pin) {
  return (pin == PIN_WIRE_SDA ? data_is_low() : clock_is_low()) ? LOW : HIGH;
}

void delayMicroseconds(uint32_t time) { world.now_us += time; }

void TwoWire::begin() { data_pulled = clock_pulled = false; }

void TwoWire::end() {}

void TwoWire::setClock(uint32_t frequency) { world.i2c_frequency = frequency; }

void TwoWire::beginTransmission(uint8_t device) {
  device_ = device;
  sent_count_ = 0;
}

size_t TwoWire::write(uint8_t byte) {
  check(sent_count_ < sizeof sent_, "no transfer writes more than a register");
  sent_[sent_count_++] = byte;
  return 1;
}

uint8_t TwoWire::endTransmission(bool) {
  transfer(1 + sent_count_);
  uint8_t nothing;
  const bool taken = sent_count_ == 1 ? world.board.read(device_, sent_[0], &nothing, 0)
                                      : world.board.write(device_, sent_[0], sent_[1]);
  return taken ? 0 : 2;
}

uint8_t TwoWire::requestFrom(uint8_t device, size_t count) {
  check(count <= sizeof received_, "no transfer reads more than the library's buffer");
  transfer(1 + count);
  const bool came = world.board.read(device, sent_[0], received_, static_cast<uint8_t>(count));
  received_count_ = came ? count : 0;
  taken_ = 0;
  return static_cast<uint8_t>(received_count_);
}

int TwoWire::read() { return taken_ < received_count_ ? received_[taken_++] : -1; }

int UsbSerial::available() { return static_cast<int>(world.from_host.size()); }

int UsbSerial::read() {
  const char character = world.from_host.front();
  world.from_host.erase(0, 1);
  return character;
}

size_t UsbSerial::write(const uint8_t* bytes, size_t count) {
  check(count <= 63, "a write fits one USB packet");
  if (!world.plugged) return 0;
  if (!world.host_reads) {
    if (!host_was_late) world.now_us += USB_TIMEOUT_US;
    host_was_late = true;
    return 0;
  }
  host_was_late = false;
  world.to_host.append(reinterpret_cast<const char*>(bytes), count);
  return count;
}

uint16_t ACAN2515::begin(const ACAN2515Settings& settings, void (*service)(), ACAN2515Mask mask,
                         const ACAN2515AcceptanceFilter filters[], uint8_t filter_count) {
  check(select_ == 10 && interrupt_ == 255 && service == nullptr, "the controller is polled");
  check(filter_count == 1, "one filter suits the mask");
  mask_ = mask.identifier;
  filter_ = filters[0].mMask.identifier;
  world.bit_rate = settings.bit_rate;
  queue_size_ = settings.mTransmitBuffer0Size;
  return world.has_controller ? 0 : 1;
}

bool ACAN2515::receive(CANMessage& message) {
  while (!world.to_node.empty()) {
    const exoid::Frame frame = world.to_node.front();
    world.to_node.erase(world.to_node.begin());
    if ((frame.id & mask_) != (filter_ & mask_)) continue;
    message = {};
    message.id = frame.id;
    message.len = 8;
    for (int at = 0; at < 8; ++at) message.data[at] = frame.data[at];
    return true;
  }
  return false;
}

uint8_t ACAN2515::transmitErrorCounter() { return world.transmit_errors; }

uint8_t ACAN2515::errorFlagRegister() { return world.bus_off ? 0x20 : 0; }

bool ACAN2515::tryToSend(const CANMessage& message) {
  check(message.len == 8 && !message.ext && !message.rtr, "every frame is classic, of 8 bytes");
  if (head_ - tail_ > queue_size_) return false;
  if (head_ == tail_) started_us_ = world.now_us;
  waiting_[head_++ % LONGEST] = message;
  return true;
}

void ACAN2515::poll() {
  if (head_ == tail_ || !world.acknowledged || world.now_us < started_us_ + FRAME_US) return;
  const CANMessage& sent = waiting_[tail_++ % LONGEST];
  exoid::Frame frame = {static_cast<uint16_t>(sent.id), {}};
  for (int at = 0; at < 8; ++at) frame.data[at] = sent.data[at];
  world.on_bus.push_back(frame);
  started_us_ = world.now_us;
}

namespace exoid {

void SamplingTimer::begin() { timer_begin_us = world.now_us; }

uint32_t SamplingTimer::ticks() const {
  return static_cast<uint32_t>((world.now_us - timer_begin_us) / exoid::TICK_US);
}

uint32_t SamplingTimer::age_us() const {
  return static_cast<uint32_t>((world.now_us - timer_begin_us) % exoid::TICK_US);
}

}  // namespace exoid
