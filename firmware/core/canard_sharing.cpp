// SPDX-License-Identifier: MIT
#include "core/canard_sharing.hpp"

#include <algorithm>

namespace fantail::core {
namespace {

// Of the way to a new reading, a tick: 50 ms, so that a noisy encoder does not shake the other three canards.
constexpr float smoothing = 0.02F;

}  // namespace

// Meets SEN-3.
void CanardSharing::update(const CanardVerdicts& verdicts, const CanardContributions& contributions) {
  std::array<bool, canard_count> judged{};
  for (std::size_t i = 0; i < canard_count; ++i) {
    // Of a silent one nothing new is known.
    judged[i] = verdicts[i] != CanardVerdict::healthy && (contributions[i] || shared_for_[i] > 0);
  }
  const bool shares = std::ranges::count(judged, true) <= static_cast<std::ptrdiff_t>(most_judged);
  std::uint32_t ticks = 0;
  judged_ = Angle{};
  for (std::size_t i = 0; i < canard_count; ++i) {
    std::uint8_t& shared_for = shared_for_[i];
    if (contributions[i]) {
      angles_[i] = shared_for == 0 ? *contributions[i] : angles_[i] + smoothing * (*contributions[i] - angles_[i]);
    }
    if (judged[i] && shares) {
      shared_for = std::min<std::uint8_t>(shared_for + 1, handover_ticks);
    } else if (shared_for > 0) {
      shared_for -= 1;
    }
    ticks += shared_for;
    judged_ += (static_cast<float>(shared_for) / handover_ticks) * angles_[i];
  }
  constexpr auto all = static_cast<float>(canard_count);
  following_ = all - static_cast<float>(ticks) / handover_ticks;
  reach_ = {.lowest = (judged_ - following_ * plan_limit_) / all,
            .highest = (judged_ + following_ * plan_limit_) / all};
}

}  // namespace fantail::core
