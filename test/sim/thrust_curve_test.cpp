// SPDX-License-Identifier: MIT

#include "sim/thrust_curve.hpp"

#include "sim/atmosphere.hpp"
#include "sim/compressibility.hpp"
#include "sim/drag_over_mach.hpp"
#include "sim/local_density.hpp"
#include "sim/monotone_curve.hpp"
#include "test.hpp"

namespace fantail::sim {
namespace {

// Two triangles and a plateau: every figure can be done in the head.
ThrustCurve plateau() { return {{{0.0, 0.0}, {1.0, 100.0}, {3.0, 100.0}, {3.5, 0.0}}, 0.2}; }

TEST(ThrustCurve, ImpulseIsTheAreaUnderTheLines) {
  EXPECT_DOUBLE_EQ(plateau().impulse_n_s(), 50.0 + 200.0 + 25.0);
  EXPECT_DOUBLE_EQ(plateau().propellant_kg(), 0.2);
  EXPECT_DOUBLE_EQ(plateau().burnout_s(), 3.5);
}

TEST(ThrustCurve, ThrustRunsStraightBetweenPointsAndIsZeroOutside) {
  const ThrustCurve motor = plateau();
  EXPECT_EQ(motor.thrust_n(-0.1), 0.0);
  EXPECT_EQ(motor.thrust_n(0.0), 0.0);
  EXPECT_DOUBLE_EQ(motor.thrust_n(0.25), 25.0);
  EXPECT_DOUBLE_EQ(motor.thrust_n(1.0), 100.0);
  EXPECT_DOUBLE_EQ(motor.thrust_n(2.9), 100.0);
  EXPECT_DOUBLE_EQ(motor.thrust_n(3.25), 50.0);
  EXPECT_EQ(motor.thrust_n(3.5), 0.0);
  EXPECT_EQ(motor.thrust_n(100.0), 0.0);
}

TEST(ThrustCurve, ImpulseSoFarIsTheExactIntegral) {
  const ThrustCurve motor = plateau();
  EXPECT_EQ(motor.impulse_until(-1.0), 0.0);
  EXPECT_DOUBLE_EQ(motor.impulse_until(0.5), 12.5);  // 1/2 100 t^2
  EXPECT_DOUBLE_EQ(motor.impulse_until(1.0), 50.0);
  EXPECT_DOUBLE_EQ(motor.impulse_until(2.5), 200.0);
  EXPECT_DOUBLE_EQ(motor.impulse_until(3.25), 250.0 + 18.75);
  EXPECT_DOUBLE_EQ(motor.impulse_until(3.5), 275.0);
  EXPECT_DOUBLE_EQ(motor.impulse_until(9.0), 275.0);
}

TEST(ThrustCurve, MayStartAtFullThrust) {
  const ThrustCurve motor{{{0.0, 40.0}, {2.0, 40.0}, {2.001, 0.0}}, 0.1};
  EXPECT_EQ(motor.thrust_n(-1e-9), 0.0);
  EXPECT_EQ(motor.thrust_n(0.0), 40.0);
}

TEST(ThrustCurve, NoMotorGivesNothing) {
  const ThrustCurve none;
  EXPECT_EQ(none.thrust_n(0.0), 0.0);
  EXPECT_EQ(none.impulse_until(5.0), 0.0);
  EXPECT_EQ(none.impulse_n_s(), 0.0);
}

TEST(ThrustCurve, RefusesPointsThatCannotBeAMotor) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  const std::vector<std::vector<ThrustPoint>> impossible{
      {},
      {{0.0, 0.0}},
      {{0.0, 10.0}, {1.0, 10.0}, {0.5, 0.0}},  // back in time
      {{0.0, 10.0}, {1.0, 10.0}, {1.0, 0.0}},  // two thrusts at once
      {{-0.1, 10.0}, {1.0, 0.0}},
      {{0.0, 10.0}, {1.0, -5.0}, {2.0, 0.0}},
      {{0.0, 10.0}, {nan, 5.0}, {2.0, 0.0}},
      {{0.0, 10.0}, {1.0, nan}, {2.0, 0.0}},
      {{0.0, 10.0}, {1.0, infinity}, {2.0, 0.0}},
      {{0.0, 10.0}, {1.0, 5.0}},  // never ends
      {{0.0, 0.0}, {1.0, 0.0}},   // never burns
      {{0.0, 1e308}, {1e10, 1e308}, {2e10, 0.0}},
  };
  for (std::size_t i = 0; i < impossible.size(); ++i) {
    EXPECT_THROW((ThrustCurve{impossible[i], 0.1}), std::invalid_argument) << "case " << i;
  }
  for (const double propellant_kg : {0.0, -0.1, nan, infinity}) {
    EXPECT_THROW((ThrustCurve{{{0.0, 10.0}, {1.0, 0.0}}, propellant_kg}), std::invalid_argument) << propellant_kg;
  }
}

TEST(MonotoneCurve, GoesThroughItsPointsAndIsConstantBeyondThem) {
  const MonotoneCurve curve{{0.0, 0.5, 2.0}, {1.0, 3.0, -2.0}};
  EXPECT_DOUBLE_EQ(curve.at(0.0).value, 1.0);
  EXPECT_DOUBLE_EQ(curve.at(0.5).value, 3.0);
  EXPECT_DOUBLE_EQ(curve.at(2.0).value, -2.0);
  EXPECT_DOUBLE_EQ(curve.at(-7.0).value, 1.0);
  EXPECT_DOUBLE_EQ(curve.at(9.0).value, -2.0);
  EXPECT_DOUBLE_EQ(curve.at(9.0).slope_per_s, 0.0);
}

TEST(MonotoneCurve, OfAStraightLineIsThatLine) {
  const MonotoneCurve curve{{0.0, 0.1, 0.7, 1.0}, {2.0, 2.5, 5.5, 7.0}};
  for (const double t : {0.03, 0.1, 0.4, 0.99}) {
    EXPECT_NEAR(curve.at(t).value, 2.0 + 5.0 * t, 1e-12);
    EXPECT_NEAR(curve.at(t).slope_per_s, 5.0, 1e-12);
    EXPECT_NEAR(curve.at(t).curvature_per_s2, 0.0, 1e-9);
  }
}

TEST(MonotoneCurve, HasNoHumpThatItsPointsDoNotHaveAndNoJumpInItsSlope) {
  const MonotoneCurve curve{{0.0, 1.0, 2.0, 3.0, 4.0}, {0.0, 0.0, 0.0, 10.0, 10.0}};
  double before = curve.at(0.0).slope_per_s;
  for (double t = 0.0; t < 4.0; t += 1e-3) {
    const MonotoneCurve::Here here = curve.at(t);
    EXPECT_GE(here.value, 0.0);
    EXPECT_LE(here.value, 10.0);
    EXPECT_NEAR(here.slope_per_s, before, 0.1) << t;  // a cubic from 0 to 10 within a second bends by 60 a second
    before = here.slope_per_s;
  }
}

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

TEST(Compressibility, IsThePrandtlGlauertFactorUpToMach08AndIsHeldAbove) {
  const auto factor = [](double mach) { return compressibility_factor(Compressibility::prandtl_glauert, mach); };
  EXPECT_EQ(factor(0.0), 1.0);
  EXPECT_NEAR(factor(0.5), 2.0 / std::sqrt(3.0), 1e-15);
  EXPECT_NEAR(factor(-0.5), 2.0 / std::sqrt(3.0), 1e-15);
  EXPECT_NEAR(factor(0.6), 1.25, 1e-15);
  EXPECT_NEAR(factor(0.8), 5.0 / 3.0, 1e-15);
  for (const double mach : {0.81, 1.0, 3.0, -1.0}) {
    EXPECT_EQ(factor(mach), factor(0.8)) << mach;
  }
}

TEST(Compressibility, IsOneWhereThereIsNone) { EXPECT_EQ(compressibility_factor(Compressibility::none, 0.7), 1.0); }

TEST(DragOverMach, IsLinearBetweenItsPointsAndHeldAtItsEnds) {
  const DragOverMach drag{.mach = {0.3, 0.8, 1.0}, .factor = {1.0, 1.2, 2.0}};
  EXPECT_EQ(drag.at(0.0), 1.0);
  EXPECT_EQ(drag.at(0.3), 1.0);
  EXPECT_NEAR(drag.at(0.55), 1.1, 1e-15);
  EXPECT_NEAR(drag.at(0.95), 1.8, 1e-15);
  EXPECT_EQ(drag.at(0.8), 1.2);
  EXPECT_EQ(drag.at(1.0), 2.0);
  EXPECT_EQ(drag.at(5.0), 2.0);
}

TEST(DragOverMach, OfOnePointIsAFactorAndOfNoneIsOne) {
  EXPECT_EQ((DragOverMach{.mach = {0.5}, .factor = {1.3}}).at(0.1), 1.3);
  EXPECT_EQ((DragOverMach{.mach = {0.5}, .factor = {1.3}}).at(0.9), 1.3);
  EXPECT_EQ(DragOverMach{}.at(0.9), 1.0);
  EXPECT_FALSE(DragOverMach{}.is_there());
}

}  // namespace

}  // namespace fantail::sim
