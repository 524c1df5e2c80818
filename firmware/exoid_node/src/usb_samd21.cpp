#include "usb_samd21.h"

#if defined(ARDUINO_ARCH_SAMD)

#include <Arduino.h>

namespace {

constexpr uint8_t CDC_IN = 3;  // the serial port's endpoints are 1, 2 and 3

}  // namespace

namespace exoid {

bool usb_packet_is_taken() {
  return (USB->DEVICE.DeviceEndpoint[CDC_IN].EPSTATUS.reg & USB_DEVICE_EPSTATUS_BK1RDY) == 0;
}

void usb_withdraw_packet() {
  USB->DEVICE.DeviceEndpoint[CDC_IN].EPSTATUSCLR.reg = USB_DEVICE_EPSTATUSCLR_BK1RDY;
}

}  // namespace exoid

#endif
