// SPDX-License-Identifier: MIT
#include "hal/stm32f4/reset_cause.hpp"

namespace fantail::hal::stm32f4 {

using namespace registers;

// RM0090 section 7.3.21. A power-on sets the brown-out flag too, and every reset pulls the reset pin and sets that of
// the pin; so the order decides. Flags of several resets add up while nobody clears them: then a power-on among them
// wins, because it is the one after which nothing goes on.
ResetCause take_reset_cause(Rcc& rcc) {
  const std::uint32_t flags = rcc.csr.read();
  rcc.csr.write(flags | rcc_csr_rmvf);
  if ((flags & rcc_csr_porrst) != 0) {
    return ResetCause::power_on;
  }
  if ((flags & rcc_csr_borrst) != 0) {
    return ResetCause::brown_out;
  }
  if ((flags & (rcc_csr_iwdgrst | rcc_csr_wwdgrst)) != 0) {
    return ResetCause::watchdog;
  }
  if ((flags & rcc_csr_sftrst) != 0) {
    return ResetCause::software;
  }
  if ((flags & rcc_csr_pinrst) != 0) {
    return ResetCause::pin;
  }
  return ResetCause::power_on;  // no flag at all, as in the emulator
}

}  // namespace fantail::hal::stm32f4
