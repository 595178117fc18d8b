// SPDX-License-Identifier: MIT
// Any bytes as a MAT-file, a Parquet file or an exported trajectory: columns of equal length, or refused with a
// sentence.
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "chosen_input.hpp"
#include "input/scenario_file.hpp"
#include "table_file/mat_writer.hpp"
#include "table_file/parquet_writer.hpp"
#include "table_file/read.hpp"
#include "trajectory/trajectory.hpp"

namespace fantail::fuzz {
namespace {

constexpr std::string_view trajectory_csv =
    "# Time (s),Altitude (m),Vertical velocity (m/s)\n-0.1,0,0\n0,0,0\n0.5,5,20\n1,20,40\n2,55,30\n4,95,10\n"
    "5,100,0\n6,95,-10\n";

void check(const table_file::Columns& columns) {
  require(!columns.empty());
  for (const table_file::Column& column : columns) {
    require(column.values.size() == columns.front().values.size());
  }
}

// The first byte chooses what the rest is.
void read(std::uint8_t choice, std::string bytes) {
  switch (choice % 3) {
    case 0:
      check(table_file::read_mat(bytes, "x.mat", [](std::string_view name) {
        return name == "time_s" ? std::optional<std::string>{"s"} : std::nullopt;
      }));
      return;
    case 1: check(table_file::read_parquet(bytes, "x.parquet")); return;
    default: {
      static const sim::Scenario scenario = input::load_scenario("tasha3_launch2", {});
      const trajectory::Trajectory read = trajectory::parse_trajectory(std::move(bytes), "x.csv", scenario);
      require(std::ranges::all_of(read.notes, is_sentence));
    }
  }
}

}  // namespace

std::vector<std::string> seeds() {
  const table_file::Columns columns{{.name = "time_s", .values = std::vector<double>{0.0, 0.5, 1.0}},
                                    {.name = "roll_angle_deg", .values = std::vector<double>{1.0, -2.0, 1e9}}};
  return {std::string{'\0'} + table_file::mat::file(
                                  std::vector{table_file::mat::column(std::vector<double>{0.0, 0.5, 1.0}, "time_s"),
                                              table_file::mat::column(std::vector<double>{1.0, 2.0, 3.0}, "phi_deg")}),
          std::string{'\1'} + table_file::parquet::file(columns, "seed"), std::string{'\2'}.append(trajectory_csv)};
}

}  // namespace fantail::fuzz

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer calls it so
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return fantail::fuzz::read_chosen(data, size, fantail::fuzz::read);
}
