/// MCP2515, the CAN controller, by its registers. Nothing here waits: what takes time is looked at
/// again at the next poll, and a controller that does not answer as it should is started again.

#pragma once

#include "can_ids.h"
#include "can_timing.h"
#include "frame.h"
#include "frame_queue.h"
#include "mcp2515_registers.h"

namespace exoid {

/// `Spi` has `begin()` and `exchange(bytes, count)`, which sends bytes and puts in their place
/// what came back. `CRYSTAL` is the controller's [Hz], `Ids` has the frames to listen to.
template <class Spi, uint32_t CRYSTAL, class Ids>
class Mcp2515 {
  static constexpr uint8_t FILTER_COUNT = 6;
  static constexpr uint16_t MASK = Ids::COUNT <= FILTER_COUNT ? NO_CAN_ID : Ids::SHARED;
  static_assert(Ids::COUNT <= FILTER_COUNT || Ids::ARE_ALL_THAT_SHARE,
                "six filters, or what one mask lets in, are all that is understood");

 public:
  explicit Mcp2515(Spi& spi) : spi_(spi), registers_(spi) {}

  /// `bit_rate` is one that the crystal can do [bit/s].
  void begin(uint32_t bit_rate) {
    timing_ = can_registers(CRYSTAL, bit_rate);
    spi_.begin();
  }

  /// Whether the controller is on the bus.
  bool is_up() const { return state_ == UP; }

  /// Times it was set up, its error counters, and whether it has left the bus for errors.
  uint32_t starts() const { return starts_; }
  uint8_t transmit_errors() const { return is_up() ? errors_[0] : 0; }
  uint8_t receive_errors() const { return is_up() ? errors_[1] : 0; }
  bool is_off() const { return is_up() && off_ > 0; }

  /// Queues a frame. Returns false where a frame was lost, this one or one since the last call;
  /// before a controller was ever there, nobody listens and none is lost.
  bool send(const Frame& frame) {
    const bool lost = lost_;
    lost_ = false;
    if (!is_up()) return starts_ == 0;
    return queue_.push(frame) && !lost;
  }

  /// Takes the next frame that came and is of those the node understands.
  bool receive(Frame& frame) {
    if (Ids::COUNT == 0 || !is_up()) return false;
    const uint8_t full = registers_.status() & (RECEIVED_0 | RECEIVED_1);
    if (full == 0) return false;
    uint8_t bytes[1 + HEAD + sizeof frame.data] = {};
    bytes[0] = full & RECEIVED_0 ? READ_BUFFER_0 : READ_BUFFER_1;
    spi_.exchange(bytes, sizeof bytes);  // which frees the buffer
    const uint8_t *head = bytes + 1, *data = head + HEAD;
    const bool plain = (head[1] & (EXTENDED | REMOTE)) == 0 && (head[4] & LENGTH) == FRAME_BYTES;
    frame.id = static_cast<uint16_t>(head[0] << 3 | head[1] >> 5);
    for (uint8_t at = 0; at < sizeof frame.data; ++at) frame.data[at] = data[at];
    return plain && Ids::has(frame.id);
  }

  /// Does what is due; `now_ms` may wrap.
  void poll(uint32_t now_ms) {
    const uint32_t since = now_ms - since_ms_;
    switch (state_) {
      case DOWN:
        if (!tried_ || since >= RETRY_MS) reset(now_ms);
        return;
      case RESETTING:
        if (since >= START_UP_MS) enter(configure() ? STARTING : DOWN, now_ms);
        return;
      case STARTING:
        if ((registers_.read(CANSTAT) & MODE) == NORMAL) return come_up(now_ms);
        if (since >= JOIN_MS) enter(DOWN, now_ms);
        return;
      case UP:
        if (since >= CHECK_MS && !check(now_ms)) return;
        send_next();
    }
  }

 private:
  enum State : uint8_t { DOWN, RESETTING, STARTING, UP };

  static constexpr uint32_t RETRY_MS = 20;
  static constexpr uint32_t START_UP_MS = 3;  // of the oscillator: 128 clocks, and a ms begun
  static constexpr uint32_t JOIN_MS = 20;     // for eleven recessive bits among a bus's frames
  static constexpr uint32_t CHECK_MS = 10;
  static constexpr uint8_t LONGEST_OFF = 20;  // checks; rejoining takes 128 * 11 bits

  using Registers = Mcp2515Registers<Spi>;
  static constexpr uint8_t READ = Registers::READ, WRITE = Registers::WRITE;
  static constexpr uint8_t LOAD_BUFFER_0 = 0x40, REQUEST_0 = 0x81;
  static constexpr uint8_t READ_BUFFER_0 = 0x90, READ_BUFFER_1 = 0x94;

  static constexpr uint8_t CANSTAT = 0x0E, CANCTRL = 0x0F, TEC = 0x1C, CNF3 = 0x28;
  static constexpr uint8_t RXB0CTRL = 0x60, RXB1CTRL = 0x70;
  static constexpr uint8_t FILTERS = 0x00, MORE_FILTERS = 0x10, MASKS = 0x20;
  static constexpr uint8_t MODE = 0xE0, NORMAL = 0x00, ROLL_OVER = 0x04;
  static constexpr uint8_t BUS_OFF = 0x20;  // of EFLG
  static constexpr uint8_t RECEIVED_0 = 0x01, RECEIVED_1 = 0x02, REQUESTED_0 = 0x04;
  static constexpr uint8_t EXTENDED = 0x08, REMOTE = 0x10, LENGTH = 0x0F;
  static constexpr uint8_t HEAD = 5, FRAME_BYTES = 8;  // SIDH SIDL EID8 EID0 DLC, then data

  void enter(State state, uint32_t now_ms) {
    state_ = state;
    since_ms_ = now_ms;
  }

  void reset(uint32_t now_ms) {
    registers_.reset();
    tried_ = true;
    enter(RESETTING, now_ms);
  }

  /// Writes the settings of a controller that was reset. Returns whether it keeps them.
  bool configure() {
    for (uint8_t at = 0; at < FILTER_COUNT; ++at) {
      const uint8_t block = at < 3 ? FILTERS : MORE_FILTERS;
      registers_.write_id(static_cast<uint8_t>(block + at % 3 * 4), Ids::filter(at));
    }
    registers_.write_id(MASKS, MASK);
    registers_.write_id(MASKS + 4, MASK);
    registers_.write(RXB0CTRL, ROLL_OVER);
    registers_.write(RXB1CTRL, 0);
    uint8_t timing[] = {WRITE, CNF3, timing_.cnf3, timing_.cnf2, timing_.cnf1, 0, 0};
    spi_.exchange(timing, sizeof timing);
    uint8_t now[2 + 3] = {READ, CNF3};
    spi_.exchange(now, sizeof now);
    registers_.write(CANCTRL, NORMAL);
    return keeps_timing(now + 2);
  }

  bool keeps_timing(const uint8_t* from_cnf3) const {
    return from_cnf3[0] == timing_.cnf3 && from_cnf3[1] == timing_.cnf2 &&
           from_cnf3[2] == timing_.cnf1;
  }

  void come_up(uint32_t now_ms) {
    ++starts_;
    off_ = errors_[0] = errors_[1] = 0;
    enter(UP, now_ms);
  }

  /// Whether the controller still is as it was set up; what it had to send is lost where not.
  bool check(uint32_t now_ms) {
    uint8_t now[2 + 8] = {READ, CNF3};  // CNF3 CNF2 CNF1 CANINTE CANINTF EFLG CANSTAT CANCTRL
    spi_.exchange(now, sizeof now);
    off_ = static_cast<uint8_t>(now[7] & BUS_OFF ? off_ + 1 : 0);
    since_ms_ = now_ms;
    if (keeps_timing(now + 2) && (now[8] & MODE) == NORMAL && off_ <= LONGEST_OFF) {
      count_errors();
      return true;
    }
    queue_.clear();
    lost_ = true;
    reset(now_ms);
    return false;
  }

  void count_errors() {
    uint8_t now[2 + 2] = {READ, TEC};  // TEC REC
    spi_.exchange(now, sizeof now);
    errors_[0] = now[2];
    errors_[1] = now[3];
  }

  /// Only one of the three transmit buffers is used: so frames leave in their order.
  void send_next() {
    if (queue_.is_empty() || (registers_.status() & REQUESTED_0) != 0) return;
    const Frame& frame = queue_.front();
    const uint8_t high = static_cast<uint8_t>(frame.id >> 3);
    const uint8_t low = static_cast<uint8_t>(frame.id << 5);
    uint8_t bytes[1 + HEAD + FRAME_BYTES] = {LOAD_BUFFER_0, high, low, 0, 0, FRAME_BYTES};
    for (uint8_t at = 0; at < FRAME_BYTES; ++at) bytes[1 + HEAD + at] = frame.data[at];
    spi_.exchange(bytes, sizeof bytes);
    uint8_t request[] = {REQUEST_0};
    spi_.exchange(request, sizeof request);
    queue_.pop();
  }

  Spi& spi_;
  Registers registers_;
  CanRegisters timing_ = {0, 0, 0};
  FrameQueue queue_;
  uint32_t since_ms_ = 0;  // of the state, or of the last check
  uint32_t starts_ = 0;
  State state_ = DOWN;
  uint8_t errors_[2] = {0, 0};  // of transmission and reception, at the last check
  uint8_t off_ = 0;  // checks that found it off the bus, one after the other
  bool tried_ = false;
  bool lost_ = false;
};

}  // namespace exoid
