// SPDX-License-Identifier: MIT
#include <algorithm>

#include "faults/fault_table.hpp"

// Cells that may be red, because nothing in this avionics can make them green. One that stands here and is green is
// reported, too.
namespace fantail::faults {
namespace {

constexpr unsigned at(auto... each) { return ((1U << static_cast<unsigned>(each)) | ...); }
constexpr unsigned in_flight = at(Phase::armed, Phase::launched, Phase::controlling);
constexpr unsigned anywhere = at(Phase::pad) | in_flight;

constexpr auto limits = std::to_array<KnownLimit>({
    {"imu", "offset_15", anywhere, false,
     "a rate that is wrong by less than two gyros may differ is followed by the roll angle",
     "measure the gyro's rate at rest and turning before every flight (bench axes)"},
});

}  // namespace

std::span<const KnownLimit> known_limits() { return limits; }

const KnownLimit* known_limit(const FaultRow& row, Phase phase, const core::FlightPlan& plan) {
  const auto found = std::ranges::find_if(limits, [&](const KnownLimit& limit) {
    return limit.device == row.device && (limit.fault.empty() || limit.fault == row.fault) &&
           (limit.phases & at(phase)) != 0 && (!limit.with_one_gyro || plan.sensors.gyros == core::GyroRule::one);
  });
  return found == limits.end() ? nullptr : &*found;
}

}  // namespace fantail::faults
