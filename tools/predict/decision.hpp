// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "predict/prediction.hpp"
#include "text/degrees.hpp"

namespace fantail::predict {

/// What is required of a launch.
struct Thresholds {
  double authority_share = 0.95;                  ///< of the runs whose canards can balance the offset
  double held_share = 0.90;                       ///< of the runs that hold their roll
  double phase_margin_rad = text::radians(30.0);  ///< of 95 % of the runs, at the worst speed flown
};

enum class Judgement : std::uint8_t { met, not_met, not_judged };

struct Criterion {
  std::string key{};       ///< for files: "authority"
  std::string label{};     ///< for readers: "Authority margin above zero"
  std::string found{};     ///< "100 % of the runs (98 to 100 %)"
  std::string required{};  ///< "at least 95 % of the runs"
  Judgement judgement = Judgement::not_judged;
  std::string clause{};  ///< says what was found and, when it is not met, what is wrong; no full stop; empty where
                         ///< another criterion says the same
};

struct Decision {
  bool go = false;
  std::vector<Criterion> criteria{};
  std::string text{};                   ///< heading(), and why
  std::vector<std::string> cautions{};  ///< of a go: what no requirement asks and the launch is near to, a clause each
  std::vector<std::string> advice{};    ///< what would have to change, a sentence each; empty for go
  Thresholds thresholds{};

  [[nodiscard]] std::string_view heading() const { return !go ? "No go" : cautions.empty() ? "Go" : "Go with caution"; }
};

/// Go when every criterion is met: what could not be judged is no go. Shares must reach their threshold with the low
/// end of their interval: runs that are too few to tell are no go. `look` is called after each flight that advice is
/// tried with, and may throw to give up.
[[nodiscard]] Decision decide(const Prediction& prediction, const Thresholds& thresholds,
                              const Look& look = look_nowhere);

}  // namespace fantail::predict
