// SPDX-License-Identifier: MIT
#include "log_export/replayed_flight.hpp"

#include <algorithm>
#include <cmath>

namespace fantail::log_export {
namespace {

// The rows belong to the replayed ticks, in their order; without any the log's own first tick has to do.
core::Microseconds clock_zero(const flight_log::Flight& flight, const flight_log::Regeneration& regeneration,
                              const flight::Flight& report) {
  const auto first = std::ranges::find_if(regeneration.records, [](const auto& record) { return record.has_value(); });
  if (first != regeneration.records.end() && !report.rows.empty()) {
    return (*first)->time - core::Microseconds{std::llround(report.rows.front().time_s * 1e6)};
  }
  return flight.ticks.empty() ? core::Microseconds{} : flight.ticks.front().tick.time;
}

}  // namespace

ReplayedFlight::ReplayedFlight(const flight_log::Flight& flight, const flight_log::Regeneration& regeneration,
                               const flight::Flight& report, Window window)
    : flight_{flight}, regeneration_{regeneration}, zero_{clock_zero(flight, regeneration, report)}, window_{window} {}

const core::TickRecord* ReplayedFlight::record(std::size_t tick) const {
  const auto& records = regeneration_.records;
  return tick < records.size() && records[tick] ? &*records[tick] : nullptr;
}

bool ReplayedFlight::inside(double time_s) const {
  constexpr double tolerance_s = 0.5e-6;  // the clock counts microseconds
  return (!window_.from_s || time_s >= *window_.from_s - tolerance_s) &&
         (!window_.until_s || time_s <= *window_.until_s + tolerance_s);
}

}  // namespace fantail::log_export
