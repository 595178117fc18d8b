// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "identify/identification.hpp"
#include "identify/make_record.hpp"
#include "logs/roll_log.hpp"
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
  identify::RecordOptions record{};
};

struct StepResult {
  std::size_t number = 0;  ///< of all changes of the reference, counted from 1
  ReferenceStep step{};
  identify::model::Record record{};
  identify::result::Identification identified{};
};

/// Mean over the steps and standard deviation (divided by one less than their number; zero for a single one).
struct Spread {
  double mean = 0.0;
  double deviation = 0.0;
};

/// One run's own Table 2.
struct StepTable {
  std::vector<StepResult> steps{};
  Spread alpha_m2{};
  Spread beta_m{};
  Spread disturbance_begin_rad{};
  Spread disturbance_end_rad{};
  Spread mean_abs_angle_error_rad{};
  Spread mean_abs_rate_error_rad_s{};
  std::vector<std::string> remarks{};
};

/// Throws what identify() and make_record() throw, with the number of the step.
[[nodiscard]] StepTable identify_steps(const logs::RollLog& log, const identify::model::Airframe& airframe,
                                       const StepOptions& options);

/// The mean of the sensor's readings while the steps lasted, because one reading is rounded to more than the air
/// varies. Throws text::Error (bad_data) when there is no reading then, or when the fan got another set point
/// meanwhile.
[[nodiscard]] double mean_wind_speed_m_s(const TunnelLog& wind, const std::vector<ReferenceStep>& steps);

/// steps.csv: step, begin_s, alpha_m2, beta_m, disturbance_begin_deg, disturbance_end_deg, mean_abs_angle_error_deg,
/// mean_abs_rate_error_deg_s; one row a step.
[[nodiscard]] std::string steps_csv(const StepTable& table);

}  // namespace fantail::tunnel
