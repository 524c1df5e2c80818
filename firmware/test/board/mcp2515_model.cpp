#include "mcp2515_model.h"

#include "sinks.h"

namespace simulated {

namespace {

constexpr uint8_t CANSTAT = 0x0E, CANCTRL = 0x0F, TEC = 0x1C, CNF3 = 0x28, CNF2 = 0x29, CNF1 = 0x2A;
constexpr uint8_t CANINTF = 0x2C, EFLG = 0x2D, TXB0 = 0x30, RXB[2] = {0x60, 0x70};
constexpr uint8_t REQUESTED = 0x08, OFF = 0x20, PASSIVE = 0x10;
constexpr uint32_t FRAME_US = 270, RETRY_US = 300, REJOIN_US = 3000;
constexpr uint32_t CRYSTAL = 8000000;

uint32_t bit_rate_of(const uint8_t* registers) {
  const uint32_t quanta = 4 + (registers[CNF2] & 7U) + (registers[CNF2] >> 3 & 7U) +
                          (registers[CNF3] & 7U);
  return CRYSTAL / 2 / ((registers[CNF1] & 63U) + 1) / quanta;
}

}  // namespace

void Mcp2515Model::power_on() {
  for (uint8_t& each : registers_) each = 0xA5;  // filters and buffers begin with anything
  for (uint8_t at = 0x0C; at < 0x10; ++at) registers_[at] = 0;
  for (uint8_t at = 0x1C; at < 0x1E; ++at) registers_[at] = 0;
  for (uint8_t at = 0x28; at < 0x31; ++at) registers_[at] = 0;
  registers_[CANSTAT] = 0x80;
  registers_[CANCTRL] = 0x87;
  registers_[0x40] = registers_[0x50] = registers_[RXB[0]] = registers_[RXB[1]] = 0;
  count_errors(0);
}

void Mcp2515Model::count_errors(uint16_t errors) {
  errors_ = errors;
  registers_[TEC] = static_cast<uint8_t>(errors);
}

void Mcp2515Model::set_answer(Answer answer) {
  if (answer == ANSWERS && answer_ != ANSWERS) power_on();
  answer_ = answer;
}

void Mcp2515Model::select() {
  advance();
  count_ = 0;
}

void Mcp2515Model::deselect() {
  if (answer_ != ANSWERS) return;
  if (command_ == 0x90) registers_[CANINTF] &= 0xFE;
  if (command_ == 0x94) registers_[CANINTF] &= 0xFD;
  command_ = 0;
}

uint8_t Mcp2515Model::transfer(uint8_t byte) {
  now_us_ += 1;
  if (answer_ != ANSWERS) return answer_ == DEAD_HIGH ? 0xFF : 0x00;
  ++count_;
  if (count_ == 1) return command(byte);
  switch (command_) {
    case 0x02:
      if (count_ == 2) at_ = byte & 127U;
      if (count_ > 2) put(at_++ & 127U, byte);
      return 0;
    case 0x03:
      if (count_ == 2) at_ = byte & 127U;
      return count_ == 2 ? 0 : stored(at_++ & 127U);
    case 0xA0: return status();
    case 0x40: registers_[at_++ & 127U] = byte; return 0;
    case 0x90:
    case 0x94: return registers_[at_++ & 127U];
    default: violated("every SPI command is one of the MCP2515");
  }
}

/// Mode and control are seen at the end of every row.
uint8_t Mcp2515Model::stored(uint8_t at) const {
  return registers_[(at & 15U) < CANSTAT ? at : at & 15U];
}

/// The first byte of a command.
uint8_t Mcp2515Model::command(uint8_t byte) {
  command_ = byte;
  if (byte == 0xC0) {
    power_on();
    ++starts_;
  }
  if (byte == 0x40) at_ = TXB0 + 1;
  if (byte == 0x90 || byte == 0x94) at_ = static_cast<uint8_t>(RXB[byte == 0x94] + 1);
  if (byte == 0x81 && is_normal()) {
    if (bit_rate_of(registers_) != bit_rate) violated("the node keeps the bit rate of its bus");
    registers_[TXB0] |= REQUESTED;
    done_us_ = now_us_ + FRAME_US;
  }
  return 0;
}

void Mcp2515Model::put(uint8_t at, uint8_t value) {
  const bool is_setting = at < 0x0C || (at >= 0x10 && at < 0x1C) || (at >= 0x20 && at <= CNF1);
  if (is_setting && (registers_[CANSTAT] & 0xE0) != 0x80) return;  // only while it is configured
  if (at == CANSTAT || at == TEC) return;
  registers_[at] = value;
  // It joins a bus after eleven recessive bits.
  if (at == CANCTRL && !shorted) registers_[CANSTAT] = value & 0xE0;
}

uint8_t Mcp2515Model::status() const {
  return static_cast<uint8_t>((registers_[CANINTF] & 3U) | (registers_[TXB0] & REQUESTED) >> 1);
}

void Mcp2515Model::advance() {
  if (answer_ != ANSWERS) return;
  const bool waits = (registers_[CANCTRL] & 0xE0) == 0 && (registers_[CANSTAT] & 0xE0) == 0x80;
  if (waits && !shorted) registers_[CANSTAT] = 0;
  if (shorted) return go_off(now_us_);
  if (registers_[EFLG] & OFF) {
    if (stays_off || now_us_ < done_us_) return;
    registers_[EFLG] = 0;
    count_errors(0);
    done_us_ = now_us_ + FRAME_US;
  }
  if (is_normal() && (registers_[TXB0] & REQUESTED) && now_us_ >= done_us_) send(done_us_);
}

/// The end of a frame that was sent, or of one that nobody acknowledged and that is sent again.
void Mcp2515Model::send(uint64_t at_us) {
  if (!acknowledged) {
    count_errors(static_cast<uint16_t>(errors_ < 128 ? errors_ + 8 : 128));
    registers_[EFLG] = errors_ < 128 ? 0 : PASSIVE;
    done_us_ = now_us_ + RETRY_US;
    return;
  }
  registers_[TXB0] = static_cast<uint8_t>(registers_[TXB0] & ~REQUESTED);
  const uint8_t* from = registers_ + TXB0 + 1;
  exoid::Frame frame = {static_cast<uint16_t>(from[0] << 3 | from[1] >> 5), {}};
  if (from[4] != 8 || (from[1] & 0x08)) violated("every frame is classic, of 8 bytes");
  for (uint8_t at = 0; at < 8; ++at) frame.data[at] = from[5 + at];
  count_errors(static_cast<uint16_t>(errors_ > 0 ? errors_ - 1 : 0));
  if (errors_ == 0) registers_[EFLG] = 0;
  on_can_frame(frame, at_us);
}

/// A shorted bus takes the controller off it within a few frames.
void Mcp2515Model::go_off(uint64_t at_us) {
  if (!is_normal() || !(registers_[TXB0] & REQUESTED)) return;
  registers_[EFLG] = OFF;
  done_us_ = at_us + REJOIN_US;
}

void Mcp2515Model::hear(uint32_t id, bool extended, uint8_t length) {
  const uint8_t data[8] = {0xE0, 0xE1, 0xE2, 0xE3, 0xE4, 0xE5, 0xE6, 0xE7};
  hear(id, extended, length, data);
}

void Mcp2515Model::hear(const exoid::Frame& frame) { hear(frame.id, false, 8, frame.data); }

void Mcp2515Model::hear(uint32_t id, bool extended, uint8_t length, const uint8_t* data) {
  if (answer_ != ANSWERS || !is_normal()) return;
  const bool first = accepts(0, id, extended), rolls = (registers_[RXB[0]] & 0x04) != 0;
  if (first && !(registers_[CANINTF] & 1U)) return keep(0, id, extended, length, data);
  const bool second = accepts(1, id, extended) || (first && rolls);
  if (second && !(registers_[CANINTF] & 2U)) keep(1, id, extended, length, data);
}

bool Mcp2515Model::accepts(uint8_t buffer, uint32_t id, bool extended) const {
  if (hears_all || (registers_[RXB[buffer]] & 0x60) == 0x60) return true;
  const uint8_t* mask = registers_ + 0x20 + 4 * buffer;
  const uint32_t relevant = static_cast<uint32_t>(mask[0] << 3 | mask[1] >> 5);
  const uint32_t standard = extended ? id >> 18 : id;
  for (uint8_t at = buffer == 0 ? 0 : 2; at < (buffer == 0 ? 2 : 6); ++at) {
    const uint8_t* filter = registers_ + (at < 3 ? 4 * at : 0x10 + 4 * (at - 3));
    const uint32_t wanted = static_cast<uint32_t>(filter[0] << 3 | filter[1] >> 5);
    const bool same_kind = ((filter[1] & 0x08) != 0) == extended;
    if (same_kind && ((wanted ^ standard) & relevant) == 0) return true;
  }
  return false;
}

void Mcp2515Model::keep(uint8_t buffer, uint32_t id, bool extended, uint8_t length,
                        const uint8_t* data) {
  uint8_t* to = registers_ + RXB[buffer] + 1;
  const uint32_t standard = extended ? id >> 18 : id;
  to[0] = static_cast<uint8_t>(standard >> 3);
  to[1] = static_cast<uint8_t>(standard << 5 | (extended ? 0x08U : 0U));
  to[4] = length;
  for (uint8_t at = 0; at < 8; ++at) to[5 + at] = data[at];
  registers_[CANINTF] = static_cast<uint8_t>(registers_[CANINTF] | (1U << buffer));
  ++received_;
}

}  // namespace simulated
