// SPDX-License-Identifier: MIT
#include "flight_log/event_text.hpp"

#include <gtest/gtest.h>

#include "hal/board.hpp"

namespace fantail::flight_log {
namespace {

std::string of_board(std::uint32_t bits) {
  return event_text({.kind = protocol::LogEventKind::board_faults, .number = bits}, {});
}

// The recorder says the phase of its first tick, which may be minutes old.
TEST(EventText, APhaseThatTheFirstTickShowsBeganBeforeTheLog) {
  protocol::LogEvent event{.time = core::Microseconds{5000},
                           .kind = protocol::LogEventKind::phase,
                           .value = static_cast<std::uint8_t>(core::Phase::armed),
                           .detail = static_cast<std::uint8_t>(core::PhaseReason::armed_by_switch_and_command)};
  EXPECT_EQ(event_text(event, core::Microseconds{5000}),
            "Armed: already when the log begins (armed by switch and command)");
  EXPECT_EQ(event_text(event, core::Microseconds{4000}), "Armed: armed by switch and command");
}

TEST(EventText, NamesEveryFaultOfTheBoard) {
  constexpr std::uint32_t low = 1U << static_cast<unsigned>(hal::BoardFault::supply_low);
  EXPECT_EQ(of_board(low), "board: supply_low");
  EXPECT_EQ(of_board(1U << 3U | low), "board: imu_silent, supply_low");
  EXPECT_EQ(of_board(0), "board: no fault");
}

TEST(EventText, AFaultOfANewerBoardIsNotPassedOver) {
  EXPECT_EQ(of_board(0x8000'0000), "board: unknown 0x80000000");
  EXPECT_EQ(of_board(0x8000'0001), "board: crystal_failed, unknown 0x80000000");
}

}  // namespace
}  // namespace fantail::flight_log
