// The node on the leg: a sample every 10 ms, sent as the frames of exoid.dbc.

#include <Arduino.h>

#include "src/can_timing.h"
#include "src/condition.h"
#include "src/encoder_link.h"
#include "src/mcp2515.h"
#include "src/node.h"
#include "src/sensors.h"
#include "src/spi_link.h"
#include "src/timer_samd21.h"
#include "src/uplink.h"
#include "src/usb_port.h"
#include "src/watchdog_samd21.h"
#include "src/wire_bus.h"

namespace config = exoid::config;
using exoid::EncoderLink;
using exoid::SamplingTimer;
using exoid::SpiLink;
using exoid::UsbPort;
using exoid::WireBus;
using CanTiming = exoid::CanTiming<config::CAN_CRYSTAL, config::CAN_BIT_RATE>;
using Can = exoid::Mcp2515<SpiLink, CanTiming, config::CanUnderstood>;
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
SpiLink spi;
Can can(spi);
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
