// The node on the leg: a sample every 10 ms, sent as the frames of exoid.dbc.

#include <Arduino.h>

#include "src/as5600.h"
#include "src/lsm6ds3.h"
#include "src/mcp2515_can.h"
#include "src/node.h"
#include "src/timer_samd21.h"
#include "src/uplink.h"
#include "src/wire_bus.h"

using exoid::Mcp2515Can;
using exoid::SamplingTimer;
using exoid::WireBus;
using Encoder = exoid::As5600<WireBus>;
using Imu = exoid::Lsm6ds3<WireBus>;
using UsbOrCan = exoid::Uplink<Mcp2515Can, decltype(Serial)>;

WireBus bus;
Encoder encoder(bus);
Imu imu(bus);
Mcp2515Can can;
UsbOrCan uplink(can, Serial);
SamplingTimer timer;
exoid::Node<Encoder, Imu, UsbOrCan, SamplingTimer> node(encoder, imu, uplink, timer);

void setup() {
  Serial.begin(115200);
  bus.begin();
  uplink.begin();
  timer.begin();
}

void loop() {
  if (uplink.poll()) node.restart();
  node.run();
}
