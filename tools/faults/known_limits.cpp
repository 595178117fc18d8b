// SPDX-License-Identifier: MIT
#include <algorithm>

#include "faults/fault_table.hpp"
#include "faults/stop_rule.hpp"

// Cells that may be red, because nothing in this avionics makes them green. One that stands here and is green is
// reported, too. docs/devices.md has the same list with figures.
namespace fantail::faults {
namespace {

using sim::Behaviour;
using sim::Device;

constexpr unsigned at(auto... each) { return ((1U << static_cast<unsigned>(each)) | ...); }
constexpr unsigned launched = at(Phase::launched, Phase::controlling);
constexpr unsigned armed = at(Phase::armed) | launched;
constexpr unsigned before_launch = at(Phase::armed, Phase::launched);
constexpr bool one_gyro = true;
constexpr int after_self_test_ms = 250;  // of the pad
constexpr int for_garbage_ms = 500;      // random pulses may pass for a healthy canard's for longer

constexpr std::string_view believed =
    "a wrong gyro that reports no error cannot be detected with one gyro: there is no second one to compare it with";
constexpr std::string_view fit_a_second = "fly with two gyros: second_imu.fitted, and sensors.gyros = \"two_agree\"";
constexpr std::string_view wrong_force =
    "only the accelerometer of the IMU is integrated. If it is wrong and reports no error, launch, speed and height "
    "are wrong. Control begins late or ends before apogee, at trim";
constexpr std::string_view launch_is_late =
    "no launch is detected while the two accelerometers disagree. Roll angle, height and speed start when they agree, "
    "so control begins late and ends before apogee";
constexpr std::string_view look_at_bus =
    "do not launch with an accelerometer or IMU fault reported on the bus; after a flight, check the time of detection";
constexpr std::string_view too_far =
    "one canard far off makes more roll moment than the other three can balance within their limit";
constexpr std::string_view untested =
    "one canard far off makes more roll moment than the other three can balance. Just before arming, the self-test has "
    "already tested this canard";
constexpr std::string_view stop_near =
    "limit each canard with a stop in the linkage just beyond the plan limit. Keep 4 times the fin offset plus that "
    "stop below 3 times the plan limit";

constexpr std::string_view turned =
    "the failed canard rolls the rocket before the other three respond; they have enough moment and bring it back";
constexpr std::string_view nearer =
    "limit each canard with a stop in the linkage just beyond the plan limit: a failed one then rolls the rocket less";

// clang-format off: a limit a row
constexpr auto limits = std::to_array<KnownLimit>({
    {broken(Device::imu, Behaviour::stuck), launched, one_gyro, "the driver of the board detects counts that repeat as new ones (docs/devices.md in the sources); the simulator has no such driver", fit_a_second},
    {broken(Device::imu, Behaviour::garbage), launched, one_gyro, believed, fit_a_second},
    {spike(Device::imu), armed, one_gyro, believed, fit_a_second},
    {offset(Device::imu, 100.0), armed, one_gyro, believed, fit_a_second},
    {offset(Device::imu, 15.0), armed, false, "the roll angle follows a rate error below the permitted difference of two gyros (gyro_disagreement_deg_s)", "make gyro_disagreement_deg_s as small as both gyros allow, and run fantail bench axes before the flight"},
    {slow_samples(Device::imu), launched, one_gyro, "each gap of 10 ms counts as a silent sensor. The canards wait at trim nearly all the time, the roll is not held, and control does not end", fit_a_second},
    {broken(Device::imu, Behaviour::stuck), launched, false, wrong_force, look_at_bus},
    {spike(Device::imu), armed, false, wrong_force, look_at_bus},
    {silent_for(2.0, Device::imu), before_launch, false, launch_is_late, look_at_bus},
    {spike(Device::accelerometer), at(Phase::pad) | before_launch, false, launch_is_late, look_at_bus},
    {broken(Device::accelerometer, Behaviour::stuck), at(Phase::launched), false, launch_is_late, look_at_bus},
    {silent_for(2.0, Device::accelerometer), before_launch, false, launch_is_late, look_at_bus},
    {silent_for(0.045, Device::processor), at(Phase::launched), false, "a gap during launch detection restarts the detection. Roll angle, height and speed start a tenth of a second late, and control ends before apogee, at trim", "do not launch with a board that misses ticks: it reports them on the bus as overruns. After a flight, check the time of detection"},
    {hardover, armed, false, too_far, stop_near, 0, Excuse::three_lack},
    {hardover, armed, false, turned, nearer, 0, Excuse::comes_back},
    {hardover_back, armed, false, too_far, stop_near, 0, Excuse::three_lack},
    {hardover_back, armed, false, turned, nearer, 0, Excuse::comes_back},
    {hardover, at(Phase::pad), false, untested, stop_near, after_self_test_ms, Excuse::three_lack},
    {hardover_back, at(Phase::pad), false, untested, stop_near, after_self_test_ms, Excuse::three_lack},
    {broken(Device::servo, Behaviour::garbage), at(Phase::pad), false, untested, stop_near, for_garbage_ms, Excuse::three_lack},
    {broken(Device::servo, Behaviour::cut), at(Phase::pad), false, untested, stop_near, after_self_test_ms, Excuse::three_lack},
    {broken(Device::servo, Behaviour::garbage), armed, false, too_far, stop_near, 0, Excuse::three_lack},
    {broken(Device::servo, Behaviour::garbage), armed, false, turned, nearer, 0, Excuse::comes_back},
    {broken(Device::servo, Behaviour::cut), armed, false, too_far, stop_near, 0, Excuse::three_lack},
    {broken(Device::servo, Behaviour::cut), armed, false, turned, nearer, 0, Excuse::comes_back},
    {hardover, at(Phase::pad), false, turned, nearer, after_self_test_ms, Excuse::comes_back},
    {hardover_back, at(Phase::pad), false, turned, nearer, after_self_test_ms, Excuse::comes_back},
    {broken(Device::servo, Behaviour::garbage), at(Phase::pad), false, turned, nearer, for_garbage_ms, Excuse::comes_back},
    {broken(Device::servo, Behaviour::cut), at(Phase::pad), false, turned, nearer, after_self_test_ms, Excuse::comes_back},
});
// clang-format on

}  // namespace

std::span<const KnownLimit> known_limits() { return limits; }

const KnownLimit* known_limit(const FaultRow& row, Phase phase, const sim::Scenario& scenario) {
  const bool balances = StopRule{scenario, row.recipe.fault}.is_kept();
  const auto found = std::ranges::find_if(limits, [&](const KnownLimit& limit) {
    return limit.recipe == row.recipe && (limit.phases & at(phase)) != 0 &&
           (!limit.with_one_gyro || scenario.plan.sensors.gyros == core::GyroRule::one) &&
           (limit.excuse == Excuse::any || (limit.excuse == Excuse::comes_back) == balances);
  });
  return found == limits.end() ? nullptr : &*found;
}

}  // namespace fantail::faults
