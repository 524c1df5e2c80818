// host_frames INPUT OUTPUT: packs records of 16 words, identifier first and then the message's
// fields in their order, into records of 10 bytes: identifier and data.

#include <cstdio>
#include <cstring>

#include "exo_can.h"

namespace {

struct Words {
  uint32_t word[16];

  uint32_t count(int at) const { return word[at]; }
  int32_t signed_count(int at) const { return static_cast<int32_t>(word[at]); }
  bool flag(int at) const { return word[at] != 0; }
  float value(int at) const {
    float value;
    std::memcpy(&value, &word[at], sizeof value);
    return value;
  }
};

exoid::State state(const Words& w) {
  return {w.value(1), w.value(2), w.value(3), w.count(4), w.flag(5), w.flag(6),
          w.flag(7),  w.flag(8),  w.flag(9),  w.flag(10), w.flag(11), w.flag(12)};
}

/// The frame of a record. Its word 10 of STATE is put in from what `fits` says.
exoid::Frame packed(const Words& w) {
  switch (w.word[0]) {
    case exoid::TIME_ID:
      return pack(exoid::Time{w.count(1), w.count(2), w.count(3), w.count(4)});
    case exoid::RAW_ID:
      return pack(exoid::Raw{w.count(1), w.count(2), w.signed_count(3), w.signed_count(4),
                             w.signed_count(5)});
    case exoid::FINE_ID:
      return pack(exoid::Fine{w.count(1), w.count(2), w.count(3)});
    case exoid::ACC_ID:
      return pack(exoid::Acc{w.signed_count(1), w.signed_count(2), w.signed_count(3), w.count(4),
                             w.count(5)});
    case exoid::SETTINGS_ID:
      return pack(exoid::Settings{w.count(1), w.count(2), w.flag(3), w.flag(4), w.count(5),
                                  w.count(6)});
    case exoid::HEARTBEAT_ID:
      return pack(exoid::Heartbeat{w.count(1), w.count(2), w.count(3), w.count(4), w.count(5),
                                   w.flag(6)});
    case exoid::REPLY_ID:
      return pack(exoid::Reply{w.count(1), w.count(2), w.flag(3), w.flag(4), w.flag(5),
                               w.flag(6), w.flag(7)});
    case exoid::RATIOS_ID:
      return pack(exoid::Ratios{w.value(1), w.value(2), w.value(3), w.value(4)});
    case exoid::RATIO_ERRORS_ID:
      return pack(exoid::RatioErrors{w.value(1), w.value(2), w.value(3), w.value(4)});
    case exoid::FRICTION_ID:
      return pack(exoid::Friction{w.value(1), w.value(2)});
    case exoid::LEARNING_ID:
      return pack(exoid::Learning{w.count(1), w.count(2), w.count(3), w.count(4), w.count(5),
                                  w.count(6)});
    case exoid::TORQUE_ID:
      return pack(exoid::Torque{w.value(1), w.count(2), w.count(3), w.count(4), w.count(5)});
    case exoid::PARAMETER_ID:
      return pack(exoid::Parameter{w.count(1), w.flag(2), w.value(3), w.count(4)});
    case exoid::HEALTH_ID:
      return pack(exoid::Health{w.count(1), w.flag(2), w.flag(3), w.flag(4), w.flag(5), w.count(6),
                                w.count(7), w.count(8), w.count(9)});
    default: {
      exoid::State filled = state(w);
      filled.state_saturated = !fits(filled);
      return pack(filled);
    }
  }
}

}  // namespace

int main(int count, char** names) {
  if (count != 3) return 2;
  std::FILE* input = std::fopen(names[1], "rb");
  std::FILE* output = std::fopen(names[2], "wb");
  if (input == nullptr || output == nullptr) return 2;
  Words words;
  while (std::fread(&words, sizeof words, 1, input) == 1) {
    const exoid::Frame frame = packed(words);
    std::fwrite(&frame, sizeof frame, 1, output);
  }
  std::fclose(input);
  return std::fclose(output);
}
