// SPDX-License-Identifier: MIT
#include "listen/columns.hpp"

#include <numbers>

#include <gtest/gtest.h>

#include "listen/maps.hpp"
#include "listen/refused.hpp"

namespace fantail::listen {
namespace {

using text::ErrorKind;

TEST(Columns, HaveASignAScaleAndAUnit) {
  const Sources sources =
      parse_columns("time=ts:ms,axial=-Ay:g,roll_rate=0.5*gyro x:rpm,height=-2*alt:ft", "--columns");
  ASSERT_EQ(sources.size(), 4U);
  EXPECT_EQ(find(sources, Quantity::time)->column, "ts");
  EXPECT_DOUBLE_EQ(find(sources, Quantity::time)->factor, 1e-3);
  EXPECT_EQ(find(sources, Quantity::axial)->column, "Ay");
  EXPECT_DOUBLE_EQ(find(sources, Quantity::axial)->factor, -9.80665);
  EXPECT_EQ(find(sources, Quantity::roll_rate)->column, "gyro x");
  EXPECT_DOUBLE_EQ(find(sources, Quantity::roll_rate)->factor, 0.5 * 2.0 * std::numbers::pi / 60.0);
  EXPECT_DOUBLE_EQ(find(sources, Quantity::height)->factor, -2.0 * 0.3048);
  EXPECT_EQ(find(sources, Quantity::speed), nullptr);
}

TEST(Columns, OfANameWithColonsHaveTheUnitBehindTheLast) {
  EXPECT_EQ(find(parse_columns("axial=imu:0:x:m/s2", "--columns"), Quantity::axial)->column, "imu:0:x");
}

TEST(Columns, WhoseZeroIsThePadSaySo) {
  const Sources sources = parse_columns("axial_from_rest=a:m/s2,second_axial=b:g", "--columns");
  EXPECT_TRUE(find(sources, Quantity::axial)->from_rest);
  EXPECT_FALSE(find(sources, Quantity::second_axial)->from_rest);
}

TEST(Columns, AreRefusedWithWhatIsAllowed) {
  const auto refused = [](const std::string& text, const std::vector<std::string>& parts) {
    expect_refusal(ErrorKind::bad_configuration, parts, [&] { (void)parse_columns(text, "--columns"); });
  };
  refused("axail=a:g", {"--columns axail=a:g", "did you mean axial?", "roll_rate"});
  refused("axial=a", {"unit is missing", "a:m/s2", "g, ft/s2"});
  refused("axial=a:rad/s", {"\"rad/s\" is no unit of axial", "m/s2, g"});
  refused("time=t:s,axial", {"expected QUANTITY=COLUMN:UNIT"});
  refused("time=t:s,", {"expected QUANTITY=COLUMN:UNIT"});
  refused("axial=x*a:g", {"\"x\" is no scale", "0.5*a"});
  refused("axial=0*a:g", {"no scale"});
  refused("axial=-:g", {"name of the column is missing"});
  refused("axial=a:g,axial_from_rest=b:g", {"axial appears twice"});
}

TEST(Columns, OfTwoListsTheFirstGoesBefore) {
  const Sources both = merged(parse_columns("axial=a:g", "x"), parse_columns("axial_from_rest=b:g,height=h:m", "x"));
  ASSERT_EQ(both.size(), 2U);
  EXPECT_EQ(find(both, Quantity::axial)->column, "a");
  EXPECT_EQ(find(both, Quantity::height)->column, "h");
}

TEST(Maps, AreReadableAndNeedTimeAndAxialForceOnly) {
  for (const Map& map : maps()) {
    const Sources sources = sources_of(map);
    for (const Source& source : sources) {
      EXPECT_EQ(source.must_be_there, source.quantity == Quantity::time || source.quantity == Quantity::axial)
          << map.name << " " << source.column;
    }
    EXPECT_NE(find(sources, Quantity::axial), nullptr) << map.name;
    EXPECT_EQ(find_map(map.name), &map);
  }
  EXPECT_EQ(find_map("altus"), nullptr);
}

TEST(Maps, AreKnownByTheirColumns) {
  const auto known = [](std::vector<std::string> columns) {
    const Map* const map = map_of(columns);
    return map == nullptr ? std::string{} : std::string{map->name};
  };
  EXPECT_EQ(known({"version", "serial", "flight", "call", "time", "state", "acceleration"}), "altos");
  EXPECT_EQ(known({"ts", "id", "Ax", "Ay", "Az", "Gx", "Gy", "Gz"}), "cats");
  EXPECT_EQ(known({"timestamp", "gyro_rad[0]", "accelerometer_m_s2[0]"}), "px4");
  EXPECT_EQ(known({"time_s", "phase", "specific_force_m_s2"}), "fantail");
  EXPECT_EQ(known({"ts", "Ax", "Ay", "Az"}), "");
}

// x to the nose, y and z right-handed: of an IMU whose y axis points down, +y is its x axis and +z its z axis.
TEST(Maps, OfCatsTurnTheSensorsAxesTogether) {
  const Sources sources = sources_of(*find_map("cats"));
  const auto of = [&](Quantity quantity) { return find(sources, quantity)->column.substr(1); };
  const auto sign = [&](Quantity quantity) { return find(sources, quantity)->factor > 0.0; };
  for (const auto& [force, rate] :
       {std::pair{Quantity::axial, Quantity::roll_rate}, std::pair{Quantity::lateral_y, Quantity::pitch_rate},
        std::pair{Quantity::lateral_z, Quantity::yaw_rate}}) {
    EXPECT_EQ(of(force), of(rate));
    EXPECT_EQ(sign(force), sign(rate));
  }
}

}  // namespace
}  // namespace fantail::listen
