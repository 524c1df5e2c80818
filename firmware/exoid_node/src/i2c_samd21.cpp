#include "i2c_samd21.h"

#if defined(ARDUINO_ARCH_SAMD)

#include <Arduino.h>

namespace {

constexpr uint32_t LONGEST_US = 1000;  // of a transfer; thirteen bytes at 400 kHz take 300 us
constexpr uint32_t IDLE = 1, OWNER = 2;
constexpr uint32_t READ_ON = 2, STOP = 3;
constexpr uint32_t IDLE_AFTER_55_US = 1;  // of a bus that a glitch made look busy
constexpr uint8_t DONE = SERCOM_I2CM_INTFLAG_MB | SERCOM_I2CM_INTFLAG_SB;
constexpr uint32_t LOST = SERCOM_I2CM_STATUS_ARBLOST | SERCOM_I2CM_STATUS_BUSERR |
                          SERCOM_I2CM_STATUS_LOWTOUT;
constexpr uint32_t BAD = LOST | SERCOM_I2CM_STATUS_RXNACK;

/// The Nano 33 IoT's Wire is on SERCOM4.
SercomI2cm& i2c() { return SERCOM4->I2CM; }

void wait_for_sync(uint32_t busy) {
  while ((i2c().SYNCBUSY.reg & busy) != 0) {
  }
}

uint32_t bus_state() {
  return (i2c().STATUS.reg & SERCOM_I2CM_STATUS_BUSSTATE_Msk) >> SERCOM_I2CM_STATUS_BUSSTATE_Pos;
}

/// The time-outs count the 32 kHz of generator 1, which the core has started.
void start_slow_clock() {
  GCLK->CLKCTRL.reg = static_cast<uint16_t>(GCLK_CLKCTRL_CLKEN | GCLK_CLKCTRL_GEN_GCLK1 |
                                            GCLK_CLKCTRL_ID_SERCOMX_SLOW);
  while (GCLK->STATUS.bit.SYNCBUSY) {
  }
}

}  // namespace

namespace exoid {

void I2cMaster::begin() {
  start_slow_clock();
  const uint32_t settings = i2c().CTRLA.reg & ~static_cast<uint32_t>(SERCOM_I2CM_CTRLA_ENABLE);
  i2c().CTRLA.reg = settings;
  wait_for_sync(SERCOM_I2CM_SYNCBUSY_ENABLE);
  const uint32_t timed = settings | SERCOM_I2CM_CTRLA_LOWTOUTEN | SERCOM_I2CM_CTRLA_MEXTTOEN |
                         SERCOM_I2CM_CTRLA_SEXTTOEN | SERCOM_I2CM_CTRLA_INACTOUT(IDLE_AFTER_55_US);
  i2c().CTRLA.reg = timed;
  i2c().CTRLA.reg = timed | SERCOM_I2CM_CTRLA_ENABLE;
  wait_for_sync(SERCOM_I2CM_SYNCBUSY_ENABLE);
  i2c().STATUS.reg = SERCOM_I2CM_STATUS_BUSSTATE(IDLE);
  wait_for_sync(SERCOM_I2CM_SYNCBUSY_SYSOP);
}

bool I2cMaster::is_idle() const { return bus_state() == IDLE; }

bool I2cMaster::write(uint8_t device, const uint8_t* bytes, uint8_t count) {
  began_us_ = micros();
  if (!start(static_cast<uint8_t>(device << 1), SERCOM_I2CM_INTFLAG_MB)) return false;
  for (uint8_t at = 0; at < count; ++at) {
    i2c().DATA.reg = bytes[at];
    if (!wait_for(DONE) || (i2c().STATUS.reg & BAD) != 0) return false;
  }
  return true;
}

bool I2cMaster::read(uint8_t device, uint8_t* bytes, uint8_t count) {
  began_us_ = micros();
  if (!start(static_cast<uint8_t>(device << 1 | 1), SERCOM_I2CM_INTFLAG_SB)) return false;
  for (uint8_t at = 0; at < count; ++at) {
    if (!wait_for(DONE) || (i2c().STATUS.reg & LOST) != 0) return false;
    bytes[at] = static_cast<uint8_t>(i2c().DATA.reg);
    const bool last = at + 1 == count;
    if (!command(last ? STOP : READ_ON, last ? SERCOM_I2CM_CTRLB_ACKACT : 0)) return false;
  }
  return true;
}

bool I2cMaster::stop() { return command(STOP, 0); }

/// A start, or a repeated one, and the address; `expected` is the flag of a device that answers.
bool I2cMaster::start(uint8_t address, uint8_t expected) {
  const uint32_t state = bus_state();
  if (state != IDLE && state != OWNER) return false;
  i2c().ADDR.reg = address;
  return wait_for(DONE) && (i2c().INTFLAG.reg & expected) != 0 && (i2c().STATUS.reg & BAD) == 0;
}

/// Acknowledges, or not, what was read, and goes on. The answer is set before the command.
bool I2cMaster::command(uint32_t command, uint32_t acknowledge) {
  i2c().CTRLB.reg = acknowledge;
  i2c().CTRLB.reg = acknowledge | SERCOM_I2CM_CTRLB_CMD(command);
  while ((i2c().SYNCBUSY.reg & SERCOM_I2CM_SYNCBUSY_SYSOP) != 0) {
    if (is_late()) return false;
  }
  return true;
}

bool I2cMaster::wait_for(uint8_t flags) const {
  while ((i2c().INTFLAG.reg & flags) == 0) {
    if (is_late()) return false;
  }
  return true;
}

bool I2cMaster::is_late() const { return micros() - began_us_ > LONGEST_US; }

}  // namespace exoid

#endif
