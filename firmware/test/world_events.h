/// What befalls the node in a test, and what is heard of it, as records of files.

#pragma once

#include <stdint.h>

namespace world_events {

enum Kind : uint16_t {
  SENSORS,           // value: the chips' faults, until the next event of this kind
  CLOCK_HELD,        // 1 by a device, 0 let go
  CLOCK_HELD_AFTER,  // value: bytes from now
  DATA_HELD_AFTER,   // value: 16 * bytes from now + clock pulses
  GLITCH,            // the bus looks busy; value 0: and the time-outs do not count
  CONTROLLER,        // 0 answers, 1 and 2 dead: MISO low, high
  ACKNOWLEDGED,      // 1 somebody else is on the bus
  SHORTED,           // 1 the bus, 2 and the controller stays off it, 0 no more
  FOREIGN,           // value: identifier of the frames of another node
  USB_READS,         // 1 the host takes what is sent
  USB_PLUGGED,
  USB_HELD,          // 0 the program there is killed, 1 another one takes the port
  TYPED,             // value: a command of one letter
  TIMER_STANDS,      // the sampling timer ticks no more
  BROWN_OUT,         // of the whole node; value: ms without a supply
  PASS,              // value: us of a pass of the loop besides what it waits
  QUIET,             // from now on only what is not as it should be is written
  END,
};

struct Event {
  uint32_t at_ms;
  uint16_t kind;
  int16_t value;
};

enum Link : uint16_t { ON_CAN, ON_USB, RESTARTED, LONGEST_PASS };

struct Heard {
  uint32_t at_ms;
  uint16_t link;
  uint16_t id;  // of a frame; bytes of a packet; ticks of the node where it restarted
  uint8_t data[8];
};

}  // namespace world_events
