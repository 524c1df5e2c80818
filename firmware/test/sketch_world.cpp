// Where the simulated board tells what the sketch does.

#include "board/sinks.h"
#include "world.h"

World world;

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
