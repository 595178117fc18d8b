// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

#include <fmt/core.h>

#include "files/load.hpp"
#include "files/rows.hpp"
#include "flight/table.hpp"
#include "flight_log/flight_log.hpp"
#include "text/error.hpp"
#include "text/number.hpp"
#include "tunnel/statistics.hpp"
#include "tunnel/swing.hpp"

namespace fantail::tunnel {
namespace {

constexpr std::size_t fewest_rows = 50;

double in_seconds(core::Microseconds time) { return 1e-6 * static_cast<double>(time.count()); }

/// The two rates across the rocket as one: along the direction in which most of them lies.
std::vector<double> along_the_swing(std::vector<double> y, std::vector<double> z) {
  const double mean_y = mean(y);
  const double mean_z = mean(z);
  double yy = 0.0;
  double yz = 0.0;
  double zz = 0.0;
  for (std::size_t i = 0; i < y.size(); ++i) {
    y[i] -= mean_y;
    z[i] -= mean_z;
    yy += y[i] * y[i];
    yz += y[i] * z[i];
    zz += z[i] * z[i];
  }
  const double direction = 0.5 * std::atan2(2.0 * yz, yy - zz);
  for (std::size_t i = 0; i < y.size(); ++i) {
    y[i] = std::cos(direction) * y[i] + std::sin(direction) * z[i];
  }
  return y;
}

SwingLog of_flight_log(const std::filesystem::path& path) {
  const flight_log::LogFile file = flight_log::read_log_file(path);
  const flight_log::Flight& flight = file.flights.front();
  SwingLog log{.name = path.string(), .is_rate = true};
  if (file.flights.size() > 1) {
    log.remarks.push_back(fmt::format("The log contains {} records; this is the first.", file.flights.size()));
  }
  std::optional<core::Microseconds> zero;
  for (const protocol::LogEvent& event : flight.events) {
    if (!zero && event.kind == protocol::LogEventKind::phase &&
        event.value == static_cast<std::uint8_t>(core::Phase::controlling)) {
      zero = event.time;
    }
  }
  const double scale = static_cast<double>(flight.rate_scale_rad_s);
  std::vector<double> y;
  std::vector<double> z;
  core::Microseconds before{-1};
  for (const flight_log::LoggedTick& logged : flight.ticks) {
    const protocol::LogTick& tick = logged.tick;
    if (tick.imu_status != protocol::DeviceStatus::ok || tick.imu_time <= before) {
      continue;
    }
    before = tick.imu_time;
    log.time_s.push_back(in_seconds(tick.imu_time - zero.value_or(core::Microseconds{0})));
    y.push_back(scale * tick.rate_counts[1]);
    z.push_back(scale * tick.rate_counts[2]);
  }
  if (log.time_s.size() < fewest_rows) {
    text::refuse(fmt::format("{}: only {} of the gyro; allowed: {} or more", log.name,
                             text::counted(log.time_s.size(), "sample"), fewest_rows));
  }
  log.value = along_the_swing(std::move(y), std::move(z));
  return log;
}

SwingLog of_table(const std::filesystem::path& path) {
  const flight::Table table = files::load(path, files::Beside::ftl).table;
  const bool is_rate = table.find(files::known(files::Quantity::pitch_rate).column).has_value();
  if (!is_rate && !table.find(files::known(files::Quantity::pitch).column)) {
    text::refuse(fmt::format("{}: neither a column pitch_rate_deg_s nor pitch_deg", path.string()));
  }
  std::vector<files::Found> found;
  for (const auto quantity : {files::Quantity::time, is_rate ? files::Quantity::pitch_rate : files::Quantity::pitch}) {
    found.push_back(files::find_column(table, {}, quantity, ""));
    found.back().needed = true;
  }
  files::Rows rows = files::read_rows(table, found, {.most_left_out = 1.0});
  SwingLog log{.name = path.string(),
               .is_rate = is_rate,
               .time_s = std::move(rows.values[0]),
               .value = std::move(rows.values[1]),
               .remarks = std::move(rows.notes)};
  if (log.time_s.size() < fewest_rows) {
    text::refuse(fmt::format("{}: only {} with time and pitch; allowed: {} or more", log.name,
                             text::counted(log.time_s.size(), "row"), fewest_rows));
  }
  return log;
}

void add_angle(SwingLog& log) {
  std::vector<double> sorted = log.value;
  std::ranges::nth_element(sorted, sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2));
  const double bias = sorted[sorted.size() / 2];
  double angle_rad = 0.0;
  for (std::size_t i = 0; i < log.value.size(); ++i) {
    if (!log.is_rate) {
      angle_rad = log.value[i] - log.value.front();
    } else if (i > 0) {
      angle_rad += (log.time_s[i] - log.time_s[i - 1]) * (0.5 * (log.value[i] + log.value[i - 1]) - bias);
    }
    log.angle_rad.push_back(angle_rad);
  }
}

}  // namespace

SwingLog read_swing_log(const std::filesystem::path& path) {
  std::error_code ignored;
  const bool is_flight_log = std::filesystem::is_directory(path, ignored) || path.extension() == ".ftl";
  SwingLog log = is_flight_log ? of_flight_log(path) : of_table(path);
  add_angle(log);
  return log;
}

SwingLog averaged(const SwingLog& log, double bin_s) {
  SwingLog result{.name = log.name, .is_rate = log.is_rate, .remarks = log.remarks};
  for (std::size_t i = 0; i < log.time_s.size();) {
    constexpr double rounding = 1e-6;  // a time on the edge of two bins belongs to the second
    const double end_s = (std::floor(log.time_s[i] / bin_s + rounding) + 1.0 - rounding) * bin_s;
    double time_s = 0.0;
    double value = 0.0;
    std::size_t count = 0;
    result.angle_rad.push_back(log.angle_rad[i]);
    for (; i < log.time_s.size() && (count == 0 || log.time_s[i] < end_s); ++i, ++count) {
      time_s += log.time_s[i];
      value += log.value[i];
    }
    result.time_s.push_back(time_s / static_cast<double>(count));
    result.value.push_back(value / static_cast<double>(count));
  }
  return result;
}

}  // namespace fantail::tunnel
