// SPDX-License-Identifier: MIT
#include "flight/write_csv.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "flight/columns.hpp"

namespace fantail::flight {
namespace {

void write_number(std::string& out, double value) {
  if (std::isnan(value)) {
    return;  // unknown: an empty cell
  }
  const SixDecimals decimals{value};
  out += decimals.text();
}

void write_cell(std::string& out, const Column& column, const Row& row) {
  const double value = column.written(row);
  if (column.unit == Column::Unit::flag && !std::isnan(value)) {
    out.push_back(value != 0.0 ? '1' : '0');
  } else {
    write_number(out, value);
  }
}

}  // namespace

std::string csv(const Flight& flight) {
  const std::span<const Column> written = columns_of(flight);
  const bool marks = !std::ranges::all_of(flight.rows, &Row::replayed);
  const Column& time = written.front();
  std::string out;
  out.reserve((flight.rows.size() / flight.rows_per_line + 1) * 320);
  out.append(time.name).append(",").append(phase_column);
  for (const Column& column : written.subspan(1)) {
    out.append(",").append(column.name);
  }
  if (marks) {
    out.append(",").append(replayed_column);
  }
  out.push_back('\n');
  for (std::size_t i = 0; i < flight.rows.size(); i += flight.rows_per_line) {
    const Row& row = flight.rows[i];
    write_cell(out, time, row);
    out.append(",").append(core::name(row.phase));
    for (const Column& column : written.subspan(1)) {
      out.push_back(',');
      write_cell(out, column, row);
    }
    if (marks) {
      out.append(row.replayed ? ",1" : ",0");
    }
    out.push_back('\n');
  }
  return out;
}

std::string tunnel_csv(const Flight& flight) {
  std::string out = "time_s,fan_rpm,wind_speed_m_s\n";
  for (const TunnelReading& reading : flight.tunnel_readings) {
    write_number(out, reading.time_s);
    for (const double value : {reading.fan_rpm, reading.wind_speed_m_s}) {
      out.push_back(',');
      write_number(out, value);
    }
    out.push_back('\n');
  }
  return out;
}

}  // namespace fantail::flight
