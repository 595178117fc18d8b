// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "predict/prediction.hpp"
#include "stability/gain_choice.hpp"

namespace fantail::predict {

// What would have to change, tried on the runs before it is said.

struct LimitAdvice {
  std::string sentence{};
  std::optional<double> limit_deg{};  ///< empty: no limit is advised
};

struct GainAdvice {
  std::string sentence{};
  std::optional<stability::Gains> gains{};  ///< empty: no gains are advised
};

/// Of those that a plan may have and the canards can reach, the smallest canard limit in half degrees that meets the
/// demand of decide() on the share of runs whose offset can be balanced; or that none does, and why.
[[nodiscard]] LimitAdvice advice_on_canard_limit(const Prediction& prediction, double share);

/// Of the gains that a plan may have, the pair nearest to the plan's that gives the loop this phase margin in 95 % of
/// the runs at every speed flown; or that none does, and what servo lag would. Integral gain, observer and schedule
/// stay as the plan has them.
[[nodiscard]] GainAdvice advice_on_gains(const Prediction& prediction, double phase_margin_rad,
                                         stability::Search search = stability::Search::both_gains);

/// So many of the first runs are flown again to try an advice.
inline constexpr std::size_t most_flown_again = 20;

struct Trial {
  std::string sentence{};  ///< how many of the first runs hold their roll with the advice; empty where none is given
  bool helps = true;       ///< no fewer than without it
  Share held{};            ///< of the runs that were flown again
};

/// The launch with this advice, as far as it is given.
[[nodiscard]] sim::Scenario with_advice(const Prediction& prediction, const LimitAdvice& limit,
                                        const GainAdvice& gains);

/// Flies the first runs again with what is advised, and with a reference that is held, too, where that of the plan lets
/// none of them be judged. `look` is called after each flight.
[[nodiscard]] Trial trial(const Prediction& prediction, const LimitAdvice& limit, const GainAdvice& gains,
                          const Look& look = look_nowhere);

/// What the launch must meet for an advice to be worth it.
struct Asked {
  double held_share = 0.0;
  double phase_margin_rad = 0.0;
};

/// Against a fin offset that is too large for the law or the canards: integral action, on top of what is `advised`
/// (`more`: something is), and straighter fins with the plan as it is. A sentence for each that enough of the first
/// runs, flown again, hold with; or one that no advice is known.
[[nodiscard]] std::vector<std::string> advice_on_offset(const Prediction& prediction, const sim::Scenario& advised,
                                                        bool more, const Asked& asked, const Look& look = look_nowhere);

/// In six degrees of freedom, where the plan's tilt limit ends control early: in how much less wind the first of these
/// runs, flown again, do not come to that, or that they do even without, and whether they do from an upright guide.
/// Empty where no run comes to it. `look` is called after each flight.
[[nodiscard]] std::string advice_on_wind(const Prediction& prediction, const Look& look);

}  // namespace fantail::predict
