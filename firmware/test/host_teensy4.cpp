// What the Teensy's CAN controller needs of clocks and pins, on registers that are memory.

#include <Arduino.h>

#include "flexcan_teensy4.cpp"
#include "host_check.h"

volatile uint32_t CCM_CSCMR2 = 0xFFFFFFFF, CCM_CCGR0, IOMUXC_FLEXCAN1_RX_SELECT_INPUT;
volatile uint32_t IOMUXC_SW_MUX_CTL_PAD_GPIO_AD_B1_08, IOMUXC_SW_PAD_CTL_PAD_GPIO_AD_B1_08;
volatile uint32_t IOMUXC_SW_MUX_CTL_PAD_GPIO_AD_B1_09, IOMUXC_SW_PAD_CTL_PAD_GPIO_AD_B1_09;
uint32_t flexcan1[0x900 / 4];

int main() {
  exoid::FlexCanRegisters registers;
  registers.begin();
  // FlexCAN_T4's setClock(CLK_24MHz), setTX and setRX write these.
  check(CCM_CSCMR2 == 0xFFFFFD03, "it counts the oscillator's 24 MHz, and no other bit changes");
  check(CCM_CCGR0 == 0x3C000, "both of its clocks run");
  check(IOMUXC_SW_MUX_CTL_PAD_GPIO_AD_B1_08 == 0x12, "pin 22 sends");
  check(IOMUXC_SW_MUX_CTL_PAD_GPIO_AD_B1_09 == 0x12, "pin 23 receives");
  check(IOMUXC_SW_PAD_CTL_PAD_GPIO_AD_B1_08 == 0x10B0, "with the pads of the library");
  check(IOMUXC_SW_PAD_CTL_PAD_GPIO_AD_B1_09 == 0x10B0, "both");
  check(IOMUXC_FLEXCAN1_RX_SELECT_INPUT == 2, "and is what the controller listens to");
  registers.write(0x884, 0x12345678);
  check(flexcan1[0x884 / 4] == 0x12345678, "a register is written at its place");
  check(registers.read(0x884) == 0x12345678, "and read");
  return 0;
}
