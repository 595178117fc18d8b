// SPDX-License-Identifier: MIT
#include "logs/one_flight.hpp"

#include <cstddef>
#include <fstream>
#include <iterator>
#include <optional>
#include <span>
#include <string>

#include <fmt/core.h>

#include "report/summary_json.hpp"
#include "text/error.hpp"
#include "text/number.hpp"
#include "text/sha256.hpp"

namespace fantail::logs {
namespace {

// Times in a table may be written with three decimals.
constexpr double rounding_s = 0.002;

[[noreturn]] void refuse(const std::filesystem::path& folder, const std::string& difference) {
  throw text::Error{
      text::ErrorKind::bad_data,
      fmt::format("{}: its files are of two flights: {}; put those of each into a folder of its own, or take "
                  "summary.json away",
                  folder.string(), difference)};
}

}  // namespace

void expect_log_of_summary(const std::filesystem::path& folder) {
  const std::optional<std::string> said = report::summary_log_sha256(folder / "summary.json");
  std::ifstream stream{folder / "flight.ftl", std::ios::binary};
  if (!said || !stream) {
    return;
  }
  const std::string bytes{std::istreambuf_iterator<char>{stream}, {}};
  if (text::sha256(std::as_bytes(std::span{bytes})) != *said) {
    refuse(folder, "flight.ftl has not the SHA-256 that summary.json gives as log_sha256");
  }
}

void expect_rows_of_summary(const std::vector<flight::Row>& rows, const std::filesystem::path& folder) {
  const std::optional<double> said_s = report::summary_events(folder / "summary.json").control_start_s;
  if (!said_s) {
    return;
  }
  std::optional<double> begin_s;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    if (rows[i].phase != core::Phase::controlling || rows[i - 1].phase == core::Phase::controlling) {
      continue;
    }
    begin_s = rows[i].time_s;
    if (*said_s > rows[i - 1].time_s - rounding_s && *said_s < rows[i].time_s + rounding_s) {
      return;
    }
  }
  if (begin_s) {
    refuse(folder, fmt::format("the rows of flight.csv come under control at {} s, and by summary.json control starts "
                               "at {} s",
                               text::fixed(*begin_s, 3), text::fixed(*said_s, 3)));
  }
}

}  // namespace fantail::logs
