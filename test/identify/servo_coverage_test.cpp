// SPDX-License-Identifier: MIT
// The closed loop of a servo that is not quite what was told: of sixty records each, how many intervals hold the truth,
// and in how many records a doubt is said where they do not.
#include <array>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

#include <fmt/core.h>
#include <gtest/gtest.h>

#include "degree.hpp"
#include "identify/closed_loop/runs.hpp"
#include "identify/doubts.hpp"
#include "identify/identification.hpp"
#include "identify/result/residual.hpp"
#include "seed.hpp"

namespace fantail::identify {
namespace {

using namespace closed_loop;
using namespace model;
using namespace result;

struct ServoCase {
  const char* name;
  double play_deg;
  double told_lag_s;  ///< 18 ms is true
};

void PrintTo(const ServoCase& of, std::ostream* out) { *out << of.name; }

class ServoCoverage : public testing::TestWithParam<ServoCase> {};

int asked_records() {
  const char* asked = std::getenv("FANTAIL_RECORDS");  // NOLINT(concurrency-mt-unsafe): there is one thread
  return asked != nullptr ? std::atoi(asked) : 60;
}

TEST_P(ServoCoverage, HoldsAlphaAndBetaOrSaysADoubt) {
  const auto& [name, play_deg, told_lag_s] = GetParam();
  paper::Loop loop = second_launch_with_chirp();
  loop.servo_lag_s = 0.018;
  loop.servo_play_rad = play_deg * degree;
  const std::uint64_t first_seed = test::seed(1);
  const Airframe airframe = paper::airframe(loop);
  std::array<int, 3> inside{};
  std::array<double, 4> mean{};
  int silent = 0;
  int doubted = 0;
  for (int i = 0; i < asked_records(); ++i) {
    const Record record = closed_loop_record(with_noise(loop, first_seed + static_cast<std::uint64_t>(i)), 4.0, 2);
    Control control = controller_of(loop);
    control.servo_lag_s = told_lag_s;
    // For what was before: the servo held as it is told.
    control.servo_is_fitted = std::getenv("FANTAIL_SERVO_HELD") == nullptr;
    Identification found = identify(record, airframe,
                                    {.nodes = NodeTimes{0.0},
                                     .closed_loop = control,
                                     .grid = {.alpha_m2 = {15.0, 35.0, 10.0}, .beta_m = {8.0, 10.0, 2.0}},
                                     .with_error_map = false});
    found.residual_tests = test_residual(record, found.simulation);
    const std::vector<std::string> said = doubts(record, airframe, Start::measured, found);
    const bool doubt = !said.empty() && said[0].find("servos") != std::string::npos;
    const Uncertainty& known = *found.uncertainty;
    const std::array truth{loop.plant.damping_m2, loop.plant.torque_m};
    bool all = true;
    for (std::size_t k = 0; k < truth.size(); ++k) {
      const bool held = *known.interval[k].low <= truth[k] && truth[k] <= *known.interval[k].high;
      inside[k] += held ? 1 : 0;
      all = all && held;
    }
    if (found.servo && known.lag_s) {
      inside[2] += std::abs(found.servo->lag_s - 0.018) <= known.lag_s->reach ? 1 : 0;
      mean[2] += 1e3 * found.servo->lag_s / asked_records();
      mean[3] += found.servo->play_rad / degree / asked_records();
    }
    mean[0] += found.model.alpha_m2 / asked_records();
    mean[1] += found.model.beta_m / asked_records();
    doubted += doubt ? 1 : 0;
    silent += all || doubt ? 0 : 1;
  }
  fmt::print(
      "{}: of {} records held alpha {}, beta {}, lag {}; doubted {}, wrong without a word {}; means {:.2f} m2, {:.3f} "
      "m, "
      "{:.2f} ms, play {:.3f} deg\n",
      name, asked_records(), inside[0], inside[1], inside[2], doubted, silent, mean[0], mean[1], mean[2], mean[3]);
  // Two intervals of 95 % miss in a tenth of the records at most; thrice their standard deviation.
  EXPECT_LE(silent, 0.1 * asked_records() + 3.0 * std::sqrt(0.09 * asked_records()));
}

INSTANTIATE_TEST_SUITE_P(Servos, ServoCoverage,
                         testing::Values(ServoCase{"told as it is", 0.0, 0.018},
                                         ServoCase{"told 2 ms less", 0.0, 0.016},
                                         ServoCase{"play of 0.1 deg", 0.1, 0.018},
                                         ServoCase{"play of 0.3 deg", 0.3, 0.018}));

}  // namespace
}  // namespace fantail::identify
