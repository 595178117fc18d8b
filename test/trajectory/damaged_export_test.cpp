// SPDX-License-Identifier: MIT
// Exports with odd bytes, words and numbers in them: a path that can be flown, or refused with a sentence. Nothing else
// may happen.
#include <cmath>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

#include <fmt/core.h>
#include <gtest/gtest.h>

#include "input/scenario_file.hpp"
#include "seed.hpp"
#include "text/error.hpp"
#include "trajectory/trajectory.hpp"

namespace fantail::trajectory {
namespace {

/// Few rows, so that a change is likely to hit something: a tenth of a second apart.
std::string thrown(const std::string& header, const std::string& more) {
  std::string text = header + "\n# Event LAUNCH occurred at t=0 seconds\n";
  for (int i = -2; i <= 40; ++i) {
    const double t = 0.05 * i;
    const double speed = t < 0.0 ? 0.0 : t < 0.5 ? 40.0 * t : 20.0 - 15.0 * (t - 0.5);
    const double height = t < 0.0 ? 0.0 : t < 0.5 ? 20.0 * t * t : 5.0 + (t - 0.5) * (20.0 - 7.5 * (t - 0.5));
    text += fmt::format("{:.2f},{:.3f},{:.3f}{}\n", t, height, speed, more);
  }
  return text;
}

const std::vector<std::string>& exports() {
  static const std::vector<std::string> all{
      thrown("# Time (s),Altitude (m),Vertical velocity (m/s)", ""),
      thrown("# Time (s),Altitude (m),Total velocity (m/s),Vertical orientation (zenith) (\u00b0),Air temperature "
             "(\u00b0C),Air pressure (mbar)",
             ",85.0,15.0,1013.2"),
      thrown("# Time (s), Altitude AGL (m), Vz (m/s), Horizontal Speed (m/s), Density (kg/m\u00b3), Freestream Speed "
             "(m/s), Angle of Attack (\u00b0), Axial Acceleration (m/s\u00b2)",
             ",1.0,1.200,30.0,2.0,10.0"),
  };
  return all;
}

const std::vector<std::string> words{"NaN", "nan", "inf",  "1e300",  "-1e308", "1e-300",   "0",
                                     "-",   ",",   ";",    "\t",     "\n",     "\r\n",     "#",
                                     "\"",  "(",   ")",    "(m)",    "\xB0",   "Time (s)", "E",
                                     ".",   ",,",  "-0.0", "5e-324", "99999",  " ",        "\xEF\xBB\xBF"};

class Mutation {
 public:
  explicit Mutation(std::uint32_t seed) : random_{seed} {}

  std::string next() {
    std::string text = exports()[below(exports().size())];
    for (std::size_t changes = 1 + below(3); changes > 0; --changes) {
      const std::size_t at = below(text.size());
      switch (below(5)) {
        case 0: text.insert(at, words[below(words.size())]); break;
        case 1: text.erase(at, 1 + below(20)); break;
        case 2: text.replace(at, 1 + below(5), words[below(words.size())]); break;
        case 3: text.insert(below(text.size()), text.substr(at, below(60))); break;
        default: text[at] = static_cast<char>(below(256));
      }
    }
    return text;
  }

 private:
  std::size_t below(std::size_t limit) { return random_() % limit; }
  std::mt19937 random_;  // NOLINT(cert-msc32-c,cert-msc51-cpp): the seed is the point
};

void expect_flyable(const sim::PrescribedPath& path, const std::string& text) {
  sim::PrescribedFlight flight{path};
  double before_s = -1e9;
  for (const sim::PathSample& sample : path.samples) {
    ASSERT_GT(sample.time_s, before_s) << text;
    before_s = sample.time_s;
    for (const double after_s : {0.0, 0.01}) {
      flight.advance_to(sample.time_s + after_s);
      const sim::Vector3& felt = flight.specific_force_m_s2();
      ASSERT_TRUE(std::isfinite(felt.x + felt.y + flight.height_m() + flight.speed_m_s() + flight.rate_rad_s().z +
                                flight.angular_acceleration_rad_s2().z))
          << sample.time_s << "\n"
          << text;
      ASSERT_GT(flight.density_kg_m3(), 0.0) << text;
    }
  }
}

TEST(DamagedExport, IsFlownOrRefusedWithOneSentence) {
  const sim::Scenario scenario = input::load_scenario("tasha3_launch2", {});
  Mutation mutation{test::seed(20'261'123)};
  int flown = 0;
  constexpr int cases = 5000;
  for (int i = 0; i < cases; ++i) {
    const std::string text = mutation.next();
    try {
      const Trajectory trajectory = parse_trajectory(text, "other.csv", scenario);
      ++flown;
      expect_flyable(trajectory.path, text);
      if (HasFatalFailure()) {
        return;
      }
    } catch (const text::Error& error) {
      const std::string sentence = error.what();
      EXPECT_TRUE(sentence.starts_with("other.csv:")) << sentence;
      EXPECT_EQ(sentence.find('\n'), std::string::npos) << sentence;
    }
  }
  EXPECT_GT(flown, cases / 20);
  EXPECT_LT(flown, cases * 19 / 20);
}

}  // namespace
}  // namespace fantail::trajectory
