// The node on the leg: a sample every 10 ms, sent as the frames of exoid.dbc.

#include <Arduino.h>

#include "src/board.h"
#include "src/encoder_link.h"
#include "src/sensors.h"
#include "src/tended_node.h"
#include "src/uplink.h"
#include "src/wire_bus.h"

namespace config = exoid::config;
using exoid::EncoderLink;
using exoid::UsbPort;
using exoid::WireBus;
using Can = exoid::CanController;
using EncoderOf = exoid::EncoderOf<config::ENCODER, WireBus, EncoderLink>;

struct Kinds {
  using Encoder = EncoderOf::Driver;
  using Imu = exoid::ImuOf<config::IMU, WireBus>::Driver;
  using Link = exoid::Uplink<Can, UsbPort>;
  using Flash = exoid::ProcessorFlash;
  using Board = exoid::Board;
  using Clock = exoid::SamplingTimer;
  using Condition = exoid::Condition<exoid::Watchdog, WireBus, Can>;
};

WireBus bus;
EncoderLink encoder_link;
Kinds::Encoder encoder(EncoderOf::link(bus, encoder_link));
Kinds::Imu imu(bus);
exoid::CanLink can_link;
Can can(can_link);
UsbPort usb;
Kinds::Link uplink(can, usb);
Kinds::Flash flash;
Kinds::Board own;
Kinds::Clock timer;
exoid::Watchdog watchdog;
Kinds::Condition condition(watchdog, bus, can);
exoid::TendedNode<Kinds> node({encoder, imu, uplink, flash, own, timer, condition});

void setup() {
  usb.begin();
  bus.begin();
  if (config::ENCODER != exoid::EncoderPart::AS5600) encoder_link.begin();
  node.begin();
  watchdog.begin();
  timer.begin();
}

void loop() {
  if (node.run(millis())) watchdog.feed();
}
