// SPDX-License-Identifier: MIT
#include "core/pad_window.hpp"

#include "core/flight_plan_fields.hpp"
#include "milliseconds.hpp"
#include "test.hpp"

namespace fantail::core {
namespace {

constexpr float g = standard_gravity_m_s2;
constexpr Vector3 upright_at_rest{g, 0.0F, 0.0F};

class Pad {
 public:
  /// 1 kHz up to `end`, exclusive.
  void stand(Microseconds end, const Vector3& rate, const Vector3& force = upright_at_rest) {
    for (; now < end; now += ms(1)) {
      window.update(now, rate, force);
    }
  }
  Microseconds now{0};
  PadWindow window{default_plan().motion};
};

TEST(PadWindow, KnowsNothingBeforeItHasSeenThreeSecondsAndTheGuard) {
  Pad pad;
  pad.stand(ms(3'500), {0.01F, 0.0F, 0.0F});
  EXPECT_FALSE(pad.window.average());
  pad.stand(ms(3'501), {0.01F, 0.0F, 0.0F});
  ASSERT_TRUE(pad.window.average());
  EXPECT_NEAR(pad.window.average()->gyro_bias_rad_s.x, 0.01F, 1e-7F);
}

TEST(PadWindow, AveragesAllThreeAxesOfBothSensors) {
  Pad pad;
  const Vector3 tilted{0.9659258F * g, 0.2588190F * g, 0.0F};
  pad.stand(ms(4'000), {0.01F, -0.015F, 0.017F}, tilted);
  const PadAverage& average = *pad.window.average();
  EXPECT_NEAR(average.gyro_bias_rad_s.x, 0.01F, 1e-7F);
  EXPECT_NEAR(average.gyro_bias_rad_s.y, -0.015F, 1e-7F);
  EXPECT_NEAR(average.gyro_bias_rad_s.z, 0.017F, 1e-7F);
  EXPECT_NEAR(average.specific_force_m_s2.x, tilted.x, 1e-4F);
  EXPECT_NEAR(average.specific_force_m_s2.y, tilted.y, 1e-4F);
  EXPECT_NEAR(average.specific_force_m_s2.z, 0.0F, 1e-4F);
}

TEST(PadWindow, IsTheMeanOverThreeSecondsThatEndHalfASecondAgo) {
  Pad pad;
  // A bias that changes once: what the average says tells where the window begins and ends.
  pad.stand(ms(10'000), {0.0F, 0.0F, 0.0F});
  pad.stand(ms(10'500), {0.01F, 0.0F, 0.0F});
  EXPECT_EQ(pad.window.average()->gyro_bias_rad_s.x, 0.0F);
  pad.stand(ms(12'001), {0.01F, 0.0F, 0.0F});
  EXPECT_NEAR(pad.window.average()->gyro_bias_rad_s.x, 0.005F, 2e-5F);  // the change lies in the middle
  pad.stand(ms(13'401), {0.01F, 0.0F, 0.0F});
  EXPECT_LT(pad.window.average()->gyro_bias_rad_s.x, 0.00999F);
  pad.stand(ms(13'601), {0.01F, 0.0F, 0.0F});
  EXPECT_NEAR(pad.window.average()->gyro_bias_rad_s.x, 0.01F, 1e-7F);
}

TEST(PadWindow, MotionVoidsTheWindowAndTheLastGoodOneStays) {
  const Vector3 turning{0.0F, 0.2F, 0.0F};
  const Vector3 lifted{1.5F * g, 0.0F, 0.0F};
  for (const bool by_rate : {true, false}) {
    for (const int length_ms : {20, 200}) {
      Pad pad;
      pad.stand(ms(5'000), {0.01F, 0.0F, 0.0F});
      pad.stand(ms(5'000 + length_ms), by_rate ? turning : Vector3{0.01F, 0.0F, 0.0F},
                by_rate ? upright_at_rest : lifted);
      pad.stand(ms(8'600), {0.015F, 0.0F, 0.0F});
      EXPECT_NEAR(pad.window.average()->gyro_bias_rad_s.x, 0.01F, 1e-7F) << by_rate << " " << length_ms;
      pad.stand(ms(9'000), {0.015F, 0.0F, 0.0F});
      EXPECT_NEAR(pad.window.average()->gyro_bias_rad_s.x, 0.015F, 1e-7F) << by_rate << " " << length_ms;
    }
  }
}

TEST(PadWindow, OneNoisySampleOfForceIsNotMotion) {
  Pad pad;
  for (; pad.now < ms(5'000); pad.now += ms(1)) {
    const float noise = pad.now.count() / 1'000 % 2 == 0 ? 1.5F : -1.5F;
    pad.window.update(pad.now, {}, {g + noise, 0.0F, 0.0F});
  }
  EXPECT_TRUE(pad.window.average());
  EXPECT_GT(pad.window.at_rest_for(pad.now), ms(4'900));
}

TEST(PadWindow, RestIsCountedFromTheLastMotion) {
  Pad pad;
  pad.stand(ms(1'000), {});
  EXPECT_EQ(pad.window.at_rest_for(ms(1'000)), ms(1'000));
  pad.stand(ms(1'001), {1.0F, 0.0F, 0.0F});
  EXPECT_EQ(pad.window.at_rest_for(ms(1'001)), ms(0));
  pad.stand(ms(1'500), {});
  EXPECT_EQ(pad.window.at_rest_for(ms(1'500)), ms(499));
}

TEST(PadWindow, RocketOnItsSideIsAtRestToo) {
  Pad pad;
  pad.stand(ms(5'000), {}, {0.0F, 0.0F, -g});
  EXPECT_TRUE(pad.window.average());
}

TEST(PadWindow, GapThatNobodyWatchedIsNotRest) {
  Pad pad;
  pad.stand(ms(5'000), {0.01F, 0.0F, 0.0F});
  pad.now = ms(8'000);  // perhaps somebody carried it
  pad.stand(ms(8'001), {0.015F, 0.0F, 0.0F});
  EXPECT_EQ(pad.window.at_rest_for(ms(8'001)), ms(1));
  pad.stand(ms(11'400), {0.015F, 0.0F, 0.0F});
  EXPECT_NEAR(pad.window.average()->gyro_bias_rad_s.x, 0.01F, 1e-7F);
  pad.stand(ms(12'000), {0.015F, 0.0F, 0.0F});
  EXPECT_NEAR(pad.window.average()->gyro_bias_rad_s.x, 0.015F, 1e-7F);
}

TEST(PadWindow, ClockThatJumpsBackStartsOverAndThenWorks) {
  Pad pad;
  pad.now = ms(100'000);
  pad.stand(ms(105'000), {0.01F, 0.0F, 0.0F});
  pad.now = ms(1'000);
  pad.stand(ms(5'000), {0.015F, 0.0F, 0.0F});
  EXPECT_EQ(pad.window.at_rest_for(ms(5'000)), ms(4'000));
  EXPECT_NEAR(pad.window.average()->gyro_bias_rad_s.x, 0.015F, 1e-7F);
}

TEST(PadWindow, AverageIsTheSameAfterTenHours) {
  Pad early;
  Pad late;
  late.now = Microseconds{36'000'000'000};
  early.stand(early.now + ms(4'000), {0.0123F, -0.004F, 0.015F}, {g, 0.3F, -0.2F});
  late.stand(late.now + ms(4'000), {0.0123F, -0.004F, 0.015F}, {g, 0.3F, -0.2F});
  EXPECT_EQ(early.window.average()->gyro_bias_rad_s.x, late.window.average()->gyro_bias_rad_s.x);
  EXPECT_EQ(early.window.average()->specific_force_m_s2.y, late.window.average()->specific_force_m_s2.y);
}

}  // namespace
}  // namespace fantail::core
