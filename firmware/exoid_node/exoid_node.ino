// The node on the leg: a sample every 10 ms, sent as the frames of exoid.dbc.

#include <Arduino.h>

#include "src/as5600.h"
#include "src/can_timing.h"
#include "src/condition.h"
#include "src/lsm6ds3.h"
#include "src/mcp2515.h"
#include "src/node.h"
#include "src/spi_link.h"
#include "src/timer_samd21.h"
#include "src/uplink.h"
#include "src/usb_port.h"
#include "src/watchdog_samd21.h"
#include "src/wire_bus.h"

namespace config = exoid::config;
using exoid::SamplingTimer;
using exoid::SpiLink;
using exoid::UsbPort;
using exoid::WireBus;
using CanTiming = exoid::CanTiming<config::CAN_CRYSTAL, config::CAN_BIT_RATE>;
using Can = exoid::Mcp2515<SpiLink, CanTiming, config::CanUnderstood>;
using Encoder = exoid::As5600<WireBus>;
using Imu = exoid::Lsm6ds3<WireBus>;
using UsbAndCan = exoid::Uplink<Can, UsbPort>;
using Condition = exoid::Condition<exoid::Watchdog, WireBus, Can>;
using Node = exoid::Node<Encoder, Imu, UsbAndCan, SamplingTimer, Condition>;

WireBus bus;
Encoder encoder(bus);
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
  uplink.begin();
  watchdog.begin();
  timer.begin();
}

void loop() {
  if (uplink.poll(millis())) node.restart();
  if (node.run()) watchdog.feed();
}
