// SPDX-License-Identifier: MIT
#include "report/hold.hpp"

#include <algorithm>
#include <cmath>

#include "flight/gate.hpp"

namespace fantail::report {

// A clamped step of 45 deg takes longer than a second to arrive at the tunnel's 22 m/s (peak at 1.7 s).
double step_settling_time_s(const flight::Flight& flight) { return flight.tunnel ? 2.0 : 1.0; }

double first_settling_time_s(const flight::Flight& flight) {
  return flight::captures(flight) ? std::max(longest_capture_s, step_settling_time_s(flight))
                                  : step_settling_time_s(flight);
}

void RunningHold::add(const flight::Row& row, double roll_rad, const flight::Flight& flight) {
  if (!has_begun_) {
    has_begun_ = true;
    record_.control_from_s = row.time_s;
  }
  if (begins_) {
    begins_ = false;
    reference_rad_ = row.reference_rad;
    settles_at_s_ = row.time_s + first_settling_time_s(flight);
    last_known_s_ = row.time_s;
  }
  record_.control_to_s = row.time_s;
  const std::optional<double> settle_point_rad = flight::settle_point_rad(row, flight);
  if (!settle_point_rad || !std::isfinite(roll_rad)) {
    note_what_is_missing(row, roll_rad, flight);
    return;
  }
  // In a hole the reference may have changed, and back.
  const double since_s = row.time_s - last_known_s_;
  if (row.reference_rad != reference_rad_ || since_s > RunningExtent::longest_step_s) {
    reference_rad_ = row.reference_rad;
    settles_at_s_ = row.time_s + step_settling_time_s(flight);
  }
  known_.add(row.time_s);
  last_known_s_ = row.time_s;
  record_.is_ever_known = true;
  if (row.time_s < settles_at_s_ - row_time_rounding_s) {
    last_settled_s_.reset();
    return;
  }
  judged_time_s_ += row.time_s - last_settled_s_.value_or(row.time_s);
  last_settled_s_ = row.time_s;
  const double error_rad = std::abs(roll_rad - *settle_point_rad);
  largest_error_rad_ = std::max(largest_error_rad_.value_or(0.0), error_rad);
  sum_of_errors_rad_ += error_rad;
  settled_ += 1;
}

void RunningHold::note_what_is_missing(const flight::Row& row, double roll_rad, const flight::Flight& flight) {
  record_.lacks_roll = record_.lacks_roll || !std::isfinite(roll_rad);
  record_.lacks_reference = record_.lacks_reference || !std::isfinite(row.reference_rad);
  record_.lacks_fin_offset = record_.lacks_fin_offset || !row.truth || !std::isfinite(row.truth->disturbance_rad);
  record_.lacks_speed = record_.lacks_speed || !flight::gains_are_known(row, flight);
}

std::optional<double> RunningHold::mean_error_rad() const {
  return settled_ > 0 ? std::optional{sum_of_errors_rad_ / static_cast<double>(settled_)} : std::nullopt;
}

double RunningHold::judged_time_s() const {
  return std::round(1e4 * judged_time_s_) / 1e4;  // whatever the clock of the rows, which rounds to the microsecond
}

HoldRecord RunningHold::record(const flight::Clock& clock, double usual_step_s) const {
  HoldRecord result = record_;
  if (result.is_ever_known) {
    result.known = known_.extent(clock, usual_step_s);
  }
  result.control_from_s = clock(record_.control_from_s);
  result.control_to_s = clock(record_.control_to_s);
  return result;
}

}  // namespace fantail::report
