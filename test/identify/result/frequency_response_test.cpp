// SPDX-License-Identifier: MIT
#include "identify/result/frequency_response.hpp"

#include <cmath>
#include <complex>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "identify/model/open_loop.hpp"
#include "identify/model/planted.hpp"
#include "identify/result/words.hpp"
#include "seed.hpp"

namespace fantail::identify::result {
namespace {

using namespace model;

constexpr double speed_m_s = 50.0;
constexpr double density_kg_m3 = 1.2;
const RollModel true_model{
    .alpha_m2 = 20.0, .beta_m = 9.0, .node_time_s = {0.0}, .node_rad = {-0.05}, .initial = {{0.1, -0.3}}};

// Of the roll equation: authority / (i omega + damping).
std::complex<double> gain_per_s(double frequency_hz) {
  const double common = 0.5 * density_kg_m3 * speed_m_s * tasha.reference_area_m2 / tasha.inertia_kg_m2;
  return common * speed_m_s * true_model.beta_m /
         std::complex<double>{common * true_model.alpha_m2, 2.0 * std::numbers::pi * frequency_hz};
}

/// A run of noise through a first-order low-pass, rms 1.
class Wander {
 public:
  Wander(std::uint64_t seed, double memory_s, double step_s)
      : generator_{seed}, kept_{std::exp(-step_s / memory_s)}, value_{gauss_(generator_)} {}
  double next() { return value_ = kept_ * value_ + std::sqrt(1.0 - kept_ * kept_) * gauss_(generator_); }

 private:
  std::mt19937_64 generator_;
  std::normal_distribution<double> gauss_;
  double kept_;
  double value_;
};

Record standing_air(double seconds, double rate_hz) {
  Record record;
  record.window = "planted";
  for (int i = 0; i <= static_cast<int>(seconds * rate_hz); ++i) {
    record.time_s.push_back(i / rate_hz);
    record.speed_m_s.push_back(speed_m_s);
    record.density_kg_m3.push_back(density_kg_m3);
  }
  return record;
}

// Canards that move by themselves, with energy up to about 5 Hz.
Record open_loop_record(double seconds, double canard_deg, double rate_noise_deg_s, std::uint64_t seed) {
  Record record = standing_air(seconds, 100.0);
  Wander canards{seed, 0.03, 0.01};
  for (std::size_t i = 0; i < record.size(); ++i) {
    record.canard_rad.push_back(radians_per_degree * canard_deg * canards.next());
  }
  record.roll_angle_rad.assign(record.size(), 0.0);
  record.roll_rate_rad_s.assign(record.size(), 0.0);
  const Simulation flown = simulate_open_loop(record, tasha, true_model);
  record.roll_angle_rad = flown.roll_angle_rad;
  record.roll_rate_rad_s = flown.roll_rate_rad_s;
  add_noise(record, {.angle_deg = 0.0, .rate_deg_s = rate_noise_deg_s}, seed + 1);
  return record;
}

FrequencyResponse response_of(const Record& record) {
  return frequency_response(record, simulate_open_loop(record, tasha, true_model));
}

TEST(FrequencyResponse, OfANoiseFreeLogIsThatOfTheRollEquation) {
  const FrequencyResponse found = response_of(open_loop_record(20.0, 3.0, 0.0, 1));
  ASSERT_GE(found.segments, 8U);
  std::size_t seen = 0;
  for (const FrequencyLine& line : found.lines) {
    if (line.frequency_hz > 8.0) {
      continue;
    }
    ASSERT_TRUE(line.estimate) << line.frequency_hz;
    const std::complex<double> expected = gain_per_s(line.frequency_hz);
    EXPECT_NEAR(line.estimate->gain_per_s, std::abs(expected), 0.03 * std::abs(expected)) << line.frequency_hz;
    // A Hann window looks at its neighbours, too, and the gain changes from line to line.
    EXPECT_NEAR(line.estimate->phase_rad, std::arg(expected), 0.06) << line.frequency_hz;
    EXPECT_NEAR(line.estimate->model_gain_per_s, line.estimate->gain_per_s, 1e-9) << line.frequency_hz;
    ++seen;
  }
  EXPECT_GE(seen, 20U);
}

TEST(FrequencyResponse, ItsIntervalsHoldTheTruth) {
  const std::uint64_t first_seed = test::seed(40);
  constexpr int records = 60;
  int told = 0;
  int inside = 0;
  for (int i = 0; i < records; ++i) {
    const FrequencyResponse found =
        response_of(open_loop_record(12.0, 2.0, 10.0, first_seed + 10 * static_cast<std::uint64_t>(i)));
    for (const FrequencyLine& line : found.lines) {
      if (line.coherence > 0.8 && line.estimate) {
        ++told;
        inside +=
            std::abs(line.estimate->gain_per_s - std::abs(gain_per_s(line.frequency_hz))) <= line.estimate->reach_per_s
                ? 1
                : 0;
      }
    }
  }
  RecordProperty("told", told);
  RecordProperty("inside", inside);
  EXPECT_GT(told, 500);
  EXPECT_GE(inside, 92 * told / 100);
  EXPECT_LT(inside, told);
}

TEST(FrequencyResponse, IsNotToldWhereNoiseHidesIt) {
  const FrequencyResponse found = response_of(open_loop_record(20.0, 0.02, 30.0, 3));
  const FrequencyCount count = count_lines(found);
  EXPECT_LE(count.told, found.lines.size() / 20);
  EXPECT_GT(found.lines.size(), 50U);
}

TEST(FrequencyResponse, NeedsCanardsThatMove) {
  Record record = open_loop_record(10.0, 0.0, 1.0, 4);
  const FrequencyResponse found = response_of(record);
  EXPECT_EQ(count_lines(found).told, 0U);
  EXPECT_NE(frequency_sentence(found).find("at none of"), std::string::npos) << frequency_sentence(found);
}

TEST(FrequencyResponse, OfAWindowThatIsTooShortSaysSo) {
  const FrequencyResponse found = response_of(open_loop_record(1.5, 3.0, 1.0, 5));
  EXPECT_TRUE(found.lines.empty());
  EXPECT_NE(frequency_sentence(found).find("at least 2.2 s"), std::string::npos) << frequency_sentence(found);
}

TEST(FrequencyResponse, DoesNotReachAcrossGaps) {
  Record record = open_loop_record(20.0, 3.0, 0.0, 6);
  record.segment_begin = {0, 700};
  for (std::size_t i = 700; i < record.size(); ++i) {
    record.time_s[i] += 5.0;
  }
  const FrequencyResponse found = frequency_response(record, {.roll_rate_rad_s = record.roll_rate_rad_s});
  ASSERT_FALSE(found.lines.empty()) << found.obstacle;
  const FrequencyCount count = count_lines(found);
  EXPECT_EQ(count.agreed, count.told);
  for (const FrequencyLine& line : found.lines) {
    if (line.frequency_hz < 8.0) {
      EXPECT_NEAR(line.estimate->gain_per_s / std::abs(gain_per_s(line.frequency_hz)), 1.0, 0.05) << line.frequency_hz;
    }
  }
}

/// The roll under a controller, with gusts that turn the rocket and an excitation at the canards; Euler, a step a
/// millisecond.
Record closed_loop_record(bool excited, std::uint64_t seed) {
  constexpr double step_s = 0.001;
  constexpr int steps_per_sample = 10;
  Record record = standing_air(60.0, 100.0);
  Wander gusts{seed, 0.1, step_s};
  Wander excitation{seed + 1, 0.05, 0.01};
  const double common = 0.5 * density_kg_m3 * speed_m_s * tasha.reference_area_m2 / tasha.inertia_kg_m2;
  double angle = 0.0;
  double rate = 0.0;
  for (std::size_t i = 0; i < record.size(); ++i) {
    record.excitation_rad.push_back(excited ? radians_per_degree * excitation.next() : 0.0);
    record.roll_angle_rad.push_back(angle);
    record.roll_rate_rad_s.push_back(rate);
    record.canard_rad.push_back(-0.5 * angle - 0.1 * rate + record.excitation_rad.back());
    record.reference_rad.push_back(0.0);
    record.in_control.push_back(true);
    for (int k = 0; k < steps_per_sample; ++k) {
      const double gust_rad = 0.6 * radians_per_degree * gusts.next();
      const double acceleration =
          common * (speed_m_s * true_model.beta_m * (record.canard_rad.back() + gust_rad) - true_model.alpha_m2 * rate);
      angle += step_s * rate;
      rate += step_s * acceleration;
    }
  }
  return record;
}

// Of the lines with an estimate from 0.5 to 4 Hz; the canards stand still for the length of a sample, which delays them
// by half of one but hardly changes the gain.
double mean_ratio(const FrequencyResponse& found) {
  double sum = 0.0;
  int count = 0;
  for (const FrequencyLine& line : found.lines) {
    if (line.frequency_hz > 0.5 && line.frequency_hz < 4.0 && line.estimate) {
      sum += line.estimate->gain_per_s / std::abs(gain_per_s(line.frequency_hz));
      ++count;
    }
  }
  return count > 0 ? sum / count : 0.0;
}

TEST(FrequencyResponse, OfAClosedLoopIsTakenWithTheExcitationAndNotBiased) {
  Record record = closed_loop_record(true, 7);
  const FrequencyResponse with = frequency_response(record, {.roll_rate_rad_s = record.roll_rate_rad_s});
  EXPECT_EQ(with.instrument, Instrument::excitation);
  EXPECT_NEAR(mean_ratio(with), 1.0, 0.08);

  record.excitation_rad.clear();
  record.reference_rad.clear();
  const FrequencyResponse without = frequency_response(record, {.roll_rate_rad_s = record.roll_rate_rad_s});
  EXPECT_EQ(without.instrument, Instrument::canards);
  RecordProperty("with", std::to_string(mean_ratio(with)));
  RecordProperty("without", std::to_string(mean_ratio(without)));
  EXPECT_GT(std::abs(mean_ratio(without) - 1.0), 0.12);
}

TEST(FrequencyResponse, SaysThatFeedbackBiasesIt) {
  const Record record = closed_loop_record(false, 8);
  const FrequencyResponse found = frequency_response(record, {.roll_rate_rad_s = record.roll_rate_rad_s});
  EXPECT_EQ(found.instrument, Instrument::canards);
  EXPECT_TRUE(found.loop_was_closed);
  EXPECT_NE(instrument_sentence(found).find("bias this estimate"), std::string::npos);
}

}  // namespace
}  // namespace fantail::identify::result
