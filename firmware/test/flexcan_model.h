/// The FlexCAN module on a bus of 500 kbit/s, by its registers, after IMXRT1060RM chapter 44: reset
/// values, freeze mode, mailbox codes, what a soft reset leaves alone, and the erratum ERR005829.

#pragma once

#include <stdint.h>

#include <functional>
#include <vector>

#include "frame.h"

namespace simulated {

class FlexCanModel {
 public:
  enum Answer : uint8_t { ANSWERS, DEAD_LOW, DEAD_HIGH };

  explicit FlexCanModel(const uint64_t& now_us) : now_us_(now_us) {}

  std::function<void(const exoid::Frame&)> on_frame;  // one was on the bus
  Answer answer = ANSWERS;
  bool acknowledged = true, shorted = false, stays_off = false;
  bool overlooks = false;  // the next request comes in the moment of the erratum
  bool moves_in = false;   // a frame that has come is just being put into its mailbox

  void begin() { clocked_ = true; }

  uint32_t read(uint32_t at) {
    if (answer != ANSWERS || !clocked_) return answer == DEAD_HIGH ? 0xFFFFFFFF : 0;
    advance();
    if (at == MCR) return mcr_ | (is_frozen() ? FROZEN | NOT_READY : 0);
    return word(at) | (moves_in && is_head(at) ? BUSY : 0);
  }

  void write(uint32_t at, uint32_t value) {
    if (answer != ANSWERS || !clocked_) return;
    advance();
    if (at == MCR) return write_mcr(value);
    if (at == IFLAG1) {
      word(at) &= ~value;
      return;
    }
    if ((at == CTRL1 || at >= MASKS) && !is_frozen()) return;  // written in freeze mode alone
    word(at) = value;
    if (is_head(at) && code(value) == 12) request(at);
    if (is_head(at) && code(value) == 8 && overlooked_) request(sender_);
  }

  /// A disturbance stops it; its settings stay.
  void fall_out() { mcr_ |= FREEZE | HALT; }

  /// A disturbance turns its bit timing.
  void forget() { word(CTRL1) = 0; }

  /// A frame of another node.
  void hear(uint32_t id, bool extended, bool remote, uint8_t length) {
    advance();
    for (uint32_t at = 0; at < 16 && runs(); ++at) {
      uint32_t* box = &word(0x80 + 16 * at);
      const bool waits = code(box[0]) == 4 || code(box[0]) == 2 || code(box[0]) == 6;
      const uint32_t place = extended ? id : id << 18, mask = word(MASKS + 4 * at);
      const bool is_kind = ((box[0] >> 21 & 1) != 0) == extended;
      if (!waits || !is_kind || (place & mask) != (box[1] & mask)) continue;
      const uint32_t full = (word(IFLAG1) >> at & 1) != 0 ? 6U : 2U;
      box[0] = full << 24 | (extended ? 3U << 21 : 0) | (remote ? 1U << 20 : 0) | length * 0x10000U;
      box[1] = place;
      box[2] = 0x01020304;
      box[3] = 0x05060708;
      word(IFLAG1) |= 1U << at;
      return;
    }
  }

  /// Does what is due on the bus.
  void advance() {
    if (!runs()) return;
    uint32_t& errors = word(ESR1);
    if (shorted && sending_) errors |= 0x20;
    if ((errors & 0x20) != 0) {
      if (shorted || stays_off) rejoins_us_ = now_us_ + 2816;  // 128 * 11 bits
      if (now_us_ < rejoins_us_ || rejoins_us_ == 0) return;
      errors = 0;
      sent_us_ = now_us_ + FRAME_US;
    }
    if (!sending_ || overlooked_) return;
    if (!acknowledged) {
      errors |= 0x10;
      word(ECR) = 128;
      sent_us_ = now_us_ + FRAME_US;
      return;
    }
    if (now_us_ >= sent_us_) send();
  }

 private:
  static constexpr uint32_t MCR = 0, CTRL1 = 4, ECR = 0x1C, ESR1 = 0x20;
  static constexpr uint32_t IFLAG1 = 0x30, MASKS = 0x880;
  static constexpr uint32_t DISABLED = 1U << 31, FREEZE = 1U << 30, HALT = 1U << 28;
  static constexpr uint32_t NOT_READY = 1U << 27, RESET = 1U << 25, FROZEN = 1U << 24;
  static constexpr uint32_t AFTER_RESET = 0x5080000F;  // but for MDIS, which a soft reset keeps
  static constexpr uint64_t FRAME_US = 270;

  static constexpr uint32_t BUSY = 1U << 24;  // of a mailbox's code

  static bool is_head(uint32_t at) { return at >= 0x80 && at < 0x180 && at % 16 == 0; }
  static uint32_t code(uint32_t head) { return head >> 24 & 15; }
  uint32_t& word(uint32_t at) { return words_[at / 4]; }
  bool is_frozen() const { return (mcr_ & DISABLED) == 0 && (mcr_ & FREEZE) && (mcr_ & HALT); }

  bool runs() {
    const uint32_t timing = word(CTRL1);
    const uint32_t quanta = 4 + (timing & 7) + (timing >> 19 & 7) + (timing >> 16 & 7);
    const bool in_time = ((timing >> 24) + 1) * quanta == 48;  // 24 MHz over 500 kbit/s
    return (mcr_ & DISABLED) == 0 && !is_frozen() && in_time;
  }

  void write_mcr(uint32_t value) {
    const bool resets = (value & RESET) != 0 && (mcr_ & DISABLED) == 0;
    mcr_ = resets ? AFTER_RESET : value & ~(RESET | FROZEN | NOT_READY);
    if (resets) word(ESR1) = word(IFLAG1) = word(ECR) = 0;
  }

  void request(uint32_t at) {
    sender_ = at;
    sending_ = true;
    overlooked_ = overlooks;
    overlooks = false;
    sent_us_ = now_us_ + FRAME_US;
  }

  void send() {
    uint32_t* box = &word(sender_);
    exoid::Frame frame = {static_cast<uint16_t>(box[1] >> 18), {}};
    for (int at = 0; at < 8; ++at) {
      frame.data[at] = static_cast<uint8_t>(box[2 + at / 4] >> (24 - 8 * (at % 4)));
    }
    box[0] = (box[0] & 0x00FFFFFF) | 8U << 24;
    word(ESR1) = word(ECR) = 0;
    sending_ = false;
    if (on_frame) on_frame(frame);
  }

  const uint64_t& now_us_;
  std::vector<uint32_t> words_ = std::vector<uint32_t>(0x900 / 4);
  uint32_t mcr_ = AFTER_RESET | DISABLED;
  uint32_t sender_ = 0x80;
  uint64_t sent_us_ = 0, rejoins_us_ = 0;
  bool clocked_ = false, sending_ = false, overlooked_ = false;
};

}  // namespace simulated
