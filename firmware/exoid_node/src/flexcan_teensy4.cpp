#include "flexcan_teensy4.h"

#if defined(__IMXRT1062__)

#include <Arduino.h>

namespace {

constexpr uint32_t CLOCK_BITS = 0x3FC;                    // of CSCMR2: source and divider
constexpr uint32_t OSCILLATOR = 1;                        // the source of 24 MHz
constexpr uint32_t CAN_AND_ITSELF_ON = 2U | 0x10U;        // pad function ALT2, its input kept on
constexpr uint32_t PAD = 0x10B0;                          // pull-up, medium speed
constexpr uint32_t FROM_PIN_23 = 2;                       // pad GPIO_AD_B1_09

volatile uint32_t& cell(uint32_t offset) {
  return *reinterpret_cast<volatile uint32_t*>(IMXRT_FLEXCAN1_ADDRESS + offset);
}

}  // namespace

namespace exoid {

/// The values are those of FlexCAN_T4's setClock(CLK_24MHz), setTX, setRX and begin.
void FlexCanRegisters::begin() {
  CCM_CSCMR2 = (CCM_CSCMR2 & ~CLOCK_BITS) | CCM_CSCMR2_CAN_CLK_SEL(OSCILLATOR);
  CCM_CCGR0 |= CCM_CCGR0_CAN1(CCM_CCGR_ON) | CCM_CCGR0_CAN1_SERIAL(CCM_CCGR_ON);
  IOMUXC_SW_MUX_CTL_PAD_GPIO_AD_B1_08 = CAN_AND_ITSELF_ON;
  IOMUXC_SW_PAD_CTL_PAD_GPIO_AD_B1_08 = PAD;
  IOMUXC_FLEXCAN1_RX_SELECT_INPUT = FROM_PIN_23;
  IOMUXC_SW_MUX_CTL_PAD_GPIO_AD_B1_09 = CAN_AND_ITSELF_ON;
  IOMUXC_SW_PAD_CTL_PAD_GPIO_AD_B1_09 = PAD;
}

uint32_t FlexCanRegisters::read(uint32_t offset) { return cell(offset); }

void FlexCanRegisters::write(uint32_t offset, uint32_t value) { cell(offset) = value; }

}  // namespace exoid

#endif
