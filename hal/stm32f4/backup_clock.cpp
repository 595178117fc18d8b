// SPDX-License-Identifier: MIT
#include "hal/stm32f4/backup_clock.hpp"

namespace fantail::hal::stm32f4 {
namespace {

using namespace registers;

// Every cycle of the crystal is one of the second's parts. (The manual recommends a large first divider to save power.)
constexpr std::uint32_t parts_of_a_second = 32'768;
constexpr std::uint32_t prescalers =
    (parts_of_a_second - 1) << rtc_prer_synchronous_shift | 0U << rtc_prer_asynchronous_shift;
constexpr std::uint32_t clocked = rcc_bdcr_lserdy | rcc_bdcr_rtcsel_lse | rcc_bdcr_rtcen;

std::int64_t two_digits(std::uint32_t time, std::uint32_t shift) {
  const std::uint32_t digits = time >> shift & rtc_tr_two_digits;
  return static_cast<std::int64_t>(digits >> 4U) * 10 + static_cast<std::int64_t>(digits & 0xFU);
}

}  // namespace

// What a reset left running is known by its prescalers, which no reset of the processor changes.
BackupClock::BackupClock(Rcc& rcc, Rtc& device) : rcc_{&rcc}, device_{&device} {
  runs_ = (rcc.bdcr.read() & (clocked | rcc_bdcr_rtcsel)) == clocked && device.prer.read() == prescalers &&
          device.cr.any(rtc_cr_bypshad);
  if (!runs_) {
    rcc.bdcr.set(rcc_bdcr_lseon);
  }
}

// RM0090 section 26.3.5.
void BackupClock::update() {
  if (runs_) {
    return;
  }
  const std::uint32_t domain = rcc_->bdcr.read();
  if ((domain & rcc_bdcr_lserdy) == 0) {
    return;
  }
  if ((domain & rcc_bdcr_rtcsel) == 0) {
    rcc_->bdcr.set(rcc_bdcr_rtcsel_lse | rcc_bdcr_rtcen);
    return;
  }
  if ((domain & (clocked | rcc_bdcr_rtcsel)) != clocked) {
    return;  // other firmware has given it another source, which only a power cut takes away
  }
  device_->wpr.write(rtc_wpr_first);
  device_->wpr.write(rtc_wpr_second);
  if (!device_->isr.any(rtc_isr_initf)) {
    device_->isr.write(rtc_isr_init);  // and two cycles of its crystal later it will have stopped
    return;
  }
  device_->prer.write(prescalers & 0x7FFFU);  // in two writes, as the manual wants it
  device_->prer.write(prescalers);
  device_->tr.write(0);
  device_->cr.write(rtc_cr_bypshad);
  device_->isr.write(0);
  runs_ = true;
}

std::optional<Microseconds> BackupClock::now() const {
  // A carry between two of the looks shows in the parts of the second, which change 32 768 times as often.
  constexpr int most_attempts = 4;
  for (int attempt = 0; runs_ && attempt < most_attempts; ++attempt) {
    const std::uint32_t left = device_->ssr.read();
    const std::uint32_t time = device_->tr.read();
    if (device_->ssr.read() != left || left >= parts_of_a_second) {
      continue;
    }
    const std::int64_t seconds =
        (two_digits(time, rtc_tr_hours_shift) * 60 + two_digits(time, rtc_tr_minutes_shift)) * 60 +
        two_digits(time, rtc_tr_seconds_shift);
    const std::int64_t parts = parts_of_a_second - 1 - left;  // it counts down
    return Microseconds{seconds * 1'000'000 + parts * 1'000'000 / parts_of_a_second};
  }
  return std::nullopt;
}

}  // namespace fantail::hal::stm32f4
