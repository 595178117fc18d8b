// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "predict/prediction.hpp"
#include "stability/margins_asked.hpp"

namespace fantail::predict {

/// What is required of a launch.
struct Thresholds {
  double authority_share = 0.95;  ///< of the runs whose canards can balance the offset
  double held_share = 0.90;       ///< of the runs that hold their roll
  /// Of 95 % of the runs, at the worst speed flown.
  double phase_margin_rad = stability::least_phase_margin_rad;
};

enum class Judgement : std::uint8_t { met, not_met, not_judged };

struct Criterion {
  std::string key{};       ///< for files: "authority"
  std::string label{};     ///< for readers: "Authority margin above zero"
  std::string found{};     ///< "100 % of the runs (98 to 100 %)"
  std::string required{};  ///< "at least 95 % of the runs"
  Judgement judgement = Judgement::not_judged;
  std::string
      clause{};  ///< says what was found and, when it is not met, what is wrong, in a sentence or more; behind a
                 ///< colon, so without a capital letter or a last full stop; empty where another says the same
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

/// Go when every criterion is met: what could not be judged is a no go. Shares must reach their threshold with the low
/// end of their interval: too few runs to tell are a no go. `look` is called after each flight that advice is
/// tried with, and may throw to give up.
[[nodiscard]] Decision decide(const Prediction& prediction, const Thresholds& thresholds,
                              const Look& look = look_nowhere);

/// Of a launch that is in some run beyond a flight::ModelEnd; empty otherwise. Never met: what is outside the model
/// cannot be judged, whatever the runs look like.
[[nodiscard]] std::optional<Criterion> within_model(const Prediction& prediction);

/// Of a plan that waits for more than the guide: in enough of the runs it comes. Empty for another.
[[nodiscard]] std::optional<Criterion> gate(const Prediction& prediction, double threshold);

/// No run is beyond another end than that of the angle of attack, which comes with the wind that a run draws: such runs
/// count as not held, and where enough others are, the launch is a go with a caution.
[[nodiscard]] bool is_outside_by_wind_alone(const Prediction& prediction);

/// Runs that would be held if the simulation held there.
[[nodiscard]] std::size_t steady_outside_model(const Prediction& prediction);

/// A clause on a static margin that is little or unknown; empty: neither.
[[nodiscard]] std::string stability_caution(const Prediction& prediction);

// A simulated rocket keeps to the line of its guide, a real one bends over and comes to the plan's tilt limit, which
// ends control. A point mass tells when.

/// Whether control would last as long as in the runs, or to within a second of the point mass's apogee. Empty for
/// a guide that hardly leans, and without a run under control.
[[nodiscard]] std::optional<Criterion> tilt_limit(const Prediction& prediction);

/// Control begins beyond the launch guide. Empty where it does in every run.
[[nodiscard]] std::optional<Criterion> beyond_guide(const Prediction& prediction);

/// A clause on a tilt under control that is less than five degrees below the plan's tilt limit, or, where the avionics
/// measured less than the truth, above it; empty: there is none.
/// In six degrees of freedom the largest of the runs, without those that come to the limit; with a leaning guide and
/// motion along a straight line that of the point mass.
[[nodiscard]] std::string tilt_caution(const Prediction& prediction);

/// The most that the guide may lean for it, in half degrees, as a sentence; empty where that would be hardly at all.
[[nodiscard]] std::string advice_on_tilt(const Prediction& prediction);

}  // namespace fantail::predict
