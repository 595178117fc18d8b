// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "identify/model/roll_model.hpp"
#include "logs/roll_log.hpp"
#include "sim/atmosphere.hpp"
#include "sim/roll_inertia_course.hpp"

namespace fantail::identify {

/// A stretch of a log by its clock, both ends included.
struct Window {
  std::optional<double> from_s{};  ///< empty: from the first sample
  std::optional<double> to_s{};
  std::string name{};
};

/// Which air a log was flown in.
struct Air {
  sim::Atmosphere atmosphere{};
  std::string description{};
};

/// `asked` is a density in kg/m3, "exponential" or "isa". Empty: exponential when the log climbs, else 1.2 kg/m3. With
/// the elevation of a site it is the standard atmosphere, from there on over the height of a log that climbs. Throws
/// text::Error (bad_configuration) for anything else, and for an elevation beside another atmosphere.
[[nodiscard]] Air choose_air(const logs::RollLog& log, const std::optional<std::string>& asked,
                             const std::optional<double>& site_elevation_m = {});

struct RecordOptions {
  /// How much later the canard column is than the gyro's: its value at t + lag belongs to t. Of either sign. Samples
  /// whose canard angle would lie outside the log or inside a gap are left out.
  double lag_s = 0.0;
  bool lag_is_fitted = false;             ///< fill in canard_rate_rad_s, too
  std::optional<double> density_kg_m3{};  ///< the same everywhere; empty: from the height by `atmosphere`
  sim::Atmosphere atmosphere{};
  sim::RollInertiaCourse roll_inertia{};  ///< on the log's clock; empty: the airframe's throughout
  double site_elevation_m = 0.0;          ///< heights of the log count from here
  std::optional<double> speed_m_s{};      ///< for a log without speeds, or instead of them
  bool grows_with_mach = false;           ///< alpha and beta do, by Prandtl and Glauert's rule
  bool canard_needed = true;              ///< false: a log without canard angles gives a record without them
  double longest_gap_s = 0.1;             ///< samples farther apart have a gap between them (but see below)
};

/// A gap is longer than `longest_gap_s` and than five times the usual distance of the samples. One or two samples alone
/// between gaps are left out. Throws text::Error: bad_configuration for a window that ends before it begins;
/// bad_data for a window outside the data, fewer than three samples in it, no speed, no height to take the density
/// from, a cell without a number in a column that is needed here.
[[nodiscard]] model::Record make_record(const logs::RollLog& log, const Window& window, const RecordOptions& options);

}  // namespace fantail::identify
