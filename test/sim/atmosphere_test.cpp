// SPDX-License-Identifier: MIT
#include "sim/atmosphere.hpp"

#include <gtest/gtest.h>

#include "sim/local_density.hpp"

namespace fantail::sim {
namespace {

TEST(Atmosphere, ExponentialFallsByAFactorEEvery8500Metres) {
  const Atmosphere exponential{};
  EXPECT_DOUBLE_EQ(exponential.density_kg_m3(0.0), 1.225);
  EXPECT_NEAR(exponential.density_kg_m3(8500.0), 1.225 / 2.718281828459045, 1e-15);
  EXPECT_NEAR(exponential.density_kg_m3(500.0), 1.15502, 1e-5);
}

TEST(Atmosphere, StandardAtmosphereGivesTheTableOfIso2533) {
  const Atmosphere isa{.model = DensityModel::isa};
  EXPECT_NEAR(isa.density_kg_m3(0.0), 1.2250, 5e-5);
  EXPECT_NEAR(isa.density_kg_m3(1000.0), 1.11164, 5e-6);
  EXPECT_NEAR(isa.density_kg_m3(5000.0), 0.736116, 5e-6);
  EXPECT_NEAR(isa.density_kg_m3(11000.0), 0.363918, 5e-6);
  EXPECT_NEAR(isa.density_kg_m3(15000.0), 0.193674, 5e-6);
  EXPECT_NEAR(isa.density_kg_m3(20000.0), 0.0880349, 5e-6);
}

TEST(Atmosphere, StandardAtmosphereHasNoJumpAtTheTropopause) {
  const Atmosphere isa{.model = DensityModel::isa};
  EXPECT_NEAR(isa.density_kg_m3(11000.0 - 1e-6), isa.density_kg_m3(11000.0 + 1e-6), 1e-9);
}

TEST(Atmosphere, SoundIsAsFastAsInTheTableOfIso2533WhateverTheDensity) {
  for (const DensityModel model : {DensityModel::exponential, DensityModel::isa, DensityModel::constant}) {
    const Atmosphere atmosphere{.model = model};
    EXPECT_NEAR(atmosphere.speed_of_sound_m_s(0.0), 340.294, 5e-4);
    EXPECT_NEAR(atmosphere.speed_of_sound_m_s(5000.0), 320.529, 5e-4);
    EXPECT_NEAR(atmosphere.speed_of_sound_m_s(11000.0), 295.069, 2e-3);
    EXPECT_EQ(atmosphere.speed_of_sound_m_s(11000.0), atmosphere.speed_of_sound_m_s(15000.0));
  }
  const Atmosphere high{.elevation_m = 2000.0};
  EXPECT_NEAR(high.speed_of_sound_m_s(3000.0), 320.529, 5e-4);
}

TEST(Atmosphere, ConstantIsTheSameEverywhere) {
  const Atmosphere constant{.model = DensityModel::constant, .constant_kg_m3 = 1.1};
  EXPECT_EQ(constant.density_kg_m3(0.0), 1.1);
  EXPECT_EQ(constant.density_kg_m3(9000.0), 1.1);
}

TEST(LocalDensity, IsTheAtmosphereWhateverTheWayThere) {
  for (const DensityModel model : {DensityModel::exponential, DensityModel::isa, DensityModel::constant}) {
    const Atmosphere atmosphere{.model = model};
    LocalDensity up{atmosphere};
    LocalDensity down{atmosphere};
    for (int i = 0; i <= 16000; ++i) {
      const double height_m = i * 0.987 - 30.0;
      const double expected = atmosphere.density_kg_m3(height_m);
      ASSERT_NEAR(up.at(height_m), expected, 1e-12 * expected) << height_m;
    }
    for (int i = 16000; i >= 0; i -= 7) {
      const double height_m = i * 0.987 - 30.0;
      LocalDensity jump{atmosphere};
      ASSERT_EQ(down.at(height_m), jump.at(height_m)) << height_m;
    }
  }
}

}  // namespace
}  // namespace fantail::sim
