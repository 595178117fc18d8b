// SPDX-License-Identifier: MIT
#include "core/tick_record.hpp"

#include "test.hpp"

namespace fantail::core {
namespace {

// Of the values from the first on; the one after the last is unknown.
template <typename Enumeration>
std::vector<std::string_view> names_of() {
  std::vector<std::string_view> names;
  for (std::uint8_t value = 0; name(static_cast<Enumeration>(value)) != "unknown" && value < 100; ++value) {
    names.push_back(name(static_cast<Enumeration>(value)));
  }
  return names;
}

using Names = std::vector<std::string_view>;

// As they stand in the tables and logs of every flight so far: another name would break whatever reads them.
TEST(TickRecord, EveryValueOfAnEnumerationKeepsItsName) {
  EXPECT_EQ(names_of<Phase>(), (Names{"safe", "armed", "launched", "controlling", "finished", "dormant"}));
  EXPECT_EQ(names_of<PhaseReason>(), (Names{"power_on",
                                            "armed_by_switch_and_command",
                                            "disarmed_by_switch",
                                            "launch_detected",
                                            "guide_clear",
                                            "tunnel_start_command",
                                            "guide_not_cleared_in_time",
                                            "gyro_failed_before_control",
                                            "timing_fault_before_control",
                                            "control_time_over",
                                            "apogee",
                                            "tilted_too_far",
                                            "gyro_failed",
                                            "timing_fault",
                                            "canard_fault",
                                            "memory_fault",
                                            "moved_without_launch",
                                            "rested",
                                            "flew_without_launch",
                                            "gate_open",
                                            "gate_closed_again",
                                            "gate_never_opened",
                                            "aborted"}));
  EXPECT_EQ(names_of<CanardVerdict>(), (Names{"healthy", "dead", "stalled", "slipping", "disagreeing"}));
  EXPECT_EQ(names_of<SensorState>(), (Names{"fresh", "coasting", "lost", "failed"}));
  EXPECT_EQ(names_of<GyroVote>(), (Names{"both", "first", "second", "disagree", "neither"}));
  EXPECT_EQ(names_of<CommandStatus>(), (Names{"outside_control", "controlling", "gyro_lost", "not_finite"}));
  EXPECT_EQ(names_of<DetectionState>(), (Names{"quiet", "holding", "detected", "bad_sample", "disagreement"}));
}

TEST(TickRecord, EveryValueOfAnEnumerationHasAName) {
  EXPECT_EQ(names_of<Phase>().size(), phases);
  EXPECT_EQ(names_of<PhaseReason>().size(), phase_reasons);
  EXPECT_EQ(names_of<CanardVerdict>().size(), canard_verdicts);
  EXPECT_EQ(names_of<SensorState>().size(), sensor_states);
  EXPECT_EQ(names_of<GyroVote>().size(), gyro_votes);
  EXPECT_EQ(names_of<CommandStatus>().size(), command_statuses);
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
