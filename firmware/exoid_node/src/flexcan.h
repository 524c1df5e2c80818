/// FlexCAN, the CAN controller inside NXP's processors, by its registers. Nothing here waits: what
/// takes time is looked at again at the next poll, and a controller that is not as it was set up is
/// started again.
///
/// Registers: i.MX RT1060 Processor Reference Manual (IMXRT1060RM), 44.9, page 2555; addresses and
/// bits as in imxrt_flexcan.h of FlexCAN_T4, the order of the start as in its FlexCAN_T4.tpp.

#pragma once

#include "can_ids.h"
#include "can_timing.h"
#include "frame.h"
#include "frame_queue.h"

namespace exoid {

/// `Registers` has `begin()`, which turns clock and pins on, `uint32_t read(offset)` and
/// `write(offset, value)`. Half of `CLOCK` is the controller's [Hz], `Ids` has the frames to listen
/// to.
template <class Registers, uint32_t CLOCK, class Ids>
class FlexCan {
 public:
  explicit FlexCan(Registers& registers) : registers_(registers) {}

  /// `bit_rate` is one that the clock can do [bit/s].
  void begin(uint32_t bit_rate) {
    const uint32_t quanta = best_quanta(CLOCK, bit_rate);
    timing_ = timing_of(CLOCK / (2 * bit_rate * quanta), quanta);
    registers_.begin();
  }

  /// Whether the controller is on the bus.
  bool is_up() const { return state_ == UP; }

  /// Times it was set up, its error counters, and whether it has left the bus for errors.
  uint32_t starts() const { return starts_; }
  uint8_t transmit_errors() const { return static_cast<uint8_t>(is_up() ? errors_ : 0); }
  uint8_t receive_errors() const { return static_cast<uint8_t>(is_up() ? errors_ >> 8 : 0); }
  bool is_off() const { return is_up() && off_ > 0; }

  /// Queues a frame. Returns false where a frame was lost, this one or one since the last call.
  bool send(const Frame& frame) {
    const bool lost = lost_;
    lost_ = false;
    if (!is_up()) return starts_ == 0;
    return queue_.push(frame) && !lost;
  }

  /// Takes the next frame that came and is of those the node understands.
  bool receive(Frame& frame) {
    for (uint8_t at = 0; at < Ids::COUNT && is_up(); ++at) {
      if ((registers_.read(IFLAG1) & flag(at)) == 0) continue;
      const uint32_t head = registers_.read(mailbox(at));  // which locks it
      if ((head & BUSY) != 0) continue;
      frame.id = static_cast<uint16_t>(registers_.read(mailbox(at) + ID) >> ID_SHIFT & 0x7FF);
      unpack(registers_.read(mailbox(at) + WORDS), frame.data);
      unpack(registers_.read(mailbox(at) + WORDS + 4), frame.data + 4);
      registers_.read(TIMER);  // which lets it go
      registers_.write(IFLAG1, flag(at));
      const bool plain = (head & (EXTENDED | REMOTE)) == 0 && (head & LENGTH) == EIGHT_BYTES;
      if (plain && Ids::has(frame.id)) return true;
    }
    return false;
  }

  /// Does what is due; `now_ms` may wrap.
  void poll(uint32_t now_ms) {
    const uint32_t since = now_ms - since_ms_;
    const uint32_t mcr = registers_.read(MCR);
    if (state_ != UP && state_ != DOWN && since >= JOIN_MS) return enter(DOWN, now_ms);
    switch (state_) {
      case DOWN:
        registers_.write(MCR, STOPPED);
        return enter(STOPPING, now_ms);
      case STOPPING:
        if ((mcr & FROZEN) == 0) return;
        registers_.write(MCR, STOPPED | RESET);
        return enter(RESETTING, now_ms);
      case RESETTING:
        if ((mcr & RESET) != 0 || (mcr & FROZEN) == 0) return;
        configure();
        return enter(STARTING, now_ms);
      case STARTING:
        if ((mcr & (NOT_READY | FROZEN | DISABLED)) == 0) come_up(now_ms);
        return;
      case UP:
        if (since >= CHECK_MS && !check(mcr, now_ms)) return;
        send_next();
    }
  }

 private:
  enum State : uint8_t { DOWN, STOPPING, RESETTING, STARTING, UP };

  static constexpr uint32_t JOIN_MS = 20;  // for eleven recessive bits among a bus's frames
  static constexpr uint32_t CHECK_MS = 10;
  static constexpr uint8_t LONGEST_OFF = 20;  // checks; rejoining takes 128 * 11 bits

  static constexpr uint32_t MCR = 0x00, CTRL1 = 0x04, TIMER = 0x08, ECR = 0x1C;
  static constexpr uint32_t ESR1 = 0x20, IFLAG1 = 0x30, MASKS = 0x880;
  static constexpr uint32_t ID = 4, WORDS = 8;  // within a mailbox
  static constexpr uint32_t DISABLED = 1U << 31, FREEZE = 1U << 30, HALT = 1U << 28;
  static constexpr uint32_t NOT_READY = 1U << 27, RESET = 1U << 25, FROZEN = 1U << 24;
  static constexpr uint32_t DEAF_TO_ITSELF = 1U << 17, MASK_EACH = 1U << 16, LAST_MAILBOX = 15;
  static constexpr uint32_t RUNNING = DEAF_TO_ITSELF | MASK_EACH | LAST_MAILBOX;
  static constexpr uint32_t STOPPED = RUNNING | FREEZE | HALT;
  static constexpr uint32_t BUS_OFF = 0x20;  // of ESR1
  static constexpr uint32_t EMPTY = 4U << 24, IDLE = 8U << 24, TO_SEND = 12U << 24;
  static constexpr uint32_t CODE = 15U << 24, BUSY = 1U << 24;
  static constexpr uint32_t EXTENDED = 1U << 21, REMOTE = 1U << 20, LENGTH = 15U << 16;
  static constexpr uint32_t EIGHT_BYTES = 8U << 16, ID_SHIFT = 18, ID_BITS = 0x7FFU << ID_SHIFT;
  static constexpr uint8_t SPARE = 8, SENDER = 9, MAILBOXES = 16;  // those to receive come first

  /// CTRL1 of a bit that is divided so.
  static uint32_t timing_of(uint32_t prescaler, uint32_t quanta) {
    const uint32_t propagation = quanta_before(quanta) - phase_1_of(quanta);
    return (prescaler - 1) << 24 | (jump_of(quanta) - 1) << 22 | (phase_1_of(quanta) - 1) << 19 |
           (quanta_after(quanta) - 1) << 16 | (propagation - 1);
  }

  static uint32_t flag(uint8_t at) { return 1U << at; }
  static uint32_t mailbox(uint8_t at) { return 0x80U + 0x10U * at; }

  static uint32_t packed(const uint8_t* bytes) {
    return static_cast<uint32_t>(bytes[0]) << 24 | static_cast<uint32_t>(bytes[1]) << 16 |
           static_cast<uint32_t>(bytes[2]) << 8 | bytes[3];
  }

  static void unpack(uint32_t word, uint8_t* bytes) {
    for (uint8_t at = 0; at < 4; ++at) bytes[at] = static_cast<uint8_t>(word >> (24 - 8 * at));
  }

  void enter(State state, uint32_t now_ms) {
    state_ = state;
    since_ms_ = now_ms;
  }

  /// Writes the settings of a controller that stands still, and lets it go. What a reset leaves
  /// alone, timing, mailboxes and masks, is written in full.
  void configure() {
    registers_.write(CTRL1, timing_);
    for (uint8_t at = 0; at < MAILBOXES; ++at) {
      registers_.write(mailbox(at), 0);
      const bool listens = at < Ids::COUNT;
      registers_.write(mailbox(at) + ID, listens ? uint32_t{Ids::filter(at)} << ID_SHIFT : 0);
      registers_.write(MASKS + 4U * at, ID_BITS);
      registers_.write(mailbox(at), listens ? EMPTY : at >= SPARE ? IDLE : 0);
    }
    registers_.write(IFLAG1, 0xFFFFFFFF);
    registers_.write(MCR, RUNNING);
  }

  void come_up(uint32_t now_ms) {
    ++starts_;
    errors_ = 0;
    off_ = 0;
    enter(UP, now_ms);
  }

  /// Whether the controller still is as it was set up; what it had to send is lost where not.
  bool check(uint32_t mcr, uint32_t now_ms) {
    errors_ = registers_.read(ECR);
    off_ = static_cast<uint8_t>(registers_.read(ESR1) & BUS_OFF ? off_ + 1 : 0);
    since_ms_ = now_ms;
    const bool runs = (mcr & ~NOT_READY & ~(1U << 23)) == RUNNING;  // bit 23: who may access it
    if (runs && registers_.read(CTRL1) == timing_ && off_ <= LONGEST_OFF) return true;
    queue_.clear();
    lost_ = true;
    enter(DOWN, now_ms);
    return false;
  }

  /// Only one mailbox is used: so frames leave in their order.
  void send_next() {
    if (queue_.is_empty() || (registers_.read(mailbox(SENDER)) & CODE) == TO_SEND) return;
    const Frame& frame = queue_.front();
    registers_.write(mailbox(SENDER) + ID, uint32_t{frame.id} << ID_SHIFT);
    registers_.write(mailbox(SENDER) + WORDS, packed(frame.data));
    registers_.write(mailbox(SENDER) + WORDS + 4, packed(frame.data + 4));
    registers_.write(mailbox(SENDER), TO_SEND | EIGHT_BYTES);
    // NXP's erratum ERR005829: a request that comes in one moment of an arbitration is overlooked
    // until a mailbox is written, and its remedy is one that never sends, written twice.
    registers_.write(mailbox(SPARE), IDLE);
    registers_.write(mailbox(SPARE), IDLE);
    queue_.pop();
  }

  Registers& registers_;
  FrameQueue queue_;
  uint32_t since_ms_ = 0;  // of the state, or of the last check
  uint32_t starts_ = 0;
  uint32_t timing_ = 0;
  uint32_t errors_ = 0;  // ECR at the last check: of transmission, then of reception
  State state_ = DOWN;
  uint8_t off_ = 0;  // checks that found it off the bus, one after the other
  bool lost_ = false;
};

}  // namespace exoid
