// SPDX-License-Identifier: MIT
#include "flown_capture.hpp"
#include "seed.hpp"
#include "test.hpp"

namespace fantail::dormancy {
namespace {

class Draw {
 public:
  explicit Draw(std::uint32_t seed) : random_{seed} {}

  WaitingRocket rocket() {
    const double size = std::pow(10.0, between(0.0, 1.5));
    WaitingRocket rocket{.entry = {.plant = {.inertia_kg_m2 = 0.002 * size,
                                             .reference_area_m2 = 5e-5 * size * between(0.6, 1.7),
                                             .damping_m2 = between(8.0, 40.0),
                                             .torque_m = between(5.0, 15.0)},
                                   .speed_m_s = between(40.0, 250.0),
                                   .drag_per_mass_m2_kg = between(0.0007, 0.002),
                                   .rate_rad_s = text::radians(between(-1500.0, 1500.0)),
                                   .ahead_rad = between(-20.0, 20.0),
                                   .limit_rad = text::radians(between(5.0, 15.0)),
                                   .proportional_gain = between(0.2, 1.0),
                                   .servo_lag_s = between(0.01, 0.04),
                                   .delay_s = between(0.002, 0.012)},
                         .rejection = static_cast<core::OffsetRejection>(random_.whole(0, 2)),
                         .has_model = random_.chance(0.7),
                         .wait_s = between(0.0, 2.0)};
    RollAtEntry& e = rocket.entry;
    e.offset_rad = e.limit_rad * between(-1.1, 1.1);
    e.derivative_gain_s = e.proportional_gain * between(0.05, 0.2);
    if (rocket.rejection == core::OffsetRejection::integral) {
      e.integral_gain_per_s = e.proportional_gain * between(0.3, 2.0);
    } else if (rocket.rejection == core::OffsetRejection::observer) {
      e.observer_bandwidth_rad_s = between(3.0, 12.0);
      rocket.has_model = true;  // or it is no plan
    }
    return rocket;
  }

 private:
  double between(double low, double high) { return low + (high - low) * random_.unit(); }
  core::RandomStream random_;
};

testing::AssertionResult is_kept(const WaitingRocket& rocket, const FlownCapture& flown,
                                 std::optional<double> promised_s) {
  if (!promised_s || (flown.captured_after_s && *flown.captured_after_s <= *promised_s)) {
    return testing::AssertionSuccess();
  }
  const RollAtEntry& e = flown.entry;
  return testing::AssertionFailure() << "promised " << *promised_s << " s, flown "
                                     << flown.captured_after_s.value_or(-1) << " s: " << e.speed_m_s << " m/s, "
                                     << text::degrees(e.rate_rad_s) << " deg/s, u_d " << text::degrees(e.offset_rad)
                                     << " of " << text::degrees(e.limit_rad) << " deg, kp " << e.proportional_gain
                                     << ", kd " << e.derivative_gain_s << " s, a "
                                     << e.plant.damping_rate_per_s(e.density_kg_m3, e.speed_m_s) << "/s, b "
                                     << e.plant.authority_per_s2(e.density_kg_m3, e.speed_m_s) << "/s2, ki "
                                     << e.integral_gain_per_s << "/s, w " << e.observer_bandwidth_rad_s
                                     << " rad/s, model " << e.has_model << ", waited " << rocket.wait_s << " s, way "
                                     << path_m(e).value_or(-1) << " m";
}

// Rockets of all sizes, with and without a model, an integral and an observer, from any angle and up to 1500 deg/s. The
// soak test asks for more.
TEST(CaptureOracle, NoCaptureThatWasPromisedFails) {
  const int captures = test::how_many("FANTAIL_CAPTURES", 300);
  Draw draw{test::seed()};
  int promised = 0;
  int captured = 0;
  for (int i = 0; i < captures; ++i) {
    const WaitingRocket rocket = draw.rocket();
    const FlownCapture flown = fly_capture(rocket);
    const auto within_s = captured_within_s(flown.entry);
    const auto from_any_s = captured_from_any_angle_within_s(flown.entry);
    promised += within_s || from_any_s ? 1 : 0;
    captured += flown.captured_after_s ? 1 : 0;
    EXPECT_TRUE(is_kept(rocket, flown, within_s)) << "capture " << i;
    EXPECT_TRUE(is_kept(rocket, flown, from_any_s)) << "capture " << i << ", from any angle";
  }
  std::printf("%d captures, promised %d, captured %d\n", captures, promised, captured);
  EXPECT_GT(promised, captures / 10);
}

}  // namespace
}  // namespace fantail::dormancy
