// The node on the leg: a sample every 10 ms, sent as the frames of exoid.dbc.

#include <Arduino.h>

#include "src/board.h"
#include "src/condition.h"
#include "src/encoder_link.h"
#include "src/node.h"
#include "src/sensors.h"
#include "src/uplink.h"
#include "src/wire_bus.h"

namespace config = exoid::config;
using exoid::EncoderLink;
using exoid::SamplingTimer;
using exoid::UsbPort;
using exoid::WireBus;
using Can = exoid::CanController;
using EncoderOf = exoid::EncoderOf<config::ENCODER, WireBus, EncoderLink>;
using Encoder = EncoderOf::Driver;
using Imu = exoid::ImuOf<config::IMU, WireBus>::Driver;
using UsbAndCan = exoid::Uplink<Can, UsbPort>;
using Condition = exoid::Condition<exoid::Watchdog, WireBus, Can>;
using Node = exoid::Node<Encoder, Imu, UsbAndCan, SamplingTimer, Condition>;

WireBus bus;
EncoderLink encoder_link;
Encoder encoder(EncoderOf::link(bus, encoder_link));
Imu imu(bus);
exoid::CanLink can_link;
Can can(can_link);
UsbPort usb;
UsbAndCan uplink(can, usb);
SamplingTimer timer;
exoid::Watchdog watchdog;
Condition condition(watchdog, bus, can);
Node node(encoder, imu, uplink, timer, condition);

void setup() {
  usb.begin();
  bus.begin();
  if (config::ENCODER != exoid::EncoderPart::AS5600) encoder_link.begin();
  uplink.begin();
  watchdog.begin();
  timer.begin();
}

void loop() {
  if (uplink.poll(millis())) node.restart();
  if (node.run()) watchdog.feed();
}
