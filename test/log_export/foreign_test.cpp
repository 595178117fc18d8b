// SPDX-License-Identifier: MIT
#include <bit>

#include <gtest/gtest.h>

#include "json/value.hpp"
#include "log_export/formats.hpp"
#include "protocol/little_endian.hpp"

namespace fantail::log_export {
namespace {

// Two ticks of a version that never was: a count, three bits, and a float.
flight_log::Flight foreign_flight() {
  flight_log::Flight flight;
  flight.schema = "tick 8\n0 i16 pressure Pa\n2 u16:1.3 stage\n4 f32 tilt rad\n";
  for (int i = 0; i < 2; ++i) {
    std::vector<std::byte> payload(8);
    protocol::put<2>(payload, 0, static_cast<std::uint16_t>(-100 - i));
    protocol::put<2>(payload, 2, 5U << 1U);
    protocol::put<4>(payload, 4, std::bit_cast<std::uint32_t>(0.25F));
    flight.foreign_ticks.push_back({.sequence = static_cast<std::uint32_t>(7 + i),
                                    .time = core::Microseconds{2'000'000 + 1000 * i},
                                    .payload = payload});
  }
  return flight;
}

TEST(ForeignExport, ColumnsAreThoseOfTheLogsOwnSchema) {
  EXPECT_EQ(foreign_fields(foreign_flight()),
            (std::vector<std::string>{"time_s", "time_us", "sequence", "pressure_Pa", "stage", "tilt_rad"}));
  EXPECT_TRUE(foreign_fields({}).empty());
}

TEST(ForeignExport, ValuesAreReadAsTheSchemaSays) {
  const flight_log::Flight flight = foreign_flight();
  EXPECT_EQ(foreign_csv(flight, foreign_fields(flight), {}),
            "time_s,time_us,sequence,pressure_Pa,stage,tilt_rad\n"
            "0.000000,2000000,7,-100,5,0.25\n"
            "0.001000,2001000,8,-101,5,0.25\n");
}

TEST(ForeignExport, UnitsBesideTheTableAreThoseOfTheLogsOwnSchema) {
  const flight_log::Flight flight = foreign_flight();
  const json::Value columns =
      json::parse(foreign_columns_json(flight, foreign_csv(flight, foreign_fields(flight), {})));
  std::string units;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    units += columns[i]["unit"].text() + " ";
    EXPECT_FALSE(columns[i]["description"].text().empty()) << i;
  }
  EXPECT_EQ(units, "s us - Pa - rad ");
}

TEST(ForeignExport, AWindowAndAChoiceHold) {
  const std::vector<std::string> names{"stage", "time_us"};
  EXPECT_EQ(foreign_csv(foreign_flight(), names, {.from_s = 0.0005}), "stage,time_us\n5,2001000\n");
}

TEST(ForeignExport, ARecordThatIsTooShortHasEmptyCells) {
  flight_log::Flight flight = foreign_flight();
  flight.foreign_ticks[0].payload.resize(4);
  const std::vector<std::string> names{"stage", "tilt_rad"};
  EXPECT_EQ(foreign_csv(flight, names, {}), "stage,tilt_rad\n5,\n5,0.25\n");
}

}  // namespace
}  // namespace fantail::log_export
