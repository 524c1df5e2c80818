// What is told of a leg, and when: also where the count of ticks wraps, and after ticks were missed.

#include <vector>

#include "host_check.h"
#include "leg_teller.h"

namespace {

struct Heard {
  uint32_t tick;
  exoid::Frame frame;
};

/// What is sent in ticks from `first` on, of which every `stride`th comes; each is looked at twice.
std::vector<Heard> told(uint32_t first, uint32_t count, uint32_t stride) {
  exoid::LegLearner learner;
  exoid::LegTeller teller;
  std::vector<Heard> heard;
  for (uint32_t k = 0; k < count; ++k) {
    const uint32_t tick = first + k * stride;
    for (int pass = 0; pass < 2; ++pass) {
      teller.run(learner, tick,
                 [&heard, tick](const exoid::Frame& frame) { heard.push_back({tick, frame}); });
    }
  }
  return heard;
}

constexpr uint16_t IN_ORDER[] = {exoid::RATIOS_ID, exoid::RATIO_ERRORS_ID, exoid::FRICTION_ID,
                                 exoid::LEARNING_ID};
constexpr size_t FRAMES = sizeof IN_ORDER / sizeof *IN_ORDER;  // that belong together

/// A part of the work is done in each tick, of which every `stride`th comes.
void check_in_order(const std::vector<Heard>& heard, uint32_t stride, uint32_t period) {
  for (size_t k = 0; k < heard.size(); ++k) {
    check(heard[k].frame.id == IN_ORDER[k % FRAMES], "each has its place in the order");
    if (k % FRAMES != FRAMES - 1) continue;
    check(heard[k].frame.data[0] == static_cast<uint8_t>(heard[k].tick - (FRAMES + 1) * stride),
          "the counter names the tick that was read");
    if (k < FRAMES) continue;
    check(heard[k].tick - heard[k - FRAMES].tick == period, "each comes as often");
  }
}

/// Whoever begins to listen hears nothing that was read off before.
void nothing_of_before() {
  exoid::LegLearner learner;
  exoid::LegTeller teller;
  std::vector<exoid::Frame> heard;
  const auto hear = [&heard](const exoid::Frame& frame) { heard.push_back(frame); };
  for (uint32_t started = 100; started < 110; ++started) {  // wherever it is in its parts
    uint32_t tick = 50;
    for (; tick < started; ++tick) teller.run(learner, tick, hear);
    heard.clear();
    teller.restart();
    for (; tick < started + 30; ++tick) teller.run(learner, tick, hear);
    check(heard.front().id == exoid::RATIOS_ID, "it begins with ratios");
    check(heard[FRAMES - 1].data[0] >= started, "what was read off at the restart, or later");
  }
}

void ten_times_a_second(uint32_t first) {
  const std::vector<Heard> heard = told(first, 1000, 1);
  check(heard.size() / FRAMES >= 99 && heard.size() / FRAMES <= 100, "they come ten times a second");
  check_in_order(heard, 1, 10);
}

}  // namespace

int main() {
  ten_times_a_second(1);
  ten_times_a_second(0U - 500U);      // the count wraps
  ten_times_a_second(0x80000000U - 500U);
  nothing_of_before();
  check_in_order(told(1, 500, 10), 10, 60);  // of ten ticks nine are missed
  return 0;
}
