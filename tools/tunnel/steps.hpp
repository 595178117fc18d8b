// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "identify/identification.hpp"
#include "identify/make_record.hpp"
#include "identify/model/roll_model.hpp"
#include "logs/roll_log.hpp"
#include "result/document.hpp"
#include "tunnel/statistics.hpp"
#include "tunnel/tunnel_log.hpp"

namespace fantail::tunnel {

/// A change of the roll reference under control.
struct ReferenceStep {
  double begin_s = 0.0;  ///< the first sample with the new reference
  double end_s = 0.0;    ///< the last one before the next change, or of control
  double from_rad = 0.0;
  double to_rad = 0.0;
};

/// In order of time. Control that begins with a reference other than the one before it begins with a step. Throws
/// text::Error (bad_data) when the log has no reference or it never changes.
[[nodiscard]] std::vector<ReferenceStep> find_reference_steps(const logs::RollLog& log);

enum class Direction : std::uint8_t { both, up, down };

struct StepOptions {
  double seconds = 5.0;       ///< of each step are looked at; a shorter step as long as it lasts
  std::size_t intervals = 1;  ///< between nodes of the disturbance
  Direction direction = Direction::both;
  identify::result::Method method = identify::result::Method::continuous;
  /// Of each step. One noisy sample taken as exact turns the whole step: an error of 1 deg/s is 5 degrees at its end.
  identify::model::Start start = identify::model::Start::fitted;
  identify::RecordOptions record{};
};

struct StepResult {
  std::size_t number = 0;  ///< of all changes of the reference, counted from 1
  ReferenceStep step{};
  identify::model::Record record{};
  identify::result::Identification identified{};
};

/// Results of one step.
struct StepFigures {
  double alpha_m2 = 0.0;
  double beta_m = 0.0;
  double disturbance_begin_rad = 0.0;
  double disturbance_end_rad = 0.0;
  double mean_abs_angle_error_rad = 0.0;
  double mean_abs_rate_error_rad_s = 0.0;
};
[[nodiscard]] StepFigures figures_of(const StepResult& result);
/// Their standard errors; zero for the two mean errors, which are not estimates.
[[nodiscard]] StepFigures standard_errors_of(const StepResult& result);

/// What every table of steps has: steps.csv, steps.json, the terminal and the page.
inline constexpr auto step_fields = result::fields<StepFigures>({
    {"alpha", "alpha", result::units::m2, 3, &StepFigures::alpha_m2, "damping"},
    {"beta", "beta", result::units::m, 3, &StepFigures::beta_m, "torque constant"},
    {"disturbance_begin", "the disturbance at the beginning", result::units::deg, 3,
     &StepFigures::disturbance_begin_rad, "as an equivalent fin offset, at the beginning of the step"},
    {"disturbance_end", "the disturbance at the end", result::units::deg, 3, &StepFigures::disturbance_end_rad,
     "likewise, at its end"},
    {"mean_abs_angle_error", "angle error", result::units::deg, 3, &StepFigures::mean_abs_angle_error_rad,
     "mean absolute difference of measured and modelled roll angle"},
    {"mean_abs_rate_error", "rate error", result::units::deg_s, 3, &StepFigures::mean_abs_rate_error_rad_s,
     "the same of the roll rates"},
});
/// The first of them are estimates, which have a standard error.
inline constexpr std::size_t step_estimates = 4;

/// How one figure differs from step to step.
struct StepSpread {
  std::size_t figure;  ///< of step_fields
  Between spread;
};

/// One run's own Table 2.
struct StepTable {
  std::vector<StepResult> steps{};
  StepFigures mean{};
  // Over the steps; nothing for a single one.
  std::optional<StepFigures> standard_deviation{};  ///< of a sample
  std::vector<StepSpread> spreads{};                ///< of the figures that have a standard error
  std::vector<std::string> remarks{};
};

/// Told of how many steps as many are done; it may throw to give up.
using StepProgress = std::function<void(std::size_t done, std::size_t of)>;

/// A step that cannot be identified, because it is too short for one, or that does not tell alpha and beta is left out,
/// and a remark says why. Throws text::Error (bad_data) when none is left.
[[nodiscard]] StepTable identify_steps(const logs::RollLog& log, const identify::model::Airframe& airframe,
                                       const StepOptions& options, const StepProgress& progress = {});

/// The mean of the sensor's readings while the steps lasted, because one reading is rounded to more than the air
/// varies. Throws text::Error (bad_data) when there is no reading then, or when the fan got another set point
/// meanwhile.
[[nodiscard]] double mean_wind_speed_m_s(const TunnelLog& wind, const std::vector<ReferenceStep>& steps);

struct SpeedChoice {
  std::optional<double> speed_m_s{};  ///< by hand
  std::string wind{};                 ///< the tunnel's log by name
  bool truth = false;
};
struct StepSpeed {
  std::optional<double> speed_m_s{};  ///< empty: each row of the log has its own
  std::string source{};
};
/// By hand, or the mean of the tunnel's log while the steps lasted, or the log's own. Throws text::Error (bad_data)
/// as mean_wind_speed_m_s() and find_tunnel_log().
[[nodiscard]] StepSpeed speed_of_steps(const logs::RollLog& roll, const std::filesystem::path& roll_path,
                                       const SpeedChoice& choice);

/// What a table of steps was made from.
struct StepsHeading {
  std::string log{};
  std::string vehicle{};          ///< its name; empty: inertia and area were given by hand
  std::string airframe_source{};  ///< "tasha3_tunnel (summary.json)"; empty: what `vehicle` says
  identify::model::Airframe airframe{};
  std::optional<double> speed_m_s{};  ///< empty: the log's own, which varies
  std::string speed_source{};         ///< "tunnel.csv", "--speed", "the log"
  double density_kg_m3 = 0.0;
  std::string density_source{};  ///< "standard atmosphere at 1400 m above the sea"
  StepOptions options{};
};

/// What `fantail tunnel steps` says: nothing was asked, so that there is no yes or no. steps.csv is what `fantail
/// predict` reads.
[[nodiscard]] result::Document steps_answer(const StepsHeading& heading, const StepTable& table,
                                            const result::Made& made);
/// Every figure in its JSON, for the manual.
[[nodiscard]] std::vector<result::Listed> listed_step_fields();

/// Of step_fields, with the decimals for this table: alpha and beta of a small reference area are small numbers.
[[nodiscard]] result::Column step_column(const StepTable& table, std::size_t figure);

/// A figure of one step that lies apart from those of the others.
struct Outlier {
  std::size_t step = 0;    ///< its number
  std::size_t figure = 0;  ///< of step_fields
  double value = 0.0;      ///< in SI and radians, as the figure
  double median = 0.0;     ///< of all steps
};

/// By steps. Apart is what is farther from the median than 3.5 times the spread, which is the median distance from it
/// over 0.6745 (modified z-score; Iglewicz and Hoaglin 1993): a few that are wrong do not widen it. None of fewer than
/// five steps, where outliers cannot be told apart, of a figure in which half of them agree to the last bit,
/// and of what is nearer than 2 % (an angle or a rate: 0.1 deg or deg/s), which do not matter in a tunnel.
[[nodiscard]] std::vector<Outlier> outliers(const StepTable& table);

/// All steps over each other in one chart, each from its own begin and in the sense of its step; the odd ones are
/// named. Nothing for a single one.
[[nodiscard]] std::vector<result::Block> overlay(const StepTable& table);
/// Damping, torque and disturbance over the steps, each with its 95 % interval, and their means. For a single one its
/// intervals, a sentence.
[[nodiscard]] std::vector<result::Block> over_steps(const StepTable& table);
/// Each step alone, measured and modelled.
[[nodiscard]] std::vector<result::Block> responses(const StepTable& table);

}  // namespace fantail::tunnel
