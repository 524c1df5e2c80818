// The Teensy's serial port on USB.

#include <Arduino.h>

#include "board.h"

using teensy::board;

UsbSerial Serial;

int UsbSerial::available() { return static_cast<int>(board.typed.size()); }

int UsbSerial::read() {
  const char first = board.typed.at(0);
  board.typed.erase(0, 1);
  return first;
}

int UsbSerial::availableForWrite() { return board.room; }

uint8_t UsbSerial::dtr() { return board.held ? 1 : 0; }

size_t UsbSerial::write(const uint8_t* bytes, size_t count) {
  if (static_cast<int>(count) > board.room) board.violated("no more is written than has room");
  board.to_host.append(reinterpret_cast<const char*>(bytes), count);
  return count;
}
