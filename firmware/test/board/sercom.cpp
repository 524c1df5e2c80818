#include "sercom.h"

#include "sinks.h"

namespace simulated {

namespace {

constexpr uint32_t ENABLE = 1U << 1, LOW_TIME_OUT = 1U << 30, INACTIVE_TIME_OUT = 3U << 28;
constexpr uint32_t BUS_ERROR = 1, ARBITRATION_LOST = 2, NOT_ACKNOWLEDGED = 4, LOW_TIMED_OUT = 64;
constexpr uint8_t MASTER_ON_BUS = 1, SLAVE_ON_BUS = 2;
constexpr uint32_t STOP_US = 16, INACTIVE_US = 60, LOW_US = 30000;
constexpr uint32_t REFUSAL_US = 4;  // of that, after a read: the bit that is not acknowledged
constexpr uint8_t LONGEST = 32;  // bytes of a transfer

}  // namespace

void Sercom::set_up(uint32_t frequency) {
  ++set_ups;
  enabled_ = true;
  settings_ = 0;
  operation_ = NONE;
  state_ = IDLE;
  flags_ = 0;
  errors_ = 0;
  stopping_ = data_pulled_ = clock_pulled_ = false;
  byte_us_ = 9 * 1000000 / frequency + 1;
}

uint32_t Sercom::read(SercomRegister from) {
  switch (from) {
    case CTRLA: return settings_ | (enabled_ ? ENABLE : 0);
    case STATUS: return status();
    case INTFLAG: return flags();
    case DATA: return data_;
    default: return 0;
  }
}

void Sercom::write(SercomRegister to, uint32_t value) {
  switch (to) {
    case CTRLA:
      if (!(enabled_ && (value & ENABLE))) settings_ = value & ~ENABLE;  // enable-protected
      if (!enabled_ && (value & ENABLE)) state_ = UNKNOWN;
      enabled_ = (value & ENABLE) != 0;
      break;
    case CTRLB: command(value); break;
    case STATUS: state_ = static_cast<State>(value >> 4 & 3U); break;
    case ADDR:
      settle();
      address_ = static_cast<uint8_t>(value);
      errors_ = 0;
      begin(ADDRESS);
      break;
    case DATA:
      data_ = static_cast<uint8_t>(value);
      begin(SEND);
      break;
    default: break;
  }
}

void Sercom::pull_clock(bool pulled) {
  if (clock_pulled_ && !pulled && data_held_for > 0) --data_held_for;
  clock_pulled_ = pulled;
}

/// The master itself holds the line until its stop is done, but not in the bit before.
bool Sercom::data_is_low() {
  settle();
  return data_pulled_ || (stopping_ && now_us_ >= stop_us_) || data_held_for > 0;
}

void Sercom::become_busy() {
  state_ = BUSY;
  busy_us_ = now_us_;
}

void Sercom::begin(Operation operation) {
  if (stopping_) violated("nothing begins on the bus before the stop is over");
  flags_ = 0;
  const bool starts = operation == ADDRESS;
  const bool allowed = enabled_ && (state_ == OWNER || (starts && state_ == IDLE));
  operation_ = allowed ? operation : NONE;  // a start on a busy bus waits, and nobody ends that
  if (allowed) state_ = OWNER;
  done_us_ = now_us_ + byte_us_;
  count_byte();
}

void Sercom::count_byte() {
  if (clock_in_ > 0 && --clock_in_ == 0) clock_held = true;
  if (data_in_ > 0 && --data_in_ == 0) data_held_for = pulses_;
}

void Sercom::command(uint32_t value) {
  const uint32_t command = value >> 16 & 3U;
  if (!enabled_ || state_ != OWNER || command < 2) return;
  flags_ = 0;
  if (command == 2) return begin(FETCH);
  operation_ = NONE;
  stopping_ = true;
  stop_us_ = now_us_ + ((address_ & 1U) != 0 ? REFUSAL_US : 0);
  done_us_ = now_us_ + STOP_US;
}

void Sercom::settle() {
  if (clock_held) return time_out();
  if (stopping_ && now_us_ >= done_us_) {
    stopping_ = false;
    if (state_ == OWNER) state_ = IDLE;
  }
  if (operation_ != NONE && now_us_ >= done_us_) finish();
  const bool counts = has_timeouts && slow_clock && (settings_ & INACTIVE_TIME_OUT) != 0;
  if (state_ == BUSY && counts && data_held_for == 0 && now_us_ >= busy_us_ + INACTIVE_US) {
    state_ = IDLE;
  }
}

/// A clock that is held for 30 ms ends a transfer where the time-out is on.
void Sercom::time_out() {
  const bool counts = has_timeouts && slow_clock && (settings_ & LOW_TIME_OUT) != 0;
  if (operation_ == NONE || !counts || now_us_ < done_us_ + LOW_US) return;
  operation_ = NONE;
  errors_ |= LOW_TIMED_OUT | BUS_ERROR;
  flags_ = MASTER_ON_BUS;
}

void Sercom::finish() {
  const Operation operation = operation_;
  operation_ = NONE;
  if (data_held_for > 0 && operation != FETCH) {
    errors_ |= ARBITRATION_LOST;
    flags_ = MASTER_ON_BUS;
    return become_busy();
  }
  if (operation == ADDRESS) return finish_address();
  if (operation == FETCH) {
    data_ = fetched();
    flags_ = SLAVE_ON_BUS;
    return;
  }
  flags_ = MASTER_ON_BUS;
  const uint8_t device = address_ >> 1;
  const uint8_t to = static_cast<uint8_t>(first_ + sent_ - 1);
  const bool taken =
      sent_ == 0 ? chips_.read(device, 0, nullptr, 0) : chips_.write(device, to, data_);
  if (sent_ == 0) first_ = data_;
  ++sent_;
  if (!taken) errors_ |= NOT_ACKNOWLEDGED;
}

void Sercom::finish_address() {
  sent_ = count_ = 0;
  if (!chips_.read(address_ >> 1, 0, nullptr, 0)) {
    errors_ |= NOT_ACKNOWLEDGED;
    flags_ = MASTER_ON_BUS;
  } else if (address_ & 1U) {
    data_ = fetched();
    now_us_ += byte_us_;
    flags_ = SLAVE_ON_BUS;
  } else {
    flags_ = MASTER_ON_BUS;
  }
}

/// The next byte of the chip; a line that is held low reads as zeros.
uint8_t Sercom::fetched() {
  uint8_t bytes[LONGEST] = {};
  if (count_ < LONGEST) ++count_;
  chips_.read(address_ >> 1, first_, bytes, count_);
  return data_held_for > 0 ? 0 : bytes[count_ - 1];
}

uint32_t Sercom::status() {
  settle();
  return errors_ | static_cast<uint32_t>(state_) << 4;
}

/// Time goes on to the end of the byte where it has one.
uint32_t Sercom::flags() {
  settle();
  if (flags_ == 0) {
    const bool ends = operation_ != NONE && !clock_held && done_us_ > now_us_;
    now_us_ = ends ? done_us_ : now_us_ + 1;
    settle();
  }
  return flags_;
}

}  // namespace simulated
