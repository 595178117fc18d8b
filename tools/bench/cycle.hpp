// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "bench/exercise.hpp"
#include "bench/sheet.hpp"
#include "link/avionics_link.hpp"
#include "link/session.hpp"
#include "result/answer.hpp"
#include "sim/canard_tolerances.hpp"
#include "text/layout.hpp"

namespace fantail::bench {

/// What one canard showed in one lap, which is one turn of the `limits` exercise with all four together.
struct CanardLap {
  std::optional<double> lag_s{};
  std::optional<double> tracking_rms_rad{};
  std::optional<double> tracking_error_rad{};  ///< the largest, as on the sheet
  bool passed = false;                         ///< every figure of the sheet
};

struct Lap {
  double begin_s = 0.0;  ///< by the rocket's clock, since the first lap began
  std::string doubt{};   ///< why this lap is not judged; empty: it was measured
  Each<CanardLap> canards{};
  std::optional<double> battery_v{};  ///< lowest reported during it
  bool passed = false;
  std::vector<std::string> conclusions{};  ///< a sentence for each failure

  [[nodiscard]] bool measured() const { return doubt.empty(); }
};

/// An endurance run: the same lap again and again.
struct Cycle {
  Heading heading{};
  sim::CanardTolerances tolerances{};
  double lap_s = 0.0;
  std::size_t planned_laps = 0;
  std::vector<Lap> laps{};
  std::string ended_because{};  ///< empty: it ran to its end
};

/// Number of laps that fail in a row before the run ends itself, to spare the servos.
inline constexpr std::size_t most_failing_laps = 3;
/// Share of all planned laps that may be left out because too much of them was not received.
inline constexpr double most_void_share = 0.05;

/// Adds lap by lap to `cycle` until all planned laps are done, so that finished laps are kept whatever ends it.
/// `progress` is called with the seconds done, during and after each lap; it may throw to give up. Throws Unmeasured
/// when too many laps had to be left out.
void perform_laps(Cycle& cycle, const Exercise& lap, link::Session& session, link::AvionicsLink& link,
                  const std::function<void(double)>& progress);

/// The sheet of one lap, as an entry of a cycle.
[[nodiscard]] Lap lap_of(const Sheet& sheet);

/// Pass or fail of the measured laps; none if there are none.
[[nodiscard]] Judgement judgement(const Cycle& cycle);
/// One or more sentences: number of laps, first failure, laps left out, reason for the end.
[[nodiscard]] std::vector<std::string> conclusions(const Cycle& cycle);

/// One figure over the run. Empty values: not measured in any lap of that time.
struct Course {
  std::optional<double> first{};  ///< lap
  std::optional<double> last{};
  std::optional<double> worst{};
  std::vector<std::optional<double>> tenths{};  ///< of the laps; fewer than ten when there are fewer laps
};

/// In rad, s and V.
[[nodiscard]] Course lag_course(const Cycle& cycle, std::size_t canard);             ///< a tenth: the mean
[[nodiscard]] Course tracking_rms_course(const Cycle& cycle, std::size_t canard);    ///< root mean square
[[nodiscard]] Course tracking_error_course(const Cycle& cycle, std::size_t canard);  ///< the largest
[[nodiscard]] Course battery_course(const Cycle& cycle);                             ///< the lowest
/// The battery voltage was on the bus.
[[nodiscard]] bool knows_battery(const Cycle& cycle);

/// For a terminal: plain ASCII, aligned, at most 100 columns except for sentences.
[[nodiscard]] std::string cycle_text(const Cycle& cycle, std::size_t columns = text::any_width);
/// One object; every figure with its unit in its name.
[[nodiscard]] std::string cycle_json(const Cycle& cycle, const result::Made& made = {});
/// One row a lap. Empty cells: not measured.
[[nodiscard]] std::string cycle_csv(const Cycle& cycle);

}  // namespace fantail::bench
