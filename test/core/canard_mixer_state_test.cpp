// SPDX-License-Identifier: MIT
// A mixer whose memory is not what it left there: a flipped bit, or a state that came back after a reset.
#include <bit>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "core/canard_mixer.hpp"
#include "core/flight_plan_fields.hpp"

namespace fantail::core {
namespace {

using namespace literals;

constexpr Microseconds tick{1000};
const EncoderAngles at_zero{Angle{}, Angle{}, Angle{}, Angle{}};

// Puts every canard that is in its first motion somewhere else.
class MoveTo {
 public:
  explicit MoveTo(Angle place) : place_{place} {}
  template <typename... T>
  void operator()(T&... values) const {
    (each(values), ...);
  }

 private:
  template <typename T, std::size_t n>
  void each(std::array<T, n>& values) const {
    for (T& value : values) {
      value.visit_state(*this);
    }
  }
  void each(std::optional<Angle>& position) const { position = place_; }
  template <typename T>
  void each(T& /*other*/) const {}

  Angle place_;
};

class MovedTo : public testing::TestWithParam<float> {};

TEST_P(MovedTo, NoPositionInTheFirstMotionIsCommandedBeyondTheLimit) {
  CanardMixer mixer{default_plan().canards, 9_deg};
  CanardCommands commands;
  mixer.mix(Microseconds{0}, 9_deg, std::nullopt, at_zero, commands);
  mixer.mix(tick, 9_deg, std::nullopt, at_zero, commands);
  ASSERT_TRUE(commands[0].limited) << "it is not in its first motion";
  const MoveTo move{Angle::from_radians(GetParam())};
  mixer.visit_state(move);
  for (int i = 2; i < 2000; ++i) {
    mixer.mix(i * tick, Angle{}, std::nullopt, at_zero, commands);
    for (std::size_t c = 0; c < canard_count; ++c) {
      ASSERT_LE(std::abs(commands[c].angle.degrees()), 9.0F) << "canard " << c << " at " << i;
    }
  }
  EXPECT_EQ(commands[0].angle, 0_deg);
}

INSTANTIATE_TEST_SUITE_P(Radians, MovedTo,
                         testing::Values(0.2F, -0.2F, 1e30F, -std::numeric_limits<float>::max(),
                                         std::numeric_limits<float>::infinity(),
                                         std::numeric_limits<float>::quiet_NaN()));

}  // namespace
}  // namespace fantail::core
