/// The registers of the SAMD21 that timer, flash and supply use, as memory: names as its headers'.

#pragma once

#include <stdint.h>

constexpr uint32_t VARIANT_MCK = 48000000;  // Hz

/// Read alone.
struct Status {
  const struct {
    bool SYNCBUSY;
  } bit;
};

struct Control {
  uint16_t reg;
  struct {
    bool SWRST;
  } bit;
};

template <class Word>
struct Register {
  Word reg;
};

struct GenericClock {
  Register<uint16_t> CLKCTRL;
  Status STATUS;
};

/// What the counter shows was its value when a read of it was last asked for.
struct Requested {
  void operator=(uint16_t request);
};

struct TimerCounter {
  struct {
    Control CTRLA;
    struct {
      Requested reg;
    } READREQ;
    Status STATUS;
    Register<uint8_t> INTENSET, INTFLAG;
    Register<uint16_t> COUNT, CC[2];
  } COUNT16;
};

enum Interrupt { TC3_IRQn = 18 };

constexpr uint32_t GCLK_CLKCTRL_CLKEN = 1U << 14, GCLK_CLKCTRL_GEN_GCLK0 = 0;
constexpr uint32_t GCLK_CLKCTRL_ID_TCC2_TC3 = 0x1B;
constexpr uint32_t TC_CTRLA_SWRST = 1, TC_CTRLA_ENABLE = 2, TC_CTRLA_MODE_COUNT16 = 0;
constexpr uint32_t TC_CTRLA_WAVEGEN_MFRQ = 1U << 5, TC_CTRLA_PRESCALER_DIV64 = 5U << 8;
constexpr uint32_t TC_INTENSET_MC0 = 1U << 4, TC_INTFLAG_MC0 = 1U << 4;
constexpr uint32_t TC_READREQ_RREQ = 1U << 15, TC_COUNT16_COUNT_OFFSET = 0x10;
constexpr uint32_t TC_READREQ_ADDR(uint32_t value) { return value; }

extern GenericClock* const GCLK;
extern TimerCounter* const TC3;

/// A register whose writing does something.
struct FlashCommand {
  void operator=(uint16_t command);
};

struct FlashController {
  struct {
    FlashCommand reg;
  } CTRLA;
  struct {
    struct {
      bool MANW, CACHEDIS;
    } bit;
  } CTRLB;
  Register<uint32_t> ADDR;
  struct {
    struct {
      bool READY;
    } bit;
  } INTFLAG;
};

constexpr uint32_t NVMCTRL_CTRLA_CMDEX_KEY = 0xA500;
constexpr uint32_t NVMCTRL_CTRLA_CMD_ER = 0x02, NVMCTRL_CTRLA_CMD_WP = 0x04;
constexpr uint32_t NVMCTRL_CTRLA_CMD_PBC = 0x44, NVMCTRL_CTRLA_CMD_INVALL = 0x46;

extern FlashController* const NVMCTRL;

/// Begins a conversion.
struct Start {
  void operator=(uint8_t);
};

struct Count {
  operator uint32_t();
  uint16_t count;
};

struct Ready {
  operator bool() const { return is_set; }
  bool is_set;
};

struct Converter {
  Register<uint8_t> CTRLA, REFCTRL;
  Register<uint16_t> CTRLB;
  Register<uint32_t> INPUTCTRL;
  Status STATUS;
  struct {
    struct {
      Start START;
    } bit;
  } SWTRIG;
  struct {
    struct {
      Ready RESRDY;
    } bit;
  } INTFLAG;
  struct {
    Count reg;
  } RESULT;
};

constexpr uint32_t ADC_CTRLA_ENABLE = 2, ADC_REFCTRL_REFSEL_INT1V = 0;
constexpr uint32_t ADC_CTRLB_PRESCALER_DIV64 = 4U << 8, ADC_CTRLB_RESSEL_12BIT = 0;
constexpr uint32_t ADC_INPUTCTRL_GAIN_1X = 0, ADC_INPUTCTRL_MUXNEG_GND = 0x18U << 8;
constexpr uint32_t ADC_INPUTCTRL_MUXPOS_SCALEDIOVCC = 0x1B;

extern Converter* const ADC;

enum PinStatus { LOW, HIGH };
enum PinMode { INPUT, OUTPUT, INPUT_PULLUP };

void pinMode(uint8_t pin, PinMode mode);
void digitalWrite(uint8_t pin, PinStatus level);
void NVIC_EnableIRQ(Interrupt number);
uint32_t micros();
