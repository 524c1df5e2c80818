#include "usb_model.h"

#include "sinks.h"

namespace simulated {

namespace {

constexpr uint32_t PACKET_US = 100;
constexpr uint32_t TIMEOUT_US = 110000;  // of the core's 70 ms, counted in turns of a slower loop

}  // namespace

void UsbModel::type(const char* text) {
  while (*text != '\0') input_[typed_++ % LONGEST_INPUT] = *text++;
}

void UsbModel::unplug() {
  plugged = false;
  full_ = false;
}

void UsbModel::let_go() { reads = held_ = false; }

void UsbModel::take() { reads = held_ = true; }

size_t UsbModel::write(const uint8_t* bytes, size_t count) {
  if (!plugged) return SIZE_MAX;
  if (count >= PACKET) violated("a write fits one USB packet");
  if (is_full() && reads) {
    now_us_ = taken_us_;
    deliver();
  }
  if (full_) {
    if (!was_late_) now_us_ += TIMEOUT_US;
    was_late_ = true;
    count_ = 0;  // the host will be sent an empty packet in place of what it did not take
    ++timeouts_;
    return SIZE_MAX;
  }
  was_late_ = false;
  for (size_t at = 0; at < count; ++at) packet_[at] = bytes[at];
  count_ = count;
  full_ = true;
  taken_us_ = now_us_ + PACKET_US;
  return count;
}

bool UsbModel::is_full() {
  if (full_ && plugged && reads && now_us_ >= taken_us_) deliver();
  return full_;
}

void UsbModel::deliver() {
  full_ = false;
  if (count_ > 0) on_usb_packet(packet_, count_);
}

}  // namespace simulated
