// The node on the leg: a sample every 10 ms, sent as the frames of exoid.dbc.

#include <Arduino.h>

#include "src/as5600.h"
#include "src/board_samd21.h"
#include "src/flash_samd21.h"
#include "src/lsm6ds3.h"
#include "src/mcp2515.h"
#include "src/spi_link.h"
#include "src/tended_node.h"
#include "src/timer_samd21.h"
#include "src/uplink.h"
#include "src/usb_port.h"
#include "src/watchdog_samd21.h"
#include "src/wire_bus.h"

using exoid::SpiLink;
using exoid::UsbPort;
using exoid::WireBus;
using Can = exoid::Mcp2515<SpiLink, exoid::config::CAN_CRYSTAL, exoid::CommandIds>;

struct Kinds {
  using Encoder = exoid::As5600<WireBus>;
  using Imu = exoid::Lsm6ds3<WireBus>;
  using Link = exoid::Uplink<Can, UsbPort>;
  using Flash = exoid::ProcessorFlash;
  using Board = exoid::Board;
  using Clock = exoid::SamplingTimer;
  using Condition = exoid::Condition<exoid::Watchdog, WireBus, Can>;
};

WireBus bus;
Kinds::Encoder encoder(bus);
Kinds::Imu imu(bus);
SpiLink spi;
Can can(spi);
UsbPort usb;
Kinds::Link uplink(can, usb);
Kinds::Flash flash;
Kinds::Board nano;
Kinds::Clock timer;
exoid::Watchdog watchdog;
Kinds::Condition condition(watchdog, bus, can);
exoid::TendedNode<Kinds> node({encoder, imu, uplink, flash, nano, timer, condition});

void setup() {
  usb.begin();
  bus.begin();
  node.begin();
  watchdog.begin();
  timer.begin();
}

void loop() {
  if (node.run(millis())) watchdog.feed();
}
