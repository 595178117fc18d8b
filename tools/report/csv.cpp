// SPDX-License-Identifier: MIT
#include "report/csv.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

#include "report/numbers.hpp"
#include "report/six_decimals.hpp"

namespace fantail::report {
namespace {

constexpr std::string_view measured_columns =
    "time_s,phase,roll_angle_deg,roll_rate_deg_s,reference_deg,excitation_deg,command_deg,saturated,"
    "command_1_deg,command_2_deg,command_3_deg,command_4_deg,encoder_1_deg,encoder_2_deg,encoder_3_deg,encoder_4_deg,"
    "canard_deg,specific_force_m_s2,height_m,speed_m_s";
constexpr std::string_view true_columns =
    ",true_roll_angle_deg,true_roll_rate_deg_s,true_canard_deg,true_height_m,true_speed_m_s,true_disturbance_deg";

class Line {
 public:
  explicit Line(std::string& out) : out_{out} {}

  void number(double value) {
    if (std::isnan(value)) {
      return;  // unknown: an empty cell
    }
    const SixDecimals decimals{value};
    out_ += decimals.text();
  }
  void cell(double value) {
    out_.push_back(',');
    number(value);
  }
  void angle(double radians) { cell(degrees(radians)); }
  void angle(const std::optional<double>& radians) {
    if (radians) {
      angle(*radians);
    } else {
      out_.push_back(',');
    }
  }
  void text(std::string_view value) {
    out_.push_back(',');
    out_ += value;
  }
  void flag(bool value) { text(value ? "1" : "0"); }
  void end() { out_.push_back('\n'); }

 private:
  std::string& out_;
};

void write_row(Line line, const Row& row, bool with_truth) {
  line.number(row.time_s);
  line.text(core::name(row.phase));
  line.angle(row.roll_angle_rad);
  line.angle(row.roll_rate_rad_s);
  line.angle(row.reference_rad);
  line.angle(row.excitation_rad);
  line.angle(row.command_rad);
  line.flag(row.saturated);
  std::ranges::for_each(row.commands_rad, [&](const auto& a) { line.angle(a); });
  std::ranges::for_each(row.encoders_rad, [&](const auto& a) { line.angle(a); });
  line.angle(row.canard_rad);
  line.cell(row.specific_force_m_s2);
  line.cell(row.height_m);
  line.cell(row.speed_m_s);
  if (with_truth && row.truth) {
    line.angle(row.truth->roll_angle_rad);
    line.angle(row.truth->roll_rate_rad_s);
    line.angle(row.truth->canard_rad);
    line.cell(row.truth->height_m);
    line.cell(row.truth->speed_m_s);
    line.angle(row.truth->disturbance_rad);
  } else if (with_truth) {
    line.text(",,,,,");
  }
  line.end();
}

}  // namespace

std::string csv(const Flight& flight) {
  const bool with_truth = std::ranges::any_of(flight.rows, [](const Row& row) { return row.truth.has_value(); });
  std::string out;
  out.reserve((flight.rows.size() + 1) * 320);
  out += measured_columns;
  if (with_truth) {
    out += true_columns;
  }
  out.push_back('\n');
  for (const Row& row : flight.rows) {
    write_row(Line{out}, row, with_truth);
  }
  return out;
}

std::string tunnel_csv(const Flight& flight) {
  std::string out;
  out += "time_s,fan_rpm,wind_speed_m_s\n";
  for (const TunnelReading& reading : flight.tunnel_readings) {
    Line line{out};
    line.number(reading.time_s);
    line.cell(reading.fan_rpm);
    line.cell(reading.wind_speed_m_s);
    line.end();
  }
  return out;
}

}  // namespace fantail::report
