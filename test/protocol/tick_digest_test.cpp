// SPDX-License-Identifier: MIT
#include "protocol/tick_digest.hpp"

#include <bit>

#include "test.hpp"

namespace fantail::protocol {
namespace {

// Every signal by itself, so that none is left out of the list which the digest goes by.
TEST(TickDigest, ChangesWithEverySignal) {
  using core::TickRecord;
  const std::vector<void (*)(TickRecord&)> changes{
      [](TickRecord& r) { r.time = core::Microseconds{1}; },
      [](TickRecord& r) { r.time = core::Microseconds{std::int64_t{1} << 40U}; },
      [](TickRecord& r) { r.phase = core::Phase::armed; },
      [](TickRecord& r) { r.reason = core::PhaseReason::apogee; },
      [](TickRecord& r) { r.detection = core::DetectionState::holding; },
      [](TickRecord& r) { r.command_status = core::CommandStatus::gyro_lost; },
      [](TickRecord& r) { r.timing_fault = true; },
      [](TickRecord& r) { r.overruns = 1; },
      [](TickRecord& r) { r.overruns = 1U << 31U; },
      [](TickRecord& r) { r.motion.roll_angle = core::Angle::from_radians(1.0F); },
      [](TickRecord& r) { r.motion.roll_rate_rad_s = 1.0F; },
      [](TickRecord& r) { r.motion.specific_force_m_s2.x = 1.0F; },
      [](TickRecord& r) { r.motion.specific_force_m_s2.y = 1.0F; },
      [](TickRecord& r) { r.motion.specific_force_m_s2.z = 1.0F; },
      [](TickRecord& r) { r.motion.height_m = 1.0F; },
      [](TickRecord& r) { r.motion.distance_along_guide_m = 1.0F; },
      [](TickRecord& r) { r.motion.speed_m_s = 1.0F; },
      [](TickRecord& r) { r.motion.vertical_speed_m_s = 1.0F; },
      [](TickRecord& r) { r.motion.tilt = core::Angle::from_radians(1.0F); },
      [](TickRecord& r) { r.motion.tilt_from_guide = core::Angle{}; },
      [](TickRecord& r) { r.motion.tilt_from_guide = core::Angle::from_radians(1.0F); },
      [](TickRecord& r) { r.motion.gyro = core::SensorState::fresh; },
      [](TickRecord& r) { r.motion.accelerometer = core::SensorState::fresh; },
      [](TickRecord& r) { r.motion.rate_is_lower_bound = true; },
      [](TickRecord& r) { r.motion.roll_is_bridged = true; },
      [](TickRecord& r) { r.motion.speed_is_lower_bound = true; },
      [](TickRecord& r) { r.gyro_vote = core::GyroVote::both; },
      [](TickRecord& r) { r.gyro_vote = core::GyroVote::neither; },
      [](TickRecord& r) { r.motion.at_rest_for = core::Microseconds{1}; },
      [](TickRecord& r) { r.motion.thrust_since = core::Microseconds{1}; },
      [](TickRecord& r) { r.reference = core::Angle::from_radians(1.0F); },
      [](TickRecord& r) { r.excitation = core::Angle::from_radians(1.0F); },
      [](TickRecord& r) { r.offset_estimate = core::Angle::from_radians(1.0F); },
      [](TickRecord& r) { r.unclamped_command = core::Angle::from_radians(1.0F); },
      [](TickRecord& r) { r.command = core::Angle::from_radians(1.0F); },
      [](TickRecord& r) { r.saturated = true; },
      [](TickRecord& r) { r.canard_angle = core::Angle{}; },
      [](TickRecord& r) { r.canard_angle = core::Angle::from_radians(1.0F); },
  };
  std::set<std::uint32_t> digests{tick_digest(TickRecord{})};
  for (const auto change : changes) {
    TickRecord record;
    change(record);
    digests.insert(tick_digest(record));
  }
  std::size_t expected = changes.size() + 1;
  for (std::size_t i = 0; i < core::canard_count; ++i) {
    const auto with = [&](auto change) {
      TickRecord record;
      change(record);
      digests.insert(tick_digest(record));
      expected += 1;
    };
    with([i](TickRecord& r) { r.canards[i].angle = core::Angle::from_radians(1.0F); });
    with([i](TickRecord& r) { r.canards[i].pulse_us = 1.0F; });
    with([i](TickRecord& r) { r.canards[i].driven = true; });
    with([i](TickRecord& r) { r.canards[i].limited = true; });
    with([i](TickRecord& r) { r.encoders[i] = core::Angle{}; });
    with([i](TickRecord& r) { r.encoders[i] = core::Angle::from_radians(1.0F); });
    with([i](TickRecord& r) { r.verdicts[i] = core::CanardVerdict::dead; });
  }
  EXPECT_EQ(digests.size(), expected);
}

TEST(TickDigest, TellsTheTwoZerosApart) {
  core::TickRecord negative;
  negative.command = core::Angle::from_radians(-0.0F);
  EXPECT_NE(tick_digest(negative), tick_digest(core::TickRecord{}));
}

TEST(TickDigest, ChangesWithEveryBitOfASignal) {
  std::set<std::uint32_t> digests;
  core::TickRecord record;
  for (unsigned bit = 0; bit < 32; ++bit) {
    record.overruns = 1U << bit;
    digests.insert(tick_digest(record));
    record.overruns = 0;
    record.motion.height_m = std::bit_cast<float>(1U << bit);
    digests.insert(tick_digest(record));
    record.motion.height_m = 0.0F;
  }
  for (unsigned bit = 0; bit < 64; ++bit) {
    record.time = core::Microseconds{static_cast<std::int64_t>(std::uint64_t{1} << bit)};
    digests.insert(tick_digest(record));
  }
  EXPECT_EQ(digests.size(), 128U);
}

// The upper bit of a word is the one that a multiplication alone would not spread: two of them would cancel out.
TEST(TickDigest, TwoSignalsThatBothChangeTheirSignDoNotCancelOut) {
  core::TickRecord record;
  record.motion.specific_force_m_s2 = {.x = 9.8F, .y = 1.0F, .z = -2.0F};
  core::TickRecord turned = record;
  turned.motion.specific_force_m_s2.y = -1.0F;
  turned.motion.specific_force_m_s2.z = 2.0F;
  EXPECT_NE(tick_digest(turned), tick_digest(record));
}

// Reckoned apart from the program, in Python, from the list of signals: a word w makes s of (s ^ w) * 0x9E3779B1, and
// then s ^ s >> 15; the first s is 0x2545F491, and the digest s ^ s >> 16. Logs hold these numbers, and a law that has
// not changed must find them again. A signal that comes or goes changes them.
TEST(TickDigest, IsTheOneThatLogsHold) {
  EXPECT_EQ(tick_digest({}), 0x819CAC20U);
  core::TickRecord record;
  record.time = core::Microseconds{0x200000001};
  record.phase = core::Phase::controlling;
  record.command = core::Angle::from_radians(1.0F);
  record.gyro_vote = core::GyroVote::first;
  record.canards[0].driven = true;
  record.canard_angle = core::Angle::from_radians(-0.5F);
  EXPECT_EQ(tick_digest(record), 0xA571138FU);
}

}  // namespace
}  // namespace fantail::protocol
