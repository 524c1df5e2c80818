/// The encoder on the SPI bus: frames of 16 bits under a chip select of its own.

#pragma once

#include <stdint.h>

#include "as504x_model.h"
#include "config.h"
#include "sinks.h"

namespace simulated {

class SpiEncoder {
 public:
  chips::As504xModel chip{IS_AS5048A ? AS5048A : AS5047P};

  void expose(const chips::Exposure& now) { chip.expose(now); }

  /// The mode of the bus, which its last transfer has set.
  void set_mode(uint8_t mode) { mode_ = mode; }
  uint8_t mode() const { return mode_; }

  bool is_selected() const { return selected_; }

  void select() {
    if (mode_ != 1) violated("the encoder's data is taken at the second edge: SPI mode 1");
    selected_ = true;
    bytes_ = 0;
  }

  void deselect() {
    if (selected_ && bytes_ != 2) chip.cut();
    selected_ = false;
  }

  /// A word goes out while another comes in: the first byte of what comes is told by the answer to
  /// the frame before, so that the model takes the frame with its second byte.
  uint8_t transfer(uint8_t byte) {
    if (bytes_++ == 0) {
      first_ = byte;
      return static_cast<uint8_t>(chip.answer() >> 8);
    }
    return static_cast<uint8_t>(chip.exchange(static_cast<uint16_t>(first_ << 8 | byte)));
  }

 private:
  static constexpr bool IS_AS5048A = exoid::config::ENCODER == exoid::EncoderPart::AS5048A;
  static constexpr uint16_t AS5047P = 0x3FFC, AS5048A = 0x3FFD;  // where its diagnostics lie

  uint8_t mode_ = 0, bytes_ = 0, first_ = 0;
  bool selected_ = false;
};

}  // namespace simulated
