// SPDX-License-Identifier: MIT
#include "hal/stm32f4/supply.hpp"

namespace fantail::hal::stm32f4 {

using namespace registers;

// RM0090 section 5.2.3: its output rises when the supply falls.
Supply::Supply(Pwr& power, Exti& lines) : power_{&power}, lines_{&lines} {
  power.cr.set(pwr_cr_pls | pwr_cr_pvde);
  lines.rtsr.set(exti_voltage_detector);
  lines.imr.set(exti_voltage_detector);
}

void Supply::update() {
  const bool dipped = lines_->pr.any(exti_voltage_detector);
  lines_->pr.write(exti_voltage_detector);
  // The first edge may be that of the detector, which was switched on.
  if ((dipped && looked_) || power_->csr.any(pwr_csr_pvdo)) {
    ticks_left_ = ticks_told;
  } else if (ticks_left_ > 0) {
    ticks_left_ -= 1;
  }
  looked_ = true;
}

BoardFaults Supply::faults() const {
  BoardFaults faults;
  if (ticks_left_ > 0) {
    faults.add(BoardFault::supply_low);
  }
  return faults;
}

}  // namespace fantail::hal::stm32f4
