// SPDX-License-Identifier: MIT
#include "hal/stm32f4/watchdog.hpp"

namespace fantail::hal::stm32f4 {
namespace {

using namespace registers;

constexpr std::uint32_t nominal_hz = 32'000;
constexpr std::uint32_t divider = 4;
constexpr std::uint32_t period_ms = 50;

// The values cross into the other clock within five of its cycles, 0.3 ms at its slowest; a look takes 50 ns or more.
constexpr std::uint32_t looks_for_update = 20'000;

}  // namespace

// RM0090 section 21.3. Started first: from then on its oscillator runs, without which the values would not be taken.
bool Watchdog::start(std::optional<std::uint32_t> oscillator_hz) {
  device_->kr.write(iwdg_kr_start);
  device_->kr.write(iwdg_kr_unlock);
  device_->pr.write(iwdg_pr_divide_by_4);
  device_->rlr.write(oscillator_hz.value_or(nominal_hz) * period_ms / (1000 * divider) - 1);
  const bool taken = wait_for(device_->sr, iwdg_sr_pvu | iwdg_sr_rvu, 0, looks_for_update);
  feed();
  return taken;
}

}  // namespace fantail::hal::stm32f4
