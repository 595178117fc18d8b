// SPDX-License-Identifier: MIT
// The whole exercise on PCs that look at the bus too seldom: the right verdict or none, and no canard is ever accused
// for it.
#include <optional>
#include <string>

#include <fmt/core.h>
#include <gtest/gtest.h>

#include "sil/bench_at_world.hpp"

namespace fantail::sil {
namespace {

/// Empty when the session was lost.
std::optional<bench::Sheet> sheet_of(const std::string& rocket, int look_ms) {
  BenchAtWorld place{rocket};
  place.between_looks = look_ms * millisecond;
  try {
    return place.limits();
  } catch (const link::LinkError& error) {
    EXPECT_NE(std::string{error.what()}.find("this PC, suspended or too busy"), std::string::npos) << error.what();
    return std::nullopt;
  }
}

// The simulated queue holds 64 frames, some 28 ms: the counters of the frames come round after 16 ms, so 45 ms between
// two looks lose a whole round, which they cannot show.
TEST(SlowPc, GetsTheRightVerdictOrNoneHoweverSeldomItLooks) {
  for (const int look_ms : {1, 2, 5, 10, 15, 20, 25, 28, 30, 35, 40, 44, 45, 46, 50, 60, 80, 95, 120, 200}) {
    const auto healthy = sheet_of("bench_healthy", look_ms);
    const auto reversed = sheet_of("bench_canard3_reversed", look_ms);
    const auto text = [](const auto& sheet) { return sheet ? name(sheet->judgement()) : "session lost"; };
    fmt::print("{:3} ms between looks: healthy {}, canard 3 reversed {}\n", look_ms, text(healthy), text(reversed));
    if (healthy) {
      EXPECT_NE(healthy->judgement(), bench::Judgement::fail) << sheet_text(*healthy);
    }
    if (reversed && reversed->judgement() == bench::Judgement::fail) {
      for (const bench::CanardResult& result : reversed->canards) {
        EXPECT_EQ(result.diagnosis.cause, result.canard == 2 ? bench::Cause::reversed : bench::Cause::healthy);
      }
    } else if (reversed) {
      EXPECT_EQ(reversed->judgement(), bench::Judgement::none) << look_ms;
    }
    if (look_ms <= 20) {
      ASSERT_TRUE(healthy && reversed);
      EXPECT_TRUE(healthy->passed());
      EXPECT_EQ(reversed->judgement(), bench::Judgement::fail);
    }
  }
}

TEST(SlowPc, SaysNothingOfTheCanardsWhenFramesWereLostOnIt) {
  const auto sheet = sheet_of("bench_canard3_reversed", 50);
  ASSERT_TRUE(sheet);
  const std::string text = bench::sheet_text(*sheet);
  EXPECT_NE(text.find("NO VERDICT"), std::string::npos);
  EXPECT_NE(text.find("This PC was too slow: "), std::string::npos) << text;
  EXPECT_NE(text.find("Nothing is said of the canards."), std::string::npos);
  EXPECT_EQ(text.find("is reversed"), std::string::npos) << text;
}

}  // namespace
}  // namespace fantail::sil
