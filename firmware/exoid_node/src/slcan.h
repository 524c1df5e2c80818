/// CAN frames as lines of text (Lawicel's protocol) for a host on a serial port.

#pragma once

#include <stddef.h>

#include "slcan_frame.h"

namespace exoid {

/// Answers the commands C, O, S, V, N and F, takes frames by t, is silent until the host opens the
/// channel, and drops frames while the host does not read. Nothing here waits.
class Slcan {
 public:
  /// Queues a frame. Returns false, and remembers for F, where a frame was lost: this one, for
  /// which there is no room, or one since the last call. What nobody listens to is not lost.
  bool send(const Frame& frame) {
    const bool lost = lost_;
    lost_ = false;
    if (!open_) return true;
    if (SIZE - (head_ - tail_) < FRAME_LENGTH + RESERVE) {
      dropped_ = true;
      return false;
    }
    put('t');
    put_digit(frame.id >> 8);
    put_byte(static_cast<uint8_t>(frame.id));
    put('8');
    for (uint8_t byte : frame.data) put_byte(byte);
    put(RETURN);
    return !lost;
  }

  /// Takes one character from the host.
  void receive(char character) {
    if (character != RETURN) {
      if (length_ < LINE) line_[length_] = character;
      if (length_ <= LINE) ++length_;
      return;
    }
    answer();
    length_ = 0;
  }

  /// The program on the port has let go of it, with or without a goodbye: nobody hears what is
  /// queued, nor the end of a line of which it has a piece.
  void hang_up() {
    open_ = torn_ = has_frame_ = just_opened_ = false;
    tail_ = head_;
    length_ = 0;
  }

  bool is_open() const { return open_; }

  /// Whether the host has opened the channel since the last call.
  bool opened() {
    const bool opened = just_opened_;
    just_opened_ = false;
    return opened;
  }

  /// Takes away the frame that the host has sent; returns false where there is none.
  bool received(Frame& frame) {
    if (!has_frame_) return false;
    frame = frame_;
    has_frame_ = false;
    return true;
  }

  /// The bytes to send next, and how many lie there in one piece.
  size_t pending(const uint8_t*& bytes) const {
    static const uint8_t line_end = RETURN;
    if (torn_) {
      bytes = &line_end;
      return 1;
    }
    const size_t from = tail_ % SIZE, queued = head_ - tail_;
    bytes = ring_ + from;
    return queued < SIZE - from ? queued : SIZE - from;
  }

  /// Takes away the first `count` bytes, which the port took.
  void sent(size_t count) {
    if (torn_) {
      torn_ = count == 0;
    } else {
      tail_ += static_cast<uint32_t>(count);
    }
  }

  /// The port lost bytes that it had taken: ends the line of which the host may have a piece, and
  /// goes on with the next whole one. Else two pieces could look like a frame.
  void lose() {
    tail_ = end_of_line();
    if (!torn_) dropped_ = lost_ = true;  // else it had taken nothing since
    torn_ = true;
  }

 private:
  static constexpr uint32_t SIZE = 1024;  // bytes; frames of 150 ms
  static constexpr size_t FRAME_LENGTH = 22;
  static constexpr size_t RESERVE = 32;  // for answers while frames have no room
  static constexpr size_t LINE = 31;     // longest command
  static constexpr char RETURN = '\r';
  static constexpr char BELL = '\a';

  void answer() {
    switch (length_ == 0 ? RETURN : length_ > LINE ? BELL : line_[0]) {
      case RETURN: return put(RETURN);
      case 'C': return close();
      case 'S': return put(open_ ? BELL : RETURN);
      case 'O': return open();
      case 'V': return put_text("V0101\r");
      case 'N': return put_text("NEXO1\r");
      case 'F': return put_flags();
      case 't': return take_frame();
      default: return put(BELL);
    }
  }

  /// One at a time: who sends a second before the first was looked at is refused.
  void take_frame() {
    const bool taken = open_ && !has_frame_ && read_frame(line_, length_, frame_);
    has_frame_ = has_frame_ || taken;
    put(taken ? RETURN : BELL);
  }

  void open() {
    if (open_) return put(BELL);
    just_opened_ = open_ = true;
    put(RETURN);
  }

  void close() {
    if (!open_) return put(BELL);
    open_ = false;
    forget_frames();
    put(RETURN);
  }

  /// Drops what is queued, but for the rest of a line that is half sent.
  void forget_frames() { head_ = end_of_line(); }

  /// Where the line ends that is half sent; where the next begins if none is.
  uint32_t end_of_line() const {
    uint32_t end = tail_;
    if (!ends_line(ring_[(end - 1) % SIZE])) {
      while (end != head_ && !ends_line(ring_[end++ % SIZE])) {
      }
    }
    return end;
  }

  static bool ends_line(uint8_t byte) { return byte == RETURN || byte == BELL; }

  void put_flags() {
    put_text(dropped_ ? "F02\r" : "F00\r");  // bit 1: transmit queue full
    dropped_ = false;
  }

  void put(char character) {
    if (head_ - tail_ < SIZE) ring_[head_++ % SIZE] = static_cast<uint8_t>(character);
  }

  void put_text(const char* text) {
    while (*text != '\0') put(*text++);
  }

  void put_digit(uint32_t value) {
    const uint32_t digit = value & 15U;
    put(static_cast<char>(digit < 10 ? '0' + digit : 'A' + digit - 10));
  }

  void put_byte(uint8_t byte) {
    put_digit(byte >> 4U);
    put_digit(byte);
  }

  uint8_t ring_[SIZE] = {RETURN};  // as if a line had just been sent
  // Bytes ever queued, ever sent: counts that wrap after a week, and in the first second, so that
  // whatever does not outlive it is seen.
  uint32_t head_ = 1U - SIZE, tail_ = 1U - SIZE;
  char line_[LINE] = {};
  size_t length_ = 0;
  bool open_ = false;
  bool just_opened_ = false;
  bool dropped_ = false;  // a frame, since the host last asked
  bool lost_ = false;     // a frame, since the last one was queued
  bool torn_ = false;     // the host may have a piece of a line
  Frame frame_ = {};      // from the host
  bool has_frame_ = false;
};

}  // namespace exoid
