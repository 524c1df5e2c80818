/// What the sketch uses of the Teensy's core, on a machine that simulates the board. Names and
/// values of registers as in the core's imxrt.h; what they do goes to the simulated board.

#pragma once

#include <stddef.h>
#include <stdint.h>

#if defined(ARDUINO)
// The words that the real header takes away. Without effect, so that their use does not compile.
#define bit(...)
#define word(...)
#define constrain(...)
#define radians(...)
#define degrees(...)
#define sq(...)
#define F(...)
#define bitRead(...)
#define bitSet(...)
#define bitClear(...)
#define bitWrite(...)
#define lowByte(...)
#define highByte(...)
#define interrupts(...)
#define noInterrupts(...)
#define cli(...)
#define sei(...)
#endif

#define HIGH 1
#define LOW 0
#define OUTPUT 1
#define INPUT_PULLUP 2
#define PIN_WIRE_SDA (18)
#define PIN_WIRE_SCL (19)

void pinMode(uint8_t pin, uint8_t mode);
void digitalWrite(uint8_t pin, uint8_t level);
uint8_t digitalRead(uint8_t pin);
void delayMicroseconds(uint32_t time);
uint32_t micros();
uint32_t millis();
void __disable_irq();
void __enable_irq();

/// A register that tells the board of every write.
struct Told {
  void operator=(uint32_t value);
  uint32_t value;
};

extern volatile uint32_t HW_OCOTP_CFG0, HW_OCOTP_CFG1;
extern volatile uint32_t CCM_CSCMR2, CCM_CCGR0, CCM_CCGR5, SRC_SRSR;
extern volatile uint32_t IOMUXC_SW_MUX_CTL_PAD_GPIO_AD_B1_08, IOMUXC_SW_PAD_CTL_PAD_GPIO_AD_B1_08;
extern volatile uint32_t IOMUXC_SW_MUX_CTL_PAD_GPIO_AD_B1_09, IOMUXC_SW_PAD_CTL_PAD_GPIO_AD_B1_09;
extern volatile uint32_t IOMUXC_FLEXCAN1_RX_SELECT_INPUT;
extern Told WDOG3_CNT, WDOG3_CS, WDOG3_WIN, WDOG3_TOVAL;
extern uint32_t flexcan1[0x900 / 4];

#define IMXRT_FLEXCAN1_ADDRESS reinterpret_cast<uintptr_t>(flexcan1)
#define CCM_CCGR_ON 3
#define CCM_CSCMR2_CAN_CLK_SEL(n) ((uint32_t)(((n) & 0x03) << 8))
#define CCM_CCGR0_CAN1(n) ((uint32_t)(((n) & 0x03) << 14))
#define CCM_CCGR0_CAN1_SERIAL(n) ((uint32_t)(((n) & 0x03) << 16))
#define CCM_CCGR5_WDOG3(n) ((uint32_t)(((n) & 0x03) << 4))
#define SRC_SRSR_WDOG3_RST_B ((uint32_t)(1 << 7))
#define WDOG_CS_UPDATE ((uint16_t)(1 << 5))
#define WDOG_CS_EN ((uint16_t)(1 << 7))
#define WDOG_CS_CLK(n) ((uint16_t)(((n) & 0x03) << 8))
#define WDOG_CS_CMD32EN ((uint16_t)(1 << 13))

/// One of the timers of 24 MHz.
class IntervalTimer {
 public:
  bool begin(void (*call)(), uint32_t period_us);
};

/// The serial port on USB: it has the room that it tells.
class UsbSerial {
 public:
  int available();
  int read();
  int availableForWrite();
  uint8_t dtr();
  size_t write(const uint8_t* bytes, size_t count);
};

extern UsbSerial Serial;

void setup();
void loop();
