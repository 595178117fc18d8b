// SPDX-License-Identifier: MIT
// The barometer alone, and the pressure of the air.

#include "sim/barometer_model.hpp"

#include "sim/atmosphere.hpp"
#include "test.hpp"

namespace fantail::sim {
namespace {

constexpr std::uint64_t any_seed = 11;
constexpr double ground_pa = 101325.0;

/// Nothing of its own: it reads the air.
constexpr BarometerParameters ideal{.is_fitted = true, .noise_pa = 0.0, .port_error = 0.0, .vent_lag_s = 0.0};

struct Read {
  hal::Microseconds at;
  hal::BarometerSample sample;
};

/// The new samples of the first `last_ms` milliseconds.
std::vector<Read> new_samples(
    const BarometerParameters& parameters, int last_ms, const std::function<AirAtPorts(double)>& air,
    const std::function<BarometerFault(double)>& wrong = [](double) { return BarometerFault{}; }) {
  BarometerModel barometer{parameters, {any_seed, 0}};
  std::vector<Read> all;
  for (int ms = 0; ms <= last_ms; ++ms) {
    const double time_s = 1e-3 * ms;
    const hal::BarometerSample& sample = barometer.sample(hal::Microseconds{1000 * ms}, air(time_s), wrong(time_s));
    if (sample.status == hal::Status::ok && (all.empty() || sample.time != all.back().sample.time)) {
      all.push_back({hal::Microseconds{1000 * ms}, sample});
    }
  }
  return all;
}

AirAtPorts at_rest(double) { return {.static_pa = ground_pa}; }

double seconds(hal::Microseconds time) { return 1e-6 * static_cast<double>(time.count()); }

double shown_height_m(double pressure_pa) {
  return 288.15 / 0.0065 * (1.0 - std::pow(pressure_pa / ground_pa, 287.05287 * 0.0065 / gravity_m_s2));
}

// ISO 2533, table 1.
TEST(AirPressure, IsThatOfTheStandardAtmosphereWhateverTheDensity) {
  for (const DensityModel model : {DensityModel::exponential, DensityModel::isa, DensityModel::constant}) {
    const Atmosphere air{.model = model};
    EXPECT_NEAR(air.pressure_pa(0.0), 101325.0, 0.01);
    EXPECT_NEAR(air.pressure_pa(1000.0), 89875.0, 1.0);
    EXPECT_NEAR(air.pressure_pa(3000.0), 70108.0, 1.0);
    EXPECT_NEAR(air.pressure_pa(11000.0), 22632.0, 1.0);
    EXPECT_NEAR(air.pressure_pa(15000.0), 12045.0, 1.0);
  }
}

TEST(AirPressure, CountsFromTheElevationOfTheSite) {
  const Atmosphere air{.elevation_m = 1000.0};
  EXPECT_NEAR(air.pressure_pa(0.0), 89875.0, 1.0);
  EXPECT_NEAR(air.pressure_pa(2000.0), 70108.0, 1.0);
  EXPECT_NEAR(air.pressure_pa(-1000.0), 101325.0, 0.01);
}

// The air weighs what its pressure falls by.
TEST(AirPressure, FallsWithTheWeightOfTheStandardAtmosphere) {
  const Atmosphere air{.model = DensityModel::isa};
  for (const double height_m : {0.0, 500.0, 3000.0, 9000.0, 14000.0}) {
    const double weight_pa = air.pressure_pa(height_m - 1.0) - air.pressure_pa(height_m + 1.0);
    EXPECT_NEAR(weight_pa, 2.0 * gravity_m_s2 * air.density_kg_m3(height_m), 1e-5 * weight_pa) << height_m;
  }
}

// 268.15 K instead of 288.15: each height counts 1.0746 times itself.
TEST(AirPressure, OfAColdDayMakesAStandardHeightReadTooHighAndOfAHotDayTooLow) {
  Atmosphere air{};
  const Atmosphere standard{};
  for (const double temperature_c : {-5.0, 15.0, 40.0}) {
    air.air_temperature_c = temperature_c;
    EXPECT_NEAR(air.pressure_pa(0.0), ground_pa, 0.01);
    for (const double height_m : {100.0, 1000.0, 3000.0}) {
      EXPECT_NEAR(shown_height_m(air.pressure_pa(height_m)), height_m * 288.15 / (temperature_c + 273.15), 0.01)
          << temperature_c << ' ' << height_m;
    }
  }
  EXPECT_EQ(air.density_kg_m3(1000.0), standard.density_kg_m3(1000.0));
  EXPECT_EQ(air.speed_of_sound_m_s(1000.0), standard.speed_of_sound_m_s(1000.0));
}

// The lapse rate stays: in hydrostatic balance, T = g p / (R dp/dz) with the sign of the fall.
TEST(AirPressure, OfAColdDayBelongsToAirThatCoolsBySixAndAHalfDegreesAKilometre) {
  const Atmosphere air{.elevation_m = 500.0, .air_temperature_c = -10.0};
  for (const double height_m : {0.0, 1000.0, 4000.0}) {
    const double fall_pa_m = 0.5 * (air.pressure_pa(height_m - 1.0) - air.pressure_pa(height_m + 1.0));
    const double temperature_k = gravity_m_s2 * air.pressure_pa(height_m) / (287.05287 * fall_pa_m);
    EXPECT_NEAR(temperature_k, 263.15 - 0.0065 * height_m, 0.01) << height_m;
  }
}

TEST(BarometerModel, HasANewSampleEveryTenMillisecondsWhoseTimeIsFiveBefore) {
  const auto samples = new_samples(ideal, 100, at_rest);
  ASSERT_EQ(samples.size(), 10U);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    EXPECT_EQ(samples[i].at, hal::Microseconds{10'000 * (i + 1)});
    EXPECT_EQ(samples[i].sample.time, samples[i].at - hal::Microseconds{5'000});
    EXPECT_EQ(samples[i].sample.pressure_pa, 101325U);
  }
}

TEST(BarometerModel, HasNoReadingBeforeItsFirstMeasurement) {
  BarometerModel barometer{ideal, {any_seed, 0}};
  for (int ms = 0; ms < 10; ++ms) {
    EXPECT_EQ(barometer.sample(hal::Microseconds{1000 * ms}, at_rest(0.0), {}).status, hal::Status::no_reading) << ms;
  }
}

TEST(BarometerModel, MeasuresTheAirOfTheTimeThatItsSampleCarriesToTheNearestPascal) {
  for (const Read& read :
       new_samples(ideal, 200, [](double time_s) { return AirAtPorts{.static_pa = ground_pa - 1234.0 * time_s}; })) {
    EXPECT_EQ(read.sample.pressure_pa, std::lround(ground_pa - 1234.0 * seconds(read.sample.time)));
  }
}

// 150 m/s at 1.1 kg/m3: 12375 Pa.
TEST(BarometerModel, AddsItsPortErrorTimesTheDynamicPressure) {
  for (const double port_error : {0.03, -0.03, 0.2}) {
    BarometerParameters parameters = ideal;
    parameters.port_error = port_error;
    const auto samples = new_samples(
        parameters, 20, [](double) { return AirAtPorts{.static_pa = 90000.0, .dynamic_pa = 12375.0, .mach = 0.45}; });
    EXPECT_EQ(samples.back().sample.pressure_pa, std::lround(90000.0 + port_error * 12375.0));
  }
}

TEST(BarometerModel, IsDisturbedByTheShockBetweenMachNineTenthsAndElevenTenthsAndMostAtOne) {
  const auto read_pa = [](double mach) {
    const auto samples = new_samples(
        ideal, 20, [mach](double) { return AirAtPorts{.static_pa = 90000.0, .dynamic_pa = 60000.0, .mach = mach}; });
    return static_cast<double>(samples.back().sample.pressure_pa) - 90000.0;
  };
  for (const double mach : {0.0, 0.8, 0.9, 1.1, 1.5}) {
    EXPECT_NEAR(read_pa(mach), 0.0, 0.51) << mach;
  }
  EXPECT_NEAR(read_pa(1.0), 6000.0, 0.51);
  EXPECT_NEAR(read_pa(0.95), 3000.0, 0.51);
  EXPECT_NEAR(read_pa(1.05), 3000.0, 0.51);
}

// The step comes within the millisecond from 0.1 s on; the rest is e^(-t / 0.05 s) of it.
TEST(BarometerModel, FollowsAStepAsAFirstOrderLag) {
  BarometerParameters parameters = ideal;
  parameters.vent_lag_s = 0.05;
  const auto samples = new_samples(parameters, 500, [](double time_s) {
    return AirAtPorts{.static_pa = time_s > 0.1005 ? ground_pa - 10000.0 : ground_pa};
  });
  for (const Read& read : samples) {
    const double since_s = seconds(read.sample.time) - 0.1005;
    const double expected_pa = since_s < 0.0 ? ground_pa : ground_pa - 10000.0 * (1.0 - std::exp(-since_s / 0.05));
    EXPECT_NEAR(read.sample.pressure_pa, expected_pa, 1.0) << since_s;
  }
}

TEST(BarometerModel, TrailsASteadyClimbByItsLag) {
  BarometerParameters parameters = ideal;
  parameters.vent_lag_s = 0.05;
  const auto samples =
      new_samples(parameters, 1000, [](double time_s) { return AirAtPorts{.static_pa = ground_pa - 2000.0 * time_s}; });
  const hal::BarometerSample& last = samples.back().sample;
  EXPECT_NEAR(last.pressure_pa, ground_pa - 2000.0 * (seconds(last.time) - 0.05), 0.51);
}

TEST(BarometerModel, FeelsTheEjectionChargeForThirtyMilliseconds) {
  const auto samples = new_samples(ideal, 100, [](double time_s) {
    return AirAtPorts{.static_pa = ground_pa,
                      .since_ejection_s = time_s >= 0.04 ? std::optional{time_s - 0.04} : std::nullopt};
  });
  for (const Read& read : samples) {
    const double since_s = seconds(read.sample.time) - 0.04;
    const double expected_pa = since_s < 0.0 ? 0.0 : std::max(0.0, 5000.0 * (1.0 - since_s / 0.03));
    EXPECT_NEAR(read.sample.pressure_pa, ground_pa + expected_pa, 0.51) << since_s;
  }
}

TEST(BarometerModel, HasWhiteNoiseOfTheGivenStandardDeviationAboutItsOffset) {
  BarometerParameters parameters = ideal;
  parameters.noise_pa = 1.5;
  parameters.offset_pa = -250.0;
  const auto samples = new_samples(parameters, 500'000, at_rest);
  const auto count = static_cast<double>(samples.size());
  double sum = 0.0;
  double squares = 0.0;
  double neighbours = 0.0;
  double last = 0.0;
  for (const Read& read : samples) {
    const double error_pa = static_cast<double>(read.sample.pressure_pa) - (ground_pa - 250.0);
    sum += error_pa;
    squares += error_pa * error_pa;
    neighbours += error_pa * last;
    last = error_pa;
  }
  const double variance = 1.5 * 1.5 + 1.0 / 12.0;  // and rounding
  EXPECT_NEAR(sum / count, 0.0, 4.0 * std::sqrt(variance / count));
  EXPECT_NEAR(squares / count, variance, 4.0 * variance * std::sqrt(2.0 / count));
  EXPECT_NEAR(neighbours / count, 0.0, 4.0 * variance / std::sqrt(count));
}

TEST(BarometerModel, ThatHangsRepeatsItsLastSampleWithItsOldTimeAndThenMeasuresAgain) {
  const auto samples = new_samples(
      ideal, 100, at_rest, [](double time_s) { return BarometerFault{.hangs = time_s > 0.0305 && time_s < 0.0575}; });
  std::vector<int> delivered_ms;
  std::ranges::transform(samples, std::back_inserter(delivered_ms),
                         [](const Read& read) { return static_cast<int>(read.at.count() / 1000); });
  // That of 0.055 s was never measured.
  EXPECT_EQ(delivered_ms, (std::vector<int>{10, 20, 30, 70, 80, 90, 100}));
  for (const Read& read : samples) {
    EXPECT_EQ(read.sample.time, read.at - hal::Microseconds{5'000});
  }
}

TEST(BarometerModel, WithBlockedPortsKeepsThePressureOfTheMomentWithItsNoiseAndVentsAfterwards) {
  BarometerParameters parameters = ideal;
  parameters.noise_pa = 1.5;
  parameters.vent_lag_s = 0.01;
  const auto air = [](double time_s) { return AirAtPorts{.static_pa = ground_pa - 10000.0 * time_s}; };
  const auto blocked = [](double time_s) { return time_s > 0.0995 && time_s < 0.4995; };
  const auto samples =
      new_samples(parameters, 700, air, [&](double time_s) { return BarometerFault{.blocked = blocked(time_s)}; });
  std::set<std::uint32_t> while_blocked;
  for (const Read& read : samples) {
    const double time_s = seconds(read.sample.time);
    if (blocked(time_s)) {
      EXPECT_NEAR(read.sample.pressure_pa, ground_pa - 10000.0 * (0.099 - 0.01), 8.0) << time_s;
      while_blocked.insert(read.sample.pressure_pa);
    } else if (time_s < 0.0995 || time_s > 0.6) {
      EXPECT_NEAR(read.sample.pressure_pa, air(time_s - 0.01).static_pa, time_s < 0.0995 ? 110.0 : 8.0) << time_s;
    }
  }
  EXPECT_GT(while_blocked.size(), 3U);
}

// 1500 Pa are 125 m at the ground.
TEST(BarometerModel, InSunlightReadsAHundredAndTwentyFiveMetresTooHighWhileItLasts) {
  const auto samples = new_samples(ideal, 300, at_rest,
                                   [](double time_s) { return BarometerFault{.lit = time_s > 0.1 && time_s < 0.2}; });
  for (const Read& read : samples) {
    const bool lit = seconds(read.sample.time) > 0.1 && seconds(read.sample.time) < 0.2;
    EXPECT_EQ(read.sample.pressure_pa, lit ? 99825U : 101325U);
    EXPECT_NEAR(shown_height_m(read.sample.pressure_pa), lit ? 125.7 : 0.0, 1.0);
  }
}

TEST(BarometerModel, ReadsNothingBelowVacuum) {
  BarometerParameters parameters = ideal;
  parameters.offset_pa = -5000.0;
  EXPECT_EQ(
      new_samples(parameters, 20, [](double) { return AirAtPorts{.static_pa = 100.0}; }).back().sample.pressure_pa, 0U);
}

TEST(BarometerModel, RefusesWhatIsOutOfRange) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double wrong : {-0.1, 500.1, nan}) {
    EXPECT_THROW((BarometerModel{{.noise_pa = wrong}, {any_seed, 0}}), std::invalid_argument) << wrong;
  }
  for (const double wrong : {-1.01, 1.01, nan}) {
    EXPECT_THROW((BarometerModel{{.port_error = wrong}, {any_seed, 0}}), std::invalid_argument) << wrong;
  }
  for (const double wrong : {-0.001, 5.001, nan}) {
    EXPECT_THROW((BarometerModel{{.vent_lag_s = wrong}, {any_seed, 0}}), std::invalid_argument) << wrong;
  }
  for (const double wrong : {-5001.0, 5001.0, nan}) {
    EXPECT_THROW((BarometerModel{{.offset_pa = wrong}, {any_seed, 0}}), std::invalid_argument) << wrong;
  }
}

}  // namespace
}  // namespace fantail::sim
