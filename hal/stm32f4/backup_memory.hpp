// SPDX-License-Identifier: MIT
#pragma once

#include "hal/backup_memory.hpp"
#include "hal/stm32f4/backup_clock.hpp"
#include "hal/stm32f4/registers/pwr.hpp"
#include "hal/stm32f4/registers/rcc.hpp"

namespace fantail::hal::stm32f4 {

/// The 4 KB of SRAM in the backup domain, which no reset of the processor touches: RM0090 section 5.1.2. And its clock.
class BackupMemory final : public hal::BackupMemory {
 public:
  /// `cells`: where the memory is. None of it where its domain stays closed, as in the emulator, in which whoever
  /// touches the upper three quarters crashes.
  BackupMemory(registers::Rcc& rcc, registers::Pwr& pwr, registers::Rtc& rtc, std::span<std::byte> cells)
      : clock_{opened(rcc, pwr), rtc} {
    rcc.ahb1enr.set(registers::rcc_ahb1enr_bkpsram);
    if (pwr.cr.any(registers::pwr_cr_dbp) && rcc.ahb1enr.any(registers::rcc_ahb1enr_bkpsram)) {
      cells_ = cells;
    }
  }

  [[nodiscard]] std::span<std::byte> bytes() override { return cells_; }
  [[nodiscard]] std::optional<Microseconds> running_time() override { return clock_.now(); }

  /// Once a tick.
  void update() { clock_.update(); }

 private:
  static registers::Rcc& opened(registers::Rcc& rcc, registers::Pwr& pwr) {
    rcc.apb1enr.set(registers::rcc_apb1enr_pwr);
    pwr.cr.set(registers::pwr_cr_dbp);
    // Errata sheet ES0182: it may take until this has been read back.
    static_cast<void>(pwr.cr.read());
    return rcc;
  }

  BackupClock clock_;
  std::span<std::byte> cells_;
};

}  // namespace fantail::hal::stm32f4
