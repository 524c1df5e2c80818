/// What the sketch uses of Arduino, on a machine that simulates the board: see board/board.h.

#pragma once

#include <stddef.h>
#include <stdint.h>

#if defined(ARDUINO)
// The words that the real header takes away. Without effect, so that their use does not compile.
#define word(...)
#define bit(...)
#define min(...)
#define max(...)
#define abs(...)
#define round(...)
#define radians(...)
#define degrees(...)
#define constrain(...)
#define sq(...)
#define F(...)
#define bitRead(...)
#define bitSet(...)
#define bitClear(...)
#define bitWrite(...)
#define lowByte(...)
#define highByte(...)
#define noInterrupts(...)
#define synchronized
#endif

#include "samd21.h"

// No number passes for one of these.
enum PinStatus { LOW, HIGH };
enum PinMode { INPUT, OUTPUT, INPUT_PULLUP };
constexpr uint8_t ENCODER_SELECT = 9, CAN_SELECT = 10, PIN_WIRE_SDA = 18, PIN_WIRE_SCL = 19;

void pinMode(uint8_t pin, PinMode mode);
void digitalWrite(uint8_t pin, PinStatus level);
PinStatus digitalRead(uint8_t pin);
void delayMicroseconds(uint32_t time);
uint32_t micros();
uint32_t millis();

/// The serial port on USB. Like the board's, it always claims room for a packet.
class UsbSerial {
 public:
  void begin(uint32_t) {}
  int available();
  int read();
  int availableForWrite() { return 63; }
  bool dtr();
  size_t write(const uint8_t* bytes, size_t count);
};

extern UsbSerial Serial;

void setup();
void loop();
