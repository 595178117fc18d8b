// SPDX-License-Identifier: MIT
// The law that remembers most has room where states are kept: else a log could not be replayed from its begin, or a
// flight not resumed, and nobody would be told.

#include "avionics/backup_map.hpp"
#include "avionics/record_queue.hpp"
#include "avionics/write_state.hpp"
#include "core/flight_plan_fields.hpp"
#include "protocol/log_notes.hpp"
#include "test.hpp"

namespace fantail::avionics {
namespace {

core::FlightPlan fullest_plan() {
  core::FlightPlan plan = core::default_plan();
  plan.sensors.gyros = core::GyroRule::two_agree;
  plan.sensors.barometer = core::BarometerUse::fused;
  plan.dormancy.until = core::DormantUntil::height;
  plan.controller.entry = core::ControlEntry::capture;
  plan.offset.rejection = core::OffsetRejection::integral;
  return plan;
}

TEST(FullestLaw, ItsWholeStateFitsIntoACheckpoint) {
  core::Autopilot law{fullest_plan()};
  const std::size_t size = protocol::log_checkpoint_times_size + write_state(law, {}, protocol::StateExtent::whole);
  EXPECT_LE(size, WaitingCheckpoint{}.payload.size());
}

// Beside its head (FlightMemory).
TEST(FullestLaw, ItsStateInFlightFitsIntoHalfOfTheBackupMemory) {
  core::Autopilot law{fullest_plan()};
  const std::size_t size = write_state(law, {}, protocol::StateExtent::in_flight);
  std::printf("in flight %zu bytes\n", size);
  EXPECT_LE(size + 64, flight_half_size);
}

}  // namespace
}  // namespace fantail::avionics
