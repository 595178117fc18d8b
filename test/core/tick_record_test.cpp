// SPDX-License-Identifier: MIT
#include "core/tick_record.hpp"

#include <set>

#include <gtest/gtest.h>

namespace fantail::core {
namespace {

// Walks an enumeration from its first value until its names end; every name must be new.
template <typename Enumeration>
std::size_t distinct_names() {
  std::set<std::string_view> names;
  for (std::uint8_t value = 0; name(static_cast<Enumeration>(value)) != "unknown"; ++value) {
    EXPECT_TRUE(names.insert(name(static_cast<Enumeration>(value))).second);
  }
  return names.size();
}

TEST(TickRecord, EveryValueOfAnEnumerationHasANameOfItsOwn) {
  EXPECT_EQ(distinct_names<Phase>(), static_cast<std::size_t>(Phase::finished) + 1);
  EXPECT_EQ(distinct_names<PhaseReason>(), phase_reasons);
  EXPECT_EQ(distinct_names<CanardVerdict>(), static_cast<std::size_t>(CanardVerdict::disagreeing) + 1);
  EXPECT_EQ(distinct_names<SensorState>(), sensor_states);
  EXPECT_EQ(distinct_names<GyroVote>(), gyro_votes);
  EXPECT_EQ(distinct_names<CommandStatus>(), command_statuses);
  EXPECT_EQ(distinct_names<DetectionState>(), static_cast<std::size_t>(DetectionState::disagreement) + 1);
}

TEST(TickRecord, BeginsSafeWithoutACommandOrADrivenCanard) {
  const TickRecord record;
  EXPECT_EQ(record.phase, Phase::safe);
  EXPECT_EQ(record.command.radians(), 0.0F);
  for (const CanardCommand& canard : record.canards) {
    EXPECT_FALSE(canard.driven);
  }
}

}  // namespace
}  // namespace fantail::core
