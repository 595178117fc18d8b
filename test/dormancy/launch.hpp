// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>

#include "core/autopilot.hpp"
#include "core/launch_detector.hpp"
#include "dormancy/ascent.hpp"
#include "dormancy/senses.hpp"

namespace fantail::dormancy {

inline constexpr std::array gates{core::DormantUntil::burn_out, core::DormantUntil::max_dynamic_pressure,
                                  core::DormantUntil::height};

/// A rocket with a plan of its own on its pad: rested, armed, and with all its devices well.
class Pad {
 public:
  explicit Pad(core::RandomStream& random);

  Planned planned;
  Errors errors;
  core::FlightPlan plan;
  core::Autopilot law;
  core::LaunchDetector detector;  ///< sees what that of the law does
  core::Microseconds now{1'000'000};
};

/// What one gate did beyond the guide.
struct Opening {
  double due_s = 0.0;              ///< by the truth: last thrust above 2 % of the peak, largest q, height reached
  std::optional<double> opened_s;  ///< the first time
  bool is_early = false;           ///< before it was due; for the dynamic pressure, which then rose by another 2 %
};

/// Times count from ignition.
struct Flown {
  bool left_guide = false;  ///< as the law saw it
  std::array<Opening, gates.size()> openings{};
  int off_trim = 0;         ///< ticks with a canard off trim while the plan's gate was closed
  int control_without = 0;  ///< ticks under control while the plan's gate was closed
  /// Of a second burn: how long the gate for burn-out stood open in it, and whether it opened again too early.
  std::optional<double> closed_after_s;
  bool reopened_early = false;
};

/// One launch from there. The pad stays as it is.
[[nodiscard]] Flown fly(const Pad& pad, const Burn& burn, const Fault& fault, core::RandomStream& random);

}  // namespace fantail::dormancy
