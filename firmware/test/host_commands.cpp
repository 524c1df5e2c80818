// host_commands INPUT OUTPUT: reads records of 10 bytes, identifier and data, into records of four
// words: whether it is a command, whether its signals are in their ranges, its serial, its value.

#include <cstdio>

#include "checksum.h"

namespace {

struct Words {
  uint32_t word[4];
};

template <class Command>
Words read(const exoid::Frame& frame, uint32_t (*value)(const Command&)) {
  Command command;
  unpack(frame, command);
  return {{is_command(frame), is_valid(command), command.serial, value(command)}};
}

/// Its signals in counts, as they lie in the frame.
uint32_t wish_of(const exoid::Allow& allow) {
  constexpr float COUNTS = 16.0F;  // of a rad/s^2
  const int32_t acceleration = static_cast<int32_t>(allow.acceleration * COUNTS);
  return allow.wish | allow.number << 2 | allow.limit << 6 |
         (static_cast<uint32_t>(acceleration) & 4095U) << 12;
}

Words taken(const exoid::Frame& frame) {
  using namespace exoid;
  switch (frame.id) {
    case TELL_ID: return read<Tell>(frame, [](const Tell&) { return 0U; });
    case SET_ZERO_ID:
      return read<SetZero>(frame,
                           [](const SetZero& set) { return static_cast<uint32_t>(set.angle); });
    case SET_DIRECTION_ID:
      return read<SetDirection>(frame,
                                [](const SetDirection& set) { return set.reversed ? 1U : 0U; });
    case SET_NODE_ID_ID:
      return read<SetNodeId>(frame, [](const SetNodeId& set) { return set.node_id; });
    case SET_BIT_RATE_ID:
      return read<SetBitRate>(frame, [](const SetBitRate& set) { return set.bit_rate; });
    case IDENTIFY_ID:
      return read<Identify>(frame, [](const Identify& identify) { return identify.duration; });
    case LOAD_ID:
      return read<Load>(frame, [](const Load& load) { return load.place | load.data << 8; });
    case ALLOW_ID: return read<Allow>(frame, wish_of);
    default: return {{is_command(frame), 0, 0, 0}};
  }
}

}  // namespace

int main(int count, char** names) {
  if (count != 3) return 2;
  std::FILE* input = std::fopen(names[1], "rb");
  std::FILE* output = std::fopen(names[2], "wb");
  if (input == nullptr || output == nullptr) return 2;
  exoid::Frame frame;
  while (std::fread(&frame, sizeof frame, 1, input) == 1) {
    const Words words = taken(frame);
    std::fwrite(&words, sizeof words, 1, output);
  }
  std::fclose(input);
  return std::fclose(output);
}
