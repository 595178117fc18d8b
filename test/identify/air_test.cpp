// SPDX-License-Identifier: MIT
#include "identify/air.hpp"

#include <gtest/gtest.h>

#include "logs/refused.hpp"

namespace fantail::identify {
namespace {

using sim::DensityModel;

logs::RollLog log_between(double low_m, double high_m) {
  logs::RollLog log;
  log.height_m = {low_m, 0.5 * (low_m + high_m), high_m};
  return log;
}

TEST(Air, OfALogThatClimbsThinsWithHeight) {
  const Air air = choose_air(log_between(0.0, 420.0), {});
  EXPECT_EQ(air.atmosphere.model, DensityModel::exponential);
  EXPECT_NE(air.words.find("height_m"), std::string::npos);
}

TEST(Air, OfATunnelIsTheSameThroughout) {
  for (const logs::RollLog& log : {logs::RollLog{}, log_between(0.0, 0.0), log_between(-3.0, 0.4)}) {
    const Air air = choose_air(log, {});
    EXPECT_EQ(air.atmosphere.model, DensityModel::constant);
    EXPECT_EQ(air.atmosphere.constant_kg_m3, 1.2);
    EXPECT_NE(air.words.find("1.2 kg/m3"), std::string::npos);
  }
}

TEST(Air, IsWhatThePersonSays) {
  const logs::RollLog log = log_between(0.0, 420.0);
  EXPECT_EQ(choose_air(log, "1.1").atmosphere.constant_kg_m3, 1.1);
  EXPECT_EQ(choose_air(log, "1.1").atmosphere.model, DensityModel::constant);
  EXPECT_EQ(choose_air(log, "isa").atmosphere.model, DensityModel::isa);
  EXPECT_EQ(choose_air({}, "exponential").atmosphere.model, DensityModel::exponential);
  for (const char* wrong : {"", "thin", "0", "-1.2", "nan", "1e9"}) {
    test::expect_refused(sim::InputFault::bad_configuration, {"--density", wrong, "kg/m3, exponential, isa"},
                         [&] { (void)choose_air(log, wrong); });
  }
}

}  // namespace
}  // namespace fantail::identify
