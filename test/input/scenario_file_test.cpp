// SPDX-License-Identifier: MIT
#include "input/scenario_file.hpp"

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "scratch_file.hpp"
#include "test.hpp"
#include "text/error.hpp"

namespace fantail::input {
namespace {

const std::string head = "vehicle = \"tasha3_launch2\"\nplan = \"tasha3_launch2\"\n";

struct Rule {
  const char* name;
  std::string text;  ///< after the two lines of `head`
  std::string said;  ///< what follows the file name
};

class ScenarioFile : public testing::TestWithParam<Rule> {};

TEST_P(ScenarioFile, IsRefusedWithItsLine) {
  std::string pattern = (std::filesystem::temp_directory_path() / "fantail-XXXXXX").string();
  const std::filesystem::path folder = mkdtemp(pattern.data());
  const std::filesystem::path file = folder / "s.toml";
  std::ofstream{file} << head << GetParam().text;
  try {
    (void)load_scenario(file.string(), {});
    ADD_FAILURE() << "accepted";
  } catch (const text::Error& error) {
    EXPECT_EQ(error.kind(), text::ErrorKind::bad_configuration);
    EXPECT_EQ(std::string{error.what()}, file.string() + GetParam().said);
  }
  std::filesystem::remove_all(folder);
}

INSTANTIATE_TEST_SUITE_P(
    Rules, ScenarioFile,
    testing::Values(
        Rule{"SeedBelowZero", "seed = -1\n", ":3: seed = -1 is out of range; allowed: 0 to 9e+15"},
        Rule{"SeedAFraction", "seed = 1.5\n", ":3: seed = 1.5 is not a whole number"},
        Rule{"Surroundings", "[environment]\nsurroundings = \"space\"\n",
             ":4: environment.surroundings = 'space'; allowed: flight, tunnel, gimbal"},
        Rule{"TunnelForALaunchPlan", "[environment]\nsurroundings = \"tunnel\"\n",
             ":4: environment.surroundings must be \"flight\": the plan starts with run.start = \"launch\""},
        Rule{"Density", "[environment]\ndensity = 1.2\n",
             ":4: environment.density = 1.2; allowed: exponential, isa, constant"},
        Rule{"DensityValue", "[environment]\ndensity_kg_m3 = 0\n",
             ":4: environment.density_kg_m3 = 0 is out of range; allowed: 0.01 to 5"},
        Rule{"Tilt", "[launch_guide]\ntilt_deg = 15.1\n",
             ":4: launch_guide.tilt_deg = 15.1 is out of range; allowed: 0 to 15"},
        Rule{"EnvironmentNotASection", "environment = 1\n", ":3: [environment] must be a section"},
        Rule{"FanSpeed", "[tunnel]\nfan_rpm = 3001\n", ":4: tunnel.fan_rpm = 3001 is out of range; allowed: 0 to 3000"},
        Rule{"Turbulence", "[tunnel]\nturbulence = true\n",
             ":4: tunnel.turbulence = true is not a number; allowed: 0 to 0.5"},
        Rule{"DisturbanceLengths", "[disturbance]\ntimes_s = [0, 1]\nangles_deg = [1]\n",
             ":4: disturbance.times_s has 2 values and angles_deg has 1; allowed: the same number of each"},
        Rule{"DisturbanceOrder", "[disturbance]\ntimes_s = [0, 0]\nangles_deg = [1, 1]\n",
             ":4: disturbance.times_s must increase"},
        Rule{"DisturbanceAngle", "[disturbance]\ntimes_s = [0]\nangles_deg = [46]\n",
             ":5: disturbance.angles_deg = 46 is out of range; allowed: -45 to 45"},
        Rule{"DisturbanceNotAList", "[disturbance]\ntimes_s = 0\nangles_deg = 1\n",
             ":4: disturbance.times_s must be a list, as in [1, 2]"},
        Rule{"ImposedRollIncomplete", "[imposed_roll]\ntime_s = 1\n",
             ":3: imposed_roll.angle_deg is missing; allowed: -3600 to 3600"},
        Rule{"ImposedRollUnknownKey", "[imposed_roll]\ntime_s = 1\nangle_deg = 1\nrate_deg_s = 1\nrate = 1\n",
             ":7: unknown key imposed_roll.rate; did you mean imposed_roll.rate_deg_s?"},
        Rule{"ArmAfterIgnition", "[timing]\npad_time_s = 2\narm_time_s = 2\n",
             ":5: timing.arm_time_s = 2 must be earlier than pad_time_s = 2"},
        Rule{"PadTimeBeforeArm", "[timing]\n\npad_time_s = 1\n",
             ":5: timing.pad_time_s = 1 must be later than arm_time_s = 1"},
        Rule{"TimeAfterEnd", "[timing]\ntime_after_end_s = -1\n",
             ":4: timing.time_after_end_s = -1 is out of range; allowed: 0 to 3600"},
        Rule{"LogPeriodBetweenTicks", "[timing]\nlog_period_s = 0.0015\n",
             ":4: timing.log_period_s = 0.0015 is not a whole number of milliseconds"},
        Rule{"LogPeriodTooLong", "[timing]\nlog_period_s = 2\n",
             ":4: timing.log_period_s = 2 is out of range; allowed: 0.001 to 1"},
        Rule{"FanTimesWithoutSpeeds", "[tunnel]\nfan_times_s = [0, 1]\nfan_rpms = [500]\n",
             ":4: tunnel.fan_times_s has 2 values and fan_rpms has 1; allowed: the same number of each"},
        Rule{"FanTimesOrder", "[tunnel]\nfan_times_s = [1, 0]\nfan_rpms = [500, 600]\n",
             ":4: tunnel.fan_times_s must increase"},
        Rule{"FanBackwards", "[tunnel]\nfan_times_s = [1]\nfan_rpms = [-1]\n",
             ":5: tunnel.fan_rpms = -1 is out of range; allowed: 0 to 3000"},
        Rule{"WindSensorTooFast", "[tunnel]\nwind_sensor_period_s = 0\n",
             ":4: tunnel.wind_sensor_period_s = 0 is out of range; allowed: 0.001 to 600"},
        Rule{"WindSensorTooCoarse", "[tunnel]\nwind_sensor_resolution_m_s = 6\n",
             ":4: tunnel.wind_sensor_resolution_m_s = 6 is out of range; allowed: 0 to 5"},
        Rule{"FaultsNotATable", "faults = [1]\n", ":3: faults must be written as [[faults]]"},
        Rule{"FaultKindMissing", "[[faults]]\nfrom_s = 1\n", ":3: faults.kind is missing"},
        Rule{"FaultKindUnknown", "[[faults]]\nkind = \"stuck\"\n",
             ":4: faults.kind = 'stuck'; allowed: canard_stuck, canard_hardover, canard_dead, canard_slipping, "
             "canard_reversed, canard_slow, canard_wrong_trim, encoder_unplugged, encoder_noisy, imu_dropout, "
             "accelerometer_dropout, imu_frozen, imu_offset, second_imu_dropout, second_imu_frozen, second_imu_offset, "
             "reset, device"},
        Rule{"DeviceWithoutThatBehaviour",
             "[[faults]]\nkind = \"device\"\nfrom_s = 1\nuntil_s = 2\ndevice = \"bus\"\nbehaviour = \"cut\"\n",
             ":8: faults.behaviour = cut; allowed for bus: dead, repeated, garbage"},
        Rule{
            "DeviceUnknown",
            "[[faults]]\nkind = \"device\"\nfrom_s = 1\nuntil_s = 2\ndevice = \"radio\"\nbehaviour = \"dead\"\n",
            ":7: faults.device = 'radio'; allowed: imu, second_imu, accelerometer, encoder, servo, bus, flash, supply, "
            "arm_switch, abort_input, memory, processor, barometer"},
        Rule{"AbortInputThatIsNotFitted",
             "[[faults]]\nkind = \"device\"\nfrom_s = 1\nuntil_s = 2\ndevice = \"abort_input\"\nbehaviour = "
             "\"pressed\"\n",
             ":7: faults.device = abort_input, and the plan has none (run.abort_input)"},
        Rule{"DeviceThatIsNotFitted",
             "[[faults]]\nkind = \"device\"\nfrom_s = 1\nuntil_s = 2\ndevice = \"second_imu\"\nbehaviour = "
             "\"dead\"\n",
             ":7: faults.device = second_imu, and the vehicle has no second IMU (second_imu.fitted)"},
        Rule{"BarometerThatIsNotFitted",
             "[[faults]]\nkind = \"device\"\nfrom_s = 1\nuntil_s = 2\ndevice = \"barometer\"\nbehaviour = \"lit\"\n",
             ":7: faults.device = barometer, and the vehicle has none (barometer.fitted)"},
        Rule{"AirTemperature", "[environment]\nair_temperature_c = -61\n",
             ":4: environment.air_temperature_c = -61 is out of range; allowed: -60 to 60"},
        Rule{"DeviceEndsBeforeItBegins",
             "[[faults]]\nkind = \"device\"\nfrom_s = 2\nuntil_s = 1\ndevice = \"imu\"\nbehaviour = \"dead\"\n",
             ":6: faults.until_s = 1 is out of range; allowed: later than from_s = 2, up to 3600"},
        Rule{"DeviceGoneForAWhileWithoutBeingThereForOne",
             "[[faults]]\nkind = \"device\"\nfrom_s = 1\nuntil_s = 2\ndevice = \"imu\"\nbehaviour = "
             "\"dead\"\noff_s = 1\n",
             ":9: faults.off_s = 1; allowed without on_s: 0"},
        Rule{"ResetOnThePad", "[[faults]]\nkind = \"reset\"\nfrom_s = -1\n",
             ":5: faults.from_s = -1; allowed for a reset: 0 to 3600"},
        Rule{"ResetOfNoCause", "[[faults]]\nkind = \"reset\"\nfrom_s = 1\ncause = \"power\"\n",
             ":6: faults.cause = 'power'; allowed: power_on, brown_out, pin, software, watchdog"},
        Rule{"ResetWithoutGap", "[[faults]]\nkind = \"reset\"\nfrom_s = 1\ngap_s = 0\n",
             ":6: faults.gap_s = 0 is out of range; allowed: 0.001 to 10"},
        Rule{"ResetOfACanard", "[[faults]]\nkind = \"reset\"\nfrom_s = 1\ncanard = 1\n",
             ":6: unknown key faults.canard; allowed: kind, from_s, cause, gap_s, memory, clock_error_s"},
        Rule{"FaultOfASecondImuThatIsNotFitted", "[[faults]]\nkind = \"second_imu_frozen\"\nfrom_s = 2\nuntil_s = 3\n",
             ":4: faults.kind = second_imu_frozen, and the vehicle has no second IMU (second_imu.fitted)"},
        Rule{"OffsetOfNothing", "[[faults]]\nkind = \"imu_offset\"\nfrom_s = 2\nuntil_s = 3\n",
             ":3: faults.offset_deg_s is missing; allowed: -2000 to 2000"},
        Rule{"FaultCanard", "[[faults]]\nkind = \"canard_stuck\"\nfrom_s = 1\ncanard = 5\n",
             ":6: faults.canard = 5 is out of range; allowed: 1 to 4"},
        Rule{"SecondFault",
             "[[faults]]\nkind = \"canard_stuck\"\nfrom_s = 1\ncanard = 1\n[[faults]]\nkind = \"canard_dead\"\n"
             "from_s = 1\ncanard = 0\n",
             ":10: faults.canard = 0 is out of range; allowed: 1 to 4"},
        Rule{"DropoutEndsBeforeItBegins", "[[faults]]\nkind = \"imu_dropout\"\nfrom_s = 2\nuntil_s = 1\n",
             ":6: faults.until_s = 1 is out of range; allowed: later than from_s = 2, up to 3600"},
        Rule{"DropoutOfNoTime", "[[faults]]\nkind = \"imu_dropout\"\nfrom_s = 2\nuntil_s = 2\n",
             ":6: faults.until_s = 2 is out of range; allowed: later than from_s = 2, up to 3600"},
        Rule{"FaultLaterThanAnyRun", "[[faults]]\nkind = \"canard_dead\"\nfrom_s = 3601\ncanard = 1\n",
             ":5: faults.from_s = 3601 is out of range; allowed: -600 to 3600"},
        Rule{"DisturbanceLaterThanAnyRun", "[disturbance]\ntimes_s = [3601]\nangles_deg = [1]\n",
             ":4: disturbance.times_s = 3601 is out of range; allowed: 0 to 3600"},
        Rule{"DropoutOfACanard", "[[faults]]\nkind = \"imu_dropout\"\nfrom_s = 2\nuntil_s = 3\ncanard = 1\n",
             ":7: unknown key faults.canard; allowed: kind, from_s, until_s"},
        Rule{"StuckBeyondTheStop", "[[faults]]\nkind = \"canard_stuck\"\nfrom_s = 2\ncanard = 1\nangle_deg = -25.1\n",
             ":7: faults.angle_deg = -25.1; allowed: within the servo's stop, 25 either way"},
        Rule{"WrongTrimOfNothing", "[[faults]]\nkind = \"canard_wrong_trim\"\nfrom_s = 2\ncanard = 1\nangle_deg = 0\n",
             ":7: faults.angle_deg = 0; allowed: -15 to 15, but not 0"},
        Rule{"WrongTrimTooLarge",
             "[[faults]]\nkind = \"canard_wrong_trim\"\nfrom_s = 2\ncanard = 1\nangle_deg = 15.1\n",
             ":7: faults.angle_deg = 15.1 is out of range; allowed: -15 to 15"},
        Rule{"AngleOfASlowCanard", "[[faults]]\nkind = \"canard_slow\"\nfrom_s = 2\ncanard = 1\nangle_deg = 1\n",
             ":7: unknown key faults.angle_deg; allowed: kind, from_s, canard"},
        Rule{"NoiseOfNothing", "[[faults]]\nkind = \"encoder_noisy\"\nfrom_s = 2\ncanard = 1\nnoise_counts = 0\n",
             ":7: faults.noise_counts = 0 is out of range; allowed: 1 to 1000"},
        Rule{"NoiseOfAStuckCanard", "[[faults]]\nkind = \"canard_stuck\"\nfrom_s = 2\ncanard = 1\nnoise_counts = 5\n",
             ":7: unknown key faults.noise_counts; allowed: kind, from_s, canard, angle_deg"}),
    [](const auto& one) { return one.param.name; });

std::vector<Override> changes(std::initializer_list<const char*> texts) {
  std::vector<Override> all;
  for (const char* text : texts) {
    all.push_back(parse_override(text));
  }
  return all;
}

TEST(TunnelAir, IsTheTunnelsAndTheSameForEveryReader) {
  const sim::Scenario scenario = load_scenario("tunnel_steps", changes({"tunnel.density_kg_m3=1.1"}));
  EXPECT_DOUBLE_EQ(scenario.atmosphere.density_kg_m3(0.0), 1.1);
  EXPECT_DOUBLE_EQ(scenario.atmosphere.density_kg_m3(500.0), 1.1);
}

TEST(TunnelAir, CannotBeSetAsThatOfAFlight) {
  for (const char* change : {"environment.density=isa", "environment.density_kg_m3=1.1"}) {
    const Complaint refused = complaint([&] { (void)load_scenario("tunnel_steps", changes({change})); });
    EXPECT_EQ(refused.fault, text::ErrorKind::bad_configuration);
    EXPECT_NE(refused.message.find("has no effect in the tunnel; allowed: tunnel.density_kg_m3 instead"),
              std::string::npos)
        << refused.message;
    EXPECT_TRUE(refused.message.starts_with(std::string{"--set "} + change)) << refused.message;
  }
}

TEST(WrongTrim, IsRefusedBeyondTheStop) {
  const ScratchFile file{head + "[[faults]]\nkind = \"canard_wrong_trim\"\nfrom_s = 2\ncanard = 1\nangle_deg = 7\n"};
  const Complaint refused =
      complaint([&] { (void)load_scenario(file.path().string(), changes({"servo.stop_deg=6"})); });
  EXPECT_EQ(refused.message, "plan.toml:7: faults.angle_deg = 7; allowed: within the servo's stop, 6 either way");
  // What is not in the file is held to the same rule.
  const ScratchFile usual{head + "[[faults]]\nkind = \"canard_wrong_trim\"\nfrom_s = 2\ncanard = 1\n"};
  EXPECT_NE(complaint([&] {
              (void)load_scenario(usual.path().string(), changes({"servo.stop_deg=2"}));
            }).message.find("faults.angle_deg = 2.5"),
            std::string::npos);
}

TEST(Stability, SaysWhereTheCentreOfPressureOfARocketThatIsNotStableIs) {
  const auto warnings = [](const std::string& position_m) {
    const std::vector<Override> changes{parse_override("airframe.centre_of_gravity_after_burnout_m=0.8"),
                                        parse_override("airframe.centre_of_pressure_m=" + position_m)};
    return load_scenario("tasha3_launch2", changes).warnings;
  };
  EXPECT_EQ(warnings("0.901"), std::vector<std::string>{});
  EXPECT_EQ(warnings("0.9"), std::vector<std::string>{"The rocket is not stable at lift-off: its centre of pressure is "
                                                      "at its centre of gravity."});
  EXPECT_EQ(warnings("0.88"), std::vector<std::string>{"The rocket is unstable at lift-off: its centre of pressure is "
                                                       "20 mm in front of its centre of gravity."});
  EXPECT_EQ(warnings("0.7").size(), 2U);
}

}  // namespace
}  // namespace fantail::input
