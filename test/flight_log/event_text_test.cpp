// SPDX-License-Identifier: MIT
#include "flight_log/event_text.hpp"

#include <gtest/gtest.h>

#include "hal/board.hpp"

namespace fantail::flight_log {
namespace {

std::string of_board(std::uint32_t bits) {
  return event_text({.kind = protocol::LogEventKind::board_faults, .number = bits});
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
