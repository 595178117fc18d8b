// SPDX-License-Identifier: MIT
#include "files/quantities.hpp"

#include <algorithm>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "files/sources.hpp"
#include "flight/columns.hpp"

namespace fantail::files {
namespace {

TEST(Units, AreThoseOfTheTables) {
  EXPECT_DOUBLE_EQ(find_unit("rpm")->si, std::numbers::pi / 30.0);
  EXPECT_DOUBLE_EQ(find_unit("turn/s")->si, 2.0 * std::numbers::pi);
  EXPECT_DOUBLE_EQ(find_unit("km/h")->si * 36.0, 10.0);
  EXPECT_DOUBLE_EQ(find_unit("ft")->si, 0.3048);
  EXPECT_DOUBLE_EQ(find_unit("g")->si, 9.80665);
  EXPECT_DOUBLE_EQ(59.0 * find_unit("degF")->si + find_unit("degF")->offset, 288.15);
  EXPECT_EQ(find_unit("furlong"), nullptr);
  EXPECT_EQ(unit_names(Dimension::time), "s, ms, us, ns, min, h");
  EXPECT_EQ(plainly_spelt("kg/m\u00b3"), "kg/m3");
  EXPECT_EQ(plainly_spelt("\xB0"), "deg") << "Latin-1";
}

TEST(Quantities, EveryColumnOfAFlightIsOneInItsOwnUnit) {
  std::vector<Quantity> in_order{Quantity::phase};
  for (const flight::Column& column : flight::columns()) {
    const KnownQuantity* const found = of_own_column(column.name.substr(column.is_true ? 5 : 0));
    ASSERT_NE(found, nullptr) << column.name;
    EXPECT_EQ(found->dimension.has_value(), column.unit != flight::Column::Unit::flag) << column.name;
    EXPECT_EQ(column.unit == flight::Column::Unit::degrees,
              found->dimension == Dimension::angle || found->dimension == Dimension::angular_rate)
        << column.name;
    if (!column.is_true) {
      in_order.push_back(found->quantity);
    }
  }
  EXPECT_TRUE(std::ranges::is_permutation(in_order, of_flight_csv));
  EXPECT_EQ(of_own_column("rol_angle_deg"), nullptr);
  EXPECT_EQ(of_own_column(""), nullptr);
}

TEST(Quantities, HaveAWordForASentence) {
  EXPECT_EQ(word(Quantity::height_above_the_sea), "height above the sea");
  for (const KnownQuantity& one : known_quantities()) {
    EXPECT_EQ(known(one.quantity).quantity, one.quantity) << one.name;
  }
}

TEST(Quantities, OfAnExportHaveADimension) {
  for (const ExportedColumn& column : exported_columns()) {
    EXPECT_TRUE(known(column.quantity).dimension) << column.name;
  }
}

constexpr std::array heard{Quantity::time,      Quantity::axial,     Quantity::lateral_y,
                           Quantity::lateral_z, Quantity::roll_rate, Quantity::pitch_rate,
                           Quantity::yaw_rate,  Quantity::height,    Quantity::speed};

TEST(Loggers, HaveReadableColumnsOfWhichTimeAndAxialForceAloneAreNeeded) {
  for (const Logger& logger : loggers()) {
    const Sources sources = sources_of(logger, heard);
    for (const Source& source : sources) {
      EXPECT_EQ(source.must_be_there, source.quantity == Quantity::time || source.quantity == Quantity::axial)
          << logger.name << " " << source.column;
    }
    EXPECT_EQ(find(sources, Quantity::axial) != nullptr, has_axial(logger)) << logger.name;
    EXPECT_NE(find(sources, Quantity::time), nullptr) << logger.name;
    EXPECT_EQ(find_logger(logger.name), &logger);
  }
  EXPECT_EQ(find_logger("altus"), nullptr);
}

TEST(Loggers, AreKnownByTheirColumns) {
  const auto known_by = [](std::vector<std::string> columns) {
    const Logger* const logger = logger_of(columns);
    return logger == nullptr ? std::string{} : std::string{logger->name};
  };
  EXPECT_EQ(known_by({"version", "serial", "flight", "call", "time", "state", "acceleration"}), "altos");
  EXPECT_EQ(known_by({"ts", "id", "Ax", "Ay", "Az", "Gx", "Gy", "Gz"}), "cats");
  EXPECT_EQ(known_by({"", "ts", "id", "Gx", "Gy", "Gz", "Ax", "Ay", "Az"}), "cats_logs") << "in g";
  EXPECT_EQ(known_by({"timestamp", "gyro_rad[0]", "accelerometer_m_s2[0]"}), "px4");
  EXPECT_EQ(known_by({"time_s", "phase", "specific_force_m_s2"}), "fantail");
  EXPECT_EQ(known_by({"ts", "Ax", "Ay", "Az"}), "");
  EXPECT_EQ(known_by({"version", "serial", "flight", "time", "pressure", "height"}), "altos_barometer");
  EXPECT_EQ(known_by({"Flight_Time_(s)", "Accel_X", "Accel_Y", "Accel_Z", "Gyro_X", "Gyro_Y"}), "blueraven");
  EXPECT_EQ(known_by({"MET", "Acc", "Vel", "iAlt", "pAlt"}), "arts2");
}

TEST(Loggers, WithoutAnAccelerometerAreNamedWithTheUseOfTheirHeight) {
  const auto use = [](std::vector<std::string> columns) { return use_without_axial(columns); };
  const std::string eggtimer = use({"T", "Alt", "Veloc", "LDA"});
  EXPECT_NE(eggtimer.find("Eggtimer"), std::string::npos) << eggtimer;
  const std::size_t columns = eggtimer.find("--barometer-columns ");
  ASSERT_NE(columns, std::string::npos) << eggtimer;
  const Sources advised = parse_columns(eggtimer.substr(columns + 20), "--barometer-columns", heard);
  EXPECT_NE(find(advised, Quantity::height), nullptr) << "the advice is one that the option takes";
  EXPECT_NE(use({"Time (s)", "Altitude (ft)", "Vertical velocity (ft/s)"}).find("--trajectory"), std::string::npos);
  EXPECT_NE(use({"# Zeit (s)", "Zeit (s)", "Höhe (m)", "Vertikalgeschwindigkeit (m/s)"}).find("--trajectory"),
            std::string::npos);
  EXPECT_NE(use({"MET", "Acc(HI)", "Acc/Baro(LO)", "Baro(HI)", "State"}).find("interpreted"), std::string::npos);
  EXPECT_EQ(use({"time", "ALT", "HORZV"}), "");
  EXPECT_EQ(use({"version", "serial", "flight", "time", "acceleration"}), "") << "has one";
}

// x to the nose, y and z right-handed: of an IMU whose y axis points down, +y is its x axis and +z its z axis.
TEST(Loggers, OfCatsTurnTheSensorsAxesTogether) {
  const Sources sources = sources_of(*find_logger("cats"), heard);
  const auto of = [&](Quantity quantity) { return find(sources, quantity)->column.substr(1); };
  const auto sign = [&](Quantity quantity) { return find(sources, quantity)->factor > 0.0; };
  for (const auto& [force, rate] :
       {std::pair{Quantity::axial, Quantity::roll_rate}, std::pair{Quantity::lateral_y, Quantity::pitch_rate},
        std::pair{Quantity::lateral_z, Quantity::yaw_rate}}) {
    EXPECT_EQ(of(force), of(rate));
    EXPECT_EQ(sign(force), sign(rate));
  }
}

// AltosUI writes the same names for a computer without an accelerometer; without a radio there is no callsign.
TEST(Loggers, OfAltOsWithoutAnAccelerometerAreKnownByTheirColumns) {
  const std::vector<std::string> mini{"version", "serial", "flight", "time", "acceleration", "height"};
  ASSERT_NE(logger_of(mini), nullptr);
  EXPECT_EQ(logger_of(mini)->name, "easymini");
  EXPECT_NE(logger_of(mini)->doubt, "");
  for (const char* more : {"call", "accel_x"}) {
    std::vector<std::string> other = mini;
    other.emplace_back(more);
    EXPECT_EQ(logger_of(other)->name, "altos") << more;
    EXPECT_EQ(logger_of(other)->doubt, "");
  }
}

}  // namespace
}  // namespace fantail::files
