// SPDX-License-Identifier: MIT

#include "core/chirp.hpp"
#include "core/compensated_sum.hpp"
#include "core/flight_plan_fields.hpp"
#include "core/low_pass.hpp"
#include "core/motion_estimator.hpp"
#include "core/offset_estimator.hpp"
#include "core/pad_window.hpp"
#include "known_roll_model.hpp"
#include "protocol/state_block.hpp"
#include "test.hpp"

namespace fantail::protocol {
namespace {

/// Is a state still read when its byte `from_end` (1: the last one) has this value?
template <typename Part>
bool accepts(Part part, std::size_t from_end, unsigned value) {
  std::vector<std::byte> bytes(4'096);
  StateWriter writer{bytes};
  part.visit_state(writer);
  bytes.resize(writer.size());
  bytes[bytes.size() - from_end] = static_cast<std::byte>(value);
  StateReader reader{bytes};
  part.visit_state(reader);
  return reader.ok();
}

TEST(StateBlock, OfAPadWindowAPlaceInTheRingAndAsManyClosedBlocksAsItHasAreTheMost) {
  const core::PadWindow window{core::default_plan().motion};
  // Thirty blocks and the guard of five.
  EXPECT_TRUE(accepts(window, 1, 34));
  EXPECT_FALSE(accepts(window, 1, 35));
  EXPECT_TRUE(accepts(window, 2, 35));
  EXPECT_FALSE(accepts(window, 2, 36));
}

TEST(StateBlock, OfAMotionEstimatorEveryPlaceEveryStateOfASensorAndEveryDoubtIsReadAndNoOther) {
  core::FlightPlan plan = core::default_plan();
  const core::MotionEstimator one{plan.motion, plan.sensors};
  for (const std::size_t sensor : {1U, 2U}) {  // accelerometer, gyro
    EXPECT_TRUE(accepts(one, sensor, 3)) << "failed";
    EXPECT_FALSE(accepts(one, sensor, 4));
  }
  EXPECT_TRUE(accepts(one, 3, 2)) << "in free flight";
  EXPECT_FALSE(accepts(one, 3, 3));
  plan.sensors.gyros = core::GyroRule::two_agree;
  const core::MotionEstimator two{plan.motion, plan.sensors};
  EXPECT_TRUE(accepts(two, 1, 3)) << "both doubted";
  EXPECT_FALSE(accepts(two, 1, 4));
}

/// `to` goes on from what `from` remembers.
template <typename Part>
void hand_over(Part& from, Part& to) {
  std::vector<std::byte> bytes(4'096);
  StateWriter writer{bytes};
  from.visit_state(writer);
  bytes.resize(writer.size());
  StateReader reader{bytes};
  to.visit_state(reader);
  ASSERT_TRUE(reader.ok());
}

// Beyond what the canards reach, so that integral action remembers that too.
void turn(core::OffsetEstimator& estimator, float rate_rad_s) {
  core::Motion motion;
  motion.gyro = core::SensorState::fresh;
  motion.roll_rate_rad_s = rate_rad_s;
  motion.speed_m_s = 60.0F;
  const auto degree = core::Angle::from_degrees(1.0F);
  estimator.update(motion, degree, 1.0F, {-3.0F * degree, 3.0F * degree});
  estimator.remember({.before_excitation = 5.0F * degree, .command = 3.0F * degree});
}

TEST(StateBlock, AnOffsetEstimatorThatIsGivenAStateGoesOnBitForBit) {
  for (const auto rejection : {core::OffsetRejection::integral, core::OffsetRejection::observer}) {
    core::FlightPlan plan = core::default_plan();
    plan.offset.rejection = rejection;
    plan.roll_model = core::known_roll_model;
    core::OffsetEstimator estimator{plan};
    turn(estimator, 0.125F);
    turn(estimator, 0.25F);
    core::OffsetEstimator other{plan};
    hand_over(estimator, other);
    EXPECT_NE(other.estimate(), core::Angle{});
    EXPECT_EQ(other.estimate(), estimator.estimate());
    turn(estimator, 0.375F);
    turn(other, 0.375F);
    EXPECT_EQ(other.estimate(), estimator.estimate());
  }
}

// By another seed it would vary by other numbers: until they are over, the present tenth of a second's are remembered.
TEST(StateBlock, AChirpThatIsGivenAStateGoesOnWithWhatWasDrawn) {
  core::ExcitationPlan plan = core::default_plan().excitation;
  plan.form = core::ExcitationForm::sweep;
  plan.amplitude_variation = core::Angle::from_degrees(2.0F);
  plan.frequency_variation_hz = 1.0F;
  core::Chirp chirp{plan};
  ASSERT_NE(chirp.update(plan.begin + core::Microseconds{250'000}), core::Angle{});
  plan.variation_seed += 1;
  core::Chirp other{plan};
  hand_over(chirp, other);
  for (const int since_begin_us : {251'000, 299'999}) {
    const core::Microseconds time = plan.begin + core::Microseconds{since_begin_us};
    const core::Angle expected = chirp.update(time);
    EXPECT_EQ(other.update(time), expected);
    EXPECT_NE(core::Chirp{plan}.update(time), expected);
  }
}

TEST(StateBlock, ASumThatIsGivenAStateCarriesOnWhatItsFloatCouldNotHold) {
  core::CompensatedSum sum;
  sum.add(0x1p24F);
  sum.add(1.0F);  // the next float is two more
  core::CompensatedSum other;
  hand_over(sum, other);
  EXPECT_EQ(other.value(), 0x1p24F);
  other.add(1.0F);
  EXPECT_EQ(other.value(), 0x1p24F + 2.0F);
}

TEST(StateBlock, ALowPassThatIsGivenAStateGoesOnFromItsOutputAndItsTime) {
  core::LowPass low_pass{16.0F};
  low_pass.update(core::Microseconds{1'000}, 3.0F);
  core::LowPass other{16.0F};
  hand_over(low_pass, other);
  EXPECT_EQ(other.output(), 3.0F);
  EXPECT_EQ(other.update(core::Microseconds{2'000}, 5.0F), low_pass.update(core::Microseconds{2'000}, 5.0F));
}

TEST(StateBlock, AMotionEstimatorThatIsGivenAStateKnowsHowTheGuideIsTilted) {
  const core::FlightPlan plan = core::default_plan();
  core::MotionEstimator estimator{plan.motion};
  core::Inputs inputs;
  inputs.gyro.quality = core::SampleQuality::valid;
  inputs.accelerometers.fill(
      {.specific_force_m_s2 = {.x = 0.8F * core::standard_gravity_m_s2, .y = 0.6F * core::standard_gravity_m_s2},
       .quality = core::SampleQuality::valid});
  for (int i = 0; i < 4'000; ++i) {
    inputs.time += core::Microseconds{1'000};
    inputs.gyro.time = inputs.accelerometers[0].time = inputs.accelerometers[1].time = inputs.time;
    estimator.update(inputs);
  }
  core::MotionEstimator other{plan.motion};
  hand_over(estimator, other);
  EXPECT_NEAR(other.motion(inputs.time).tilt.radians(), 0.6435011F, 1e-5F) << "atan(0.6 / 0.8)";
}

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
