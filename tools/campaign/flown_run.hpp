// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "campaign/draw.hpp"
#include "dormancy/opening.hpp"
#include "flight/flight.hpp"
#include "fly/fly_scenario.hpp"
#include "report/figures.hpp"
#include "report/verdict.hpp"
#include "sim/scenario.hpp"

namespace fantail::campaign {

/// What a flight report says of a flight, of which no row was kept.
struct JudgedFlight {
  flight::Flight flight;    ///< without rows
  report::Figures figures;  ///< except Figures::side_deflection
  report::Verdict verdict;
  std::optional<dormancy::Opening> opening;  ///< canards leave trim; empty: they never do
};

/// Flies a scenario and judges it on the way. `take` gets each row, too.
[[nodiscard]] JudgedFlight fly_and_judge(const sim::Scenario& scenario, const fly::TakeRow& take = {});

/// Flies one run of a campaign alone and writes its flight report, as `fantail fly` does, into a folder. `changes`: of
/// the whole campaign; `note`: which run it is, a sentence. Throws text::OutputError.
void write_flight(const sim::Scenario& scenario, std::vector<std::string> changes, std::string note,
                  const std::filesystem::path& folder);

/// What a run is measured by: columns of runs.csv, empty where the flight has no such figure. Those of the gate and of
/// capture are of plans that wait for more than the guide.
inline constexpr std::array<std::string_view, 17> figure_columns{"largest_hold_error_deg",
                                                                 "saturated_share",
                                                                 "authority_margin_deg",
                                                                 "control_time_s",
                                                                 "control_start_height_m",
                                                                 "top_speed_m_s",
                                                                 "apogee_m",
                                                                 "rest_error_deg",
                                                                 "uncontrolled_time_before_apogee_s",
                                                                 "gate_time_s",
                                                                 "gate_height_m",
                                                                 "gate_rate_deg_s",
                                                                 "gate_angle_deg",
                                                                 "capture_time_s",
                                                                 "top_mach",
                                                                 "static_margin_calibres",
                                                                 "angle_of_attack_deg"};
/// The place of report::Figures::ended_before_apogee_s.
inline constexpr std::size_t uncontrolled_time_column = figure_columns.size() - 9;
/// The place of the first of the five of dormancy::Opening, which stand before the last three.
inline constexpr std::size_t gate_time_column = figure_columns.size() - 8;
/// The place of the first of the last three, which are flight::Extremes.
inline constexpr std::size_t top_mach_column = figure_columns.size() - 3;

/// The note of a run whose control began in the launch guide begins with it.
inline constexpr std::string_view begun_on_guide_note = "control began ";

/// One flight of a campaign, as it stands in a row.
struct FlownRun {
  std::uint64_t run = 0;
  std::uint64_t seed = 0;
  std::vector<double> numbers{};  ///< Draw::numbers
  std::size_t drawn_again = 0;
  /// A flight report's outcome ("held"); "refused" when the files do not allow what was drawn together, "not_finite"
  /// when a figure is no number.
  std::string outcome{};
  std::array<std::optional<double>, figure_columns.size()> figures{};
  std::vector<std::string> failed_by{};  ///< the criteria that it does not meet (campaign/criteria.hpp)
  std::string note{};  ///< of a run without a flight's outcome: why; of others, that control began in the launch guide

  friend bool operator==(const FlownRun&, const FlownRun&) = default;
};

[[nodiscard]] flight::Extremes extremes_of(const FlownRun& run);

/// Flies one run of a campaign. `files` are those of its scenario; they are left with what this run drew, and every run
/// of a campaign replaces the same values. What the files refuse makes no exception but a run that says so. Throws
/// text::Error for a draw that a field does not allow (Drawer::draw).
[[nodiscard]] FlownRun fly_run(input::ScenarioFiles& files, const Drawer& drawer, std::uint64_t master_seed,
                               std::uint64_t run);

using LookAtFlight =
    std::function<void(const sim::Scenario& scenario, const FlownRun& run, const JudgedFlight& judged)>;
/// The same of what has been drawn, without a number. `look` is called at the end, where there was a flight.
[[nodiscard]] FlownRun fly_drawn(input::ScenarioFiles& files, Draw draw, std::uint64_t seed,
                                 const LookAtFlight& look = {});

/// The columns of what is drawn. A number that is not a value itself has the word of its effect behind its field:
/// body.mass_kg_factor.
[[nodiscard]] std::vector<std::string> quantity_names(const std::vector<Spread>& spreads);

/// The columns of runs.csv for these spreads, with a newline.
[[nodiscard]] std::string header_row(const std::vector<Spread>& spreads);

/// A row, with a newline. Every digit is kept, so that the same run is the same text.
[[nodiscard]] std::string csv_row(const FlownRun& run);

/// The place of the first row that is not as csv_row() has written it, counted from 0; empty when all are.
[[nodiscard]] std::optional<std::uint64_t> edited_row(std::string_view rows);

/// The other way, of rows without a header. Throws text::Error (bad_data) with name and line for a row that csv_row()
/// does not make with so many numbers. Checks are not looked at.
[[nodiscard]] std::vector<FlownRun> read_rows(const std::string& rows, const std::vector<Spread>& spreads,
                                              const std::string& name);

}  // namespace fantail::campaign
