// Where the simulated board tells what the sketch does.

#include <cstdlib>

#include "board/sinks.h"
#include "world.h"

World world;

std::vector<exoid::Frame> frames_in(const std::string& text) {
  std::vector<exoid::Frame> found;
  for (size_t at = 0; at < text.size();) {
    const size_t end = text.find('\r', at);
    check(end != std::string::npos, "every line ends");
    const std::string line = text.substr(at, end - at);
    at = end + 1;
    if (line.empty()) continue;
    check(line.size() == 21 && line[0] == 't' && line[4] == '8', "every line is a frame");
    const unsigned long id = std::strtoul(line.substr(1, 3).c_str(), nullptr, 16);
    exoid::Frame frame = {static_cast<uint16_t>(id), {}};
    for (int byte = 0; byte < 8; ++byte) {
      const std::string digits = line.substr(static_cast<size_t>(5 + 2 * byte), 2);
      frame.data[byte] = static_cast<uint8_t>(std::strtoul(digits.c_str(), nullptr, 16));
    }
    found.push_back(frame);
  }
  return found;
}

namespace simulated {

void on_can_frame(const exoid::Frame& frame, uint64_t) { world.on_bus.push_back(frame); }

void on_usb_packet(const uint8_t* bytes, size_t count) {
  world.to_host.append(reinterpret_cast<const char*>(bytes), count);
}

chips::Exposure exposed_to(uint32_t tick) { return world.leg(tick); }

void violated(const char* sentence) {
  check(false, sentence, 0);
  __builtin_unreachable();
}

}  // namespace simulated
