// SPDX-License-Identifier: MIT
#include <vector>

#include <gtest/gtest.h>

#include "core/flight_plan_fields.hpp"
#include "core/pad_window.hpp"
#include "protocol/state_block.hpp"

namespace fantail::protocol {
namespace {

using core::PadWindow;

/// Stands still from begin_ms to before end_ms, and every millisecond's rate is another one: a mean says of which
/// samples it is. When it was renewed.
std::vector<int> stand(PadWindow& window, int begin_ms, int end_ms) {
  std::vector<int> renewed_ms;
  for (int t = begin_ms; t < end_ms; ++t) {
    const core::Vector3 rate{static_cast<float>(t) * 0x1p-20F, 0.0F, 0.0F};
    if (window.update(core::Microseconds{t * 1'000}, rate, {core::standard_gravity_m_s2, 0.0F, 0.0F})) {
      renewed_ms.push_back(t);
    }
  }
  return renewed_ms;
}

void expect_mean(const PadWindow& window, int begin_ms, int end_ms) {
  ASSERT_TRUE(window.average());
  EXPECT_NEAR(window.average()->gyro_bias_rad_s.x, 0.5 * (begin_ms + end_ms - 1) * 0x1p-20, 5e-8);
}

void give_state(PadWindow& from, PadWindow& to, StateExtent extent) {
  std::vector<std::byte> bytes(4'096);
  StateWriter writer{bytes, extent};
  from.visit_state(writer);
  bytes.resize(writer.size());
  StateReader reader{bytes, extent};
  to.visit_state(reader);
  ASSERT_TRUE(reader.ok());
}

TEST(StateBlock, APadWindowThatIsGivenAWholeStateForgetsWhatItHadSummedItself) {
  PadWindow stood{core::default_plan().motion};
  stand(stood, 0, 5'043);
  PadWindow other{core::default_plan().motion};
  stand(other, 10'000, 15'043);
  give_state(stood, other, StateExtent::whole);
  EXPECT_EQ(stand(other, 5'043, 5'101), std::vector{5'100});
  expect_mean(other, 1'600, 4'600);
}

TEST(StateBlock, APadWindowThatIsGivenAStateInFlightKeepsItsAverageUntilItHasSeenThreeSecondsAndTheGuardAnew) {
  PadWindow stood{core::default_plan().motion};
  stand(stood, 0, 5'000);
  PadWindow other{core::default_plan().motion};
  give_state(stood, other, StateExtent::in_flight);
  // The tenth of a second that was open then goes on, and is the first of the thirty.
  EXPECT_EQ(stand(other, 5'000, 8'400), std::vector<int>{});
  expect_mean(other, 1'400, 4'400);
  EXPECT_EQ(stand(other, 8'400, 8'401), std::vector{8'400});
  expect_mean(other, 4'900, 7'900);
}

// Of a step of 4 m/s2 the low-pass lets a tenth through in the first millisecond; without what it remembered it would
// let all of it through.
TEST(StateBlock, APadWindowThatIsGivenAStateTakesOneNoisySampleForNoMotion) {
  for (const StateExtent extent : {StateExtent::whole, StateExtent::in_flight}) {
    PadWindow stood{core::default_plan().motion};
    stand(stood, 0, 1'000);
    PadWindow other{core::default_plan().motion};
    give_state(stood, other, extent);
    other.update(core::Microseconds{1'000'000}, {}, {core::standard_gravity_m_s2 + 4.0F, 0.0F, 0.0F});
    EXPECT_EQ(other.at_rest_for(core::Microseconds{1'000'000}), core::Microseconds{1'000'000});
  }
}

}  // namespace
}  // namespace fantail::protocol
