// The node on the leg: a sample every 10 ms, sent as the frames of exoid.dbc.

#include <Arduino.h>

#include "src/as5600.h"
#include "src/board_samd21.h"
#include "src/flash_samd21.h"
#include "src/lsm6ds3.h"
#include "src/mcp2515_can.h"
#include "src/tended_node.h"
#include "src/timer_samd21.h"
#include "src/uplink.h"
#include "src/wire_bus.h"

using exoid::Mcp2515Can;
using exoid::SamplingTimer;
using exoid::WireBus;

struct Parts {
  using Encoder = exoid::As5600<WireBus>;
  using Imu = exoid::Lsm6ds3<WireBus>;
  using Link = exoid::Uplink<Mcp2515Can, decltype(Serial)>;
  using Flash = exoid::ProcessorFlash;
  using Board = exoid::Board;
  using Clock = SamplingTimer;
};

WireBus bus;
Parts::Encoder encoder(bus);
Parts::Imu imu(bus);
Mcp2515Can can;
Parts::Link uplink(can, Serial);
Parts::Flash flash;
Parts::Board board;
SamplingTimer timer;
exoid::TendedNode<Parts> node(encoder, imu, uplink, flash, board, timer);

void setup() {
  Serial.begin(115200);
  bus.begin();
  node.begin();
  timer.begin();
}

void loop() { node.run(); }
