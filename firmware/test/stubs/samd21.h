/// The SAMD21's registers that the node uses, under the names of its headers. What is read from and
/// written to them goes to the simulated board.

#pragma once

#include <stdint.h>

namespace simulated {

enum Where : uint8_t {
  NOWHERE, IN_SERCOM, IN_USB, IN_USB_CLEAR, IN_WATCHDOG_STATUS, IN_WATCHDOG_CONTROL, IN_WATCHDOG_CLEAR,
  IN_CLOCK_CONTROL, IN_RESET_CAUSE,
};

uint32_t read(Where where, uint8_t at);
void write(Where where, uint8_t at, uint32_t value);

[[noreturn]] void violated(const char* sentence);

/// A register that is read alone.
template <Where WHERE, uint8_t AT>
struct Shown {
  operator uint32_t() const { return read(WHERE, AT); }
};

/// One that is written, too, of so many bits as `Word`.
template <class Word, Where WHERE, uint8_t AT>
struct Cell : Shown<WHERE, AT> {
  void operator=(uint32_t value) {
    if (static_cast<Word>(value) != value) violated("a register has room for what it is given");
    write(WHERE, AT, value);
  }
};

template <class Word, Where WHERE, uint8_t AT = 0>
struct Register {
  Cell<Word, WHERE, AT> reg;
};

template <Where WHERE, uint8_t AT = 0>
struct ReadOnly {
  Shown<WHERE, AT> reg;
};

template <Where WHERE>
struct Synchronised {
  struct {
    Shown<WHERE, 0> SYNCBUSY;
  } bit;
};

}  // namespace simulated

struct SercomI2cm {
  simulated::Register<uint32_t, simulated::IN_SERCOM, 0> CTRLA;
  simulated::Register<uint32_t, simulated::IN_SERCOM, 1> CTRLB;
  simulated::Register<uint16_t, simulated::IN_SERCOM, 2> STATUS;
  simulated::Register<uint8_t, simulated::IN_SERCOM, 3> INTFLAG;
  simulated::ReadOnly<simulated::IN_SERCOM, 4> SYNCBUSY;
  simulated::Register<uint32_t, simulated::IN_SERCOM, 5> ADDR;
  simulated::Register<uint8_t, simulated::IN_SERCOM, 6> DATA;
};

struct Sercom4 {
  SercomI2cm I2CM;
};

struct GenericClock {
  simulated::Register<uint16_t, simulated::IN_CLOCK_CONTROL> CLKCTRL;
  simulated::Register<uint32_t, simulated::NOWHERE> GENDIV, GENCTRL;
  simulated::Synchronised<simulated::NOWHERE> STATUS;
};

struct WatchdogTimer {
  simulated::Register<uint8_t, simulated::IN_WATCHDOG_CONTROL> CTRL;
  simulated::Register<uint8_t, simulated::NOWHERE> CONFIG;
  simulated::Register<uint8_t, simulated::IN_WATCHDOG_CLEAR> CLEAR;
  simulated::Synchronised<simulated::IN_WATCHDOG_STATUS> STATUS;
};

struct UsbRegisters {
  struct {
    struct {
      simulated::Register<uint8_t, simulated::IN_USB_CLEAR> EPSTATUSCLR;
      simulated::ReadOnly<simulated::IN_USB> EPSTATUS;
    } DeviceEndpoint[8];
  } DEVICE;
};

struct PowerManager {
  simulated::ReadOnly<simulated::IN_RESET_CAUSE> RCAUSE;
};

extern Sercom4 sercom4;
extern GenericClock generic_clock;
extern WatchdogTimer watchdog_timer;
extern UsbRegisters usb_registers;
extern PowerManager power_manager;

static Sercom4* const SERCOM4 = &sercom4;
static GenericClock* const GCLK = &generic_clock;
static WatchdogTimer* const WDT = &watchdog_timer;
static UsbRegisters* const USB = &usb_registers;
static PowerManager* const PM = &power_manager;

constexpr uint32_t SERCOM_I2CM_CTRLA_ENABLE = 1U << 1, SERCOM_I2CM_CTRLA_MEXTTOEN = 1U << 22;
constexpr uint32_t SERCOM_I2CM_CTRLA_SEXTTOEN = 1U << 23, SERCOM_I2CM_CTRLA_LOWTOUTEN = 1U << 30;
constexpr uint32_t SERCOM_I2CM_CTRLA_INACTOUT(uint32_t value) { return value << 28; }
constexpr uint32_t SERCOM_I2CM_CTRLB_ACKACT = 1U << 18;
constexpr uint32_t SERCOM_I2CM_CTRLB_CMD(uint32_t value) { return value << 16; }
constexpr uint8_t SERCOM_I2CM_INTFLAG_MB = 1, SERCOM_I2CM_INTFLAG_SB = 2;
constexpr uint32_t SERCOM_I2CM_STATUS_BUSERR = 1, SERCOM_I2CM_STATUS_ARBLOST = 2;
constexpr uint32_t SERCOM_I2CM_STATUS_RXNACK = 4, SERCOM_I2CM_STATUS_LOWTOUT = 64;
constexpr uint32_t SERCOM_I2CM_STATUS_BUSSTATE_Msk = 48, SERCOM_I2CM_STATUS_BUSSTATE_Pos = 4;
constexpr uint32_t SERCOM_I2CM_STATUS_BUSSTATE(uint32_t value) { return value << 4; }
constexpr uint32_t SERCOM_I2CM_SYNCBUSY_ENABLE = 2, SERCOM_I2CM_SYNCBUSY_SYSOP = 4;

constexpr uint32_t GCLK_CLKCTRL_CLKEN = 1U << 14, GCLK_CLKCTRL_GEN_GCLK1 = 1U << 8;
constexpr uint32_t GCLK_CLKCTRL_GEN_GCLK2 = 2U << 8;
constexpr uint32_t GCLK_CLKCTRL_ID_WDT = 0x03, GCLK_CLKCTRL_ID_SERCOMX_SLOW = 0x13;
constexpr uint32_t GCLK_GENDIV_ID(uint32_t value) { return value; }
constexpr uint32_t GCLK_GENDIV_DIV(uint32_t value) { return value << 8; }
constexpr uint32_t GCLK_GENCTRL_ID(uint32_t value) { return value; }
constexpr uint32_t GCLK_GENCTRL_SRC_OSCULP32K = 3U << 8, GCLK_GENCTRL_GENEN = 1U << 16;
constexpr uint32_t GCLK_GENCTRL_DIVSEL = 1U << 20;
constexpr uint32_t WDT_CONFIG_PER_128 = 4, WDT_CTRL_ENABLE = 2;
constexpr uint32_t USB_DEVICE_EPSTATUS_BK1RDY = 128, USB_DEVICE_EPSTATUSCLR_BK1RDY = 128;
constexpr uint8_t PM_RCAUSE_POR = 1, PM_RCAUSE_BOD12 = 2, PM_RCAUSE_BOD33 = 4, PM_RCAUSE_WDT = 32;
