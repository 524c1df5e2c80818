// The torque that the sketch commands: from parameters, and not at any doubt.

#include <cmath>

#include "permission.h"
#include "torque_frames.h"

namespace {

constexpr uint16_t COUNT = 1500;
const double ANGLE = (COUNT - 2048.0) * exoid::ENCODER_STEP;

std::vector<Frame> told_parameters() {
  world.on_bus.clear();
  run_ms(1000);
  return only(world.on_bus, exoid::PARAMETER_ID);
}

/// A node that commands a torque.
Insisting enabled_node(uint32_t limit = 63) {
  still_node(COUNT);
  download(LEG);
  run_ms(600);  // until the angle is trusted
  Insisting host(limit);
  check(permit_of(host.says(ARM, 60).back()) == ARMED, "it is armed");
  check(permit_of(host.says(ENABLE, 600).back()) == ENABLED, "and enabled");
  return host;
}

void nobody_asks() {
  still_node(COUNT);
  run_ms(3000);
  check(only(world.on_bus, exoid::TORQUE_ID).empty(), "no torque is told");
  check(only(world.on_bus, exoid::PARAMETER_ID).empty(), "nor parameters");
}

void check_told(const exoid::TorqueParameters& leg) {
  const std::vector<Frame> told = told_parameters();
  check(told.size() >= 19, "twenty a second are told");
  for (const Frame& each : told) {
    const float value = exoid::parameter(leg, field(each, 0, 8));
    check(field(each, 16, 32) == exoid::float_bits(value), "each to the bit");
    check(field(each, 8, 1) == 1 && field(each, 48, 16) == exoid::crc_of(leg), "with their CRC");
  }
}

void parameters_that_come_whole() {
  still_node(COUNT);
  download(LEG);
  check_told(LEG);
  power_cycle();
  check_told(LEG);
  exoid::TorqueParameters other = LEG;
  other.gravity = 9.0F;
  download(other);
  check_told(other);
}

void parameters_that_do_not() {
  still_node(COUNT);
  download(LEG);
  exoid::TorqueParameters other = LEG;
  other.gravity = 9.0F;
  for (uint32_t missing = 0; missing < exoid::PARTS; missing += 5) {
    uint32_t refusals = 0;
    for (uint32_t place = 0; place <= exoid::PARTS; ++place) {
      if (place != missing) refusals += refused(part(other, place)) == NOT_WHOLE;
    }
    check(refusals == exoid::PARTS - missing, "every part behind a gap is refused");
  }
  for (uint32_t place = 0; place < exoid::PARTS; ++place) refused(part(other, place));
  check(refused(part(LEG, exoid::PARTS)) == NOT_WHOLE, "another CRC is refused");
  check(refused(part(other, exoid::PARTS)) == NOT_WHOLE, "and all is to be sent again");
  other.friction = -1.0F;
  for (uint32_t place = 0; place < exoid::PARTS; ++place) refused(part(other, place));
  check(refused(part(other, exoid::PARTS)) == NOT_PLAUSIBLE, "no leg has negative friction");
  check_told(LEG);
}

void a_part_that_is_sent_twice() {
  still_node(COUNT);
  for (uint32_t place = 0; place <= exoid::PARTS; ++place) {
    if (place < exoid::PARTS) check(refused(part(LEG, place)) == 0, "it is taken");
    check(refused(part(LEG, place)) == 0, "a host may have missed the reply");
  }
  check_told(LEG);
}

void flash_that_is_damaged() {
  still_node(COUNT);
  download(LEG);
  for (uint32_t bit = 0; bit < 8 * exoid::Record<exoid::TorqueParameters>::SIZE; bit += 29) {
    board.flash.slots[2][bit / 8] ^= static_cast<uint8_t>(1U << bit % 8);
    power_cycle();
    run_ms(900);
    check(told_parameters().empty(), "a bit that fell leaves none");
    Insisting host;
    const Frame told = host.says(ARM, 700).back();
    check(permit_of(told) == DISABLED && doubts_of(told) == exoid::NO_PARAMETERS, "and no torque");
    board.flash.slots[2][bit / 8] ^= static_cast<uint8_t>(1U << bit % 8);
  }
}

void flash_that_takes_none() {
  still_node(COUNT);
  board.flash.works = false;
  for (uint32_t place = 0; place < exoid::PARTS; ++place) refused(part(LEG, place));
  check(refused(part(LEG, exoid::PARTS)) == 1U << 2, "it says that they are not stored");
  const std::vector<Frame> told = told_parameters();
  check(!told.empty() && field(told.back(), 8, 1) == 0, "they hold until the power goes");
  power_cycle();
  check(told_parameters().empty(), "and no longer");
}

void gravity_is_taken_off() {
  enabled_node();
  run_ms(20);
  const Frame told = only(world.on_bus, exoid::TORQUE_ID).back();
  const double expected = std::fmin(LEG.limit, LEG.gravity * std::cos(ANGLE + LEG.thigh_angle));
  check(std::fabs(torque_of(told) - expected) < 2e-3, "the torque is that of gravity");
  check(doubts_of(told) == 0 && field(told, 48, 16) == exoid::crc_of(LEG), "by these parameters");
}

void limits_are_kept() {
  Insisting host = enabled_node(8);
  host.says(OFF, 40);
  host.says(ARM, 40);
  double before = 0.0, most = 0.0;
  for (const Frame& told : host.says(ENABLE, 1000)) {
    check(std::fabs(torque_of(told) - before) <= LEG.rate_limit * 0.01 + 1e-3, "it rises slowly");
    before = torque_of(told);
    most = std::fmax(most, before);
  }
  check(most == 2.0, "up to what the host allows");
}

/// Only what is armed anew commands a torque again.
void check_it_stays_off(Insisting& host, const char* sentence) {
  for (const Frame& told : host.says(ENABLE, 1500)) {
    check(torque_of(told) == 0.0 && permit_of(told) == DISABLED, sentence);
  }
  check(permit_of(host.says(ARM, 60).back()) == ARMED, "until it is armed anew");
  check(torque_of(host.says(ENABLE, 400).back()) > 1.0, "and enabled");
}

void sensor_faults_cut() {
  Insisting host = enabled_node();
  for (uint16_t fault : {chips::ENCODER_SILENT, chips::IMU_SILENT, chips::MAGNET_MISSING,
                         chips::MAGNET_WEAK, chips::MAGNET_STRONG}) {
    world.leg = [=](uint32_t) {
      chips::Exposure now = {};
      now.count = COUNT;
      now.faults = fault;
      return now;
    };
    const std::vector<Frame> told = host.says(ENABLE, 40);
    const std::vector<Frame> states = only(world.on_bus, exoid::STATE_ID);
    for (const Frame& each : told) {
      for (const Frame& state : states) {
        const bool faulty = field(state, 56, 8) != 0 && field(state, 48, 8) == field(each, 16, 8);
        check(!faulty || torque_of(each) == 0.0, "the torque of that same tick is 0");
      }
    }
    check(field(states.back(), 56, 8) != 0, "the fault was there");
    check((doubts_of(told.back()) & 255U) != 0, "and is told");
    hold(COUNT);
    check_it_stays_off(host, "what was disabled stays so");
  }
}

void a_silent_host_cuts() {
  Insisting host = enabled_node();
  const Frame echo = host.frame(ENABLE);
  world.on_bus.clear();
  for (uint32_t ms = 0; ms < 300; ms += 20) {
    board.can.hear(echo);  // one frame again and again is no host
    run_ms(20);
  }
  uint32_t ticks = 0;
  for (const Frame& told : only(world.on_bus, exoid::TORQUE_ID)) ticks += torque_of(told) != 0.0;
  check(ticks > 5 && ticks <= exoid::LONGEST_UNHEARD, "the torque ends within 100 ms");
  const Frame last = only(world.on_bus, exoid::TORQUE_ID).back();
  check(doubts_of(last) == exoid::HOST_SILENT, "and it is told why");
  check_it_stays_off(host, "a host that is heard again must arm");
}

void commands_cut() {
  Insisting host = enabled_node();
  const Frame foreign = command(exoid::ALLOW_ID, SERIAL + 1, OFF | 1U << 2, 24);
  board.can.hear(foreign);
  check(torque_of(host.says(ENABLE, 40).back()) > 1.0, "what is said to another node changes nothing");
  check(torque_of(host.says(OFF, 20).back()) == 0.0, "off is off");
  check_it_stays_off(host, "and stays so");
  set(exoid::SET_ZERO_ID, 0, 16);
  check(doubts_of(host.says(ENABLE, 20).back()) != 0, "another zero is another leg");
  hold(COUNT);
  set(exoid::SET_ZERO_ID, static_cast<uint32_t>(COUNT - 2048) & 0xFFFFU, 16);
  run_ms(600);
  check_it_stays_off(host, "and must be armed anew");
  board.can.hear(part(LEG, 0));
  check(torque_of(host.says(ENABLE, 20).back()) > 1.0, "a part of new parameters changes nothing");
  for (uint32_t place = 1; place < exoid::PARTS; ++place) {
    board.can.hear(part(LEG, place));
    host.says(ENABLE, 40);
  }
  board.can.hear(part(LEG, exoid::PARTS));
  check(torque_of(host.says(ENABLE, 40).back()) == 0.0, "all of them do");
  check_it_stays_off(host, "and must be armed anew");
}

/// An encoder that answers, and shows one angle while the leg moves.
void an_encoder_that_hangs_cuts() {
  Insisting host = enabled_node();
  const uint32_t began = board.ticks;
  world.leg = [=](uint32_t tick) {
    chips::Exposure now = {};
    now.count = COUNT;
    now.gyro[1] = static_cast<int16_t>(tick > began + 2 ? -1.0 / exoid::GYRO_STEP : 0);  // 1 rad/s
    return now;
  };
  uint32_t ticks = 0;
  for (const Frame& told : host.says(ENABLE, 400)) ticks += torque_of(told) != 0.0;
  check(ticks >= 5 && ticks <= 16, "the torque ends within 16 ticks at 1 rad/s");
  hold(COUNT);
  run_ms(3000);
  check_it_stays_off(host, "and must be armed anew");
}

}  // namespace

std::vector<Scenario> torque_scenarios() {
  return {
      {"nobody_asks", nobody_asks},
      {"parameters_that_come_whole", parameters_that_come_whole},
      {"parameters_that_do_not", parameters_that_do_not},
      {"a_part_that_is_sent_twice", a_part_that_is_sent_twice},
      {"flash_that_is_damaged", flash_that_is_damaged},
      {"flash_that_takes_none", flash_that_takes_none},
      {"gravity_is_taken_off", gravity_is_taken_off},
      {"limits_are_kept", limits_are_kept},
      {"sensor_faults_cut", sensor_faults_cut},
      {"a_silent_host_cuts", a_silent_host_cuts},
      {"commands_cut", commands_cut},
      {"an_encoder_that_hangs_cuts", an_encoder_that_hangs_cuts},
  };
}
