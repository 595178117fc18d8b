// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "bench/axes.hpp"
#include "json/value.hpp"
#include "sim/units.hpp"
#include "text/degrees.hpp"
#include "text/number.hpp"

namespace fantail::bench {
namespace {

using text::degrees;
using text::fixed;

constexpr std::array<std::string_view, accelerometer_count> names{"IMU's accelerometer", "second accelerometer"};
constexpr std::array<std::string_view, accelerometer_count> keys{"imu", "second"};

std::string degrees_of(const Tilt& tilt) {
  return fmt::format("y {:>6}, z {:>6} deg", fixed(degrees(tilt.y_rad), 1), fixed(degrees(tilt.z_rad), 1));
}

json::Value value_of(const Tilt& tilt) {
  return {{"y_deg", json::rounded(degrees(tilt.y_rad), 3)}, {"z_deg", json::rounded(degrees(tilt.z_rad), 3)}};
}

json::Value in_g(const sim::Vector3& force_m_s2) {
  json::Value value = json::Value::array();
  for (const double axis : {force_m_s2.x, force_m_s2.y, force_m_s2.z}) {
    value.push_back(json::rounded(axis / sim::gravity_m_s2, 4));
  }
  return value;
}

}  // namespace

std::string axes_text(const AxesResult& result) {
  std::string text;
  for (std::size_t i = 0; i < accelerometer_count; ++i) {
    if (const auto& force_m_s2 = result.upright_m_s2[i]) {
      const auto g = [](double of) { return fixed(of / sim::gravity_m_s2, 2); };
      text += fmt::format("  {:<12} {:<21} x {:>6}, y {:>6}, z {:>6} g\n", "upright", names[i], g(force_m_s2->x),
                          g(force_m_s2->y), g(force_m_s2->z));
    }
  }
  text += fmt::format("  {:<12} {:<21} x {:>6}, y {:>6}, z {:>6} deg\n", "roll", "gyro",
                      fixed(degrees(result.roll_rad.x), 1), fixed(degrees(result.roll_rad.y), 1),
                      fixed(degrees(result.roll_rad.z), 1));
  for (std::size_t k = 0; k < result.tilts.size(); ++k) {
    const std::string_view name = k == 0 ? "tilt" : "tilt across";
    text += fmt::format("  {:<12} {:<21} {}\n", name, "gyro", degrees_of(result.tilts[k].gyro));
    for (std::size_t i = 0; i < accelerometer_count; ++i) {
      if (const auto& tilt = result.tilts[k].accelerometer[i]) {
        text += fmt::format("  {:<12} {:<21} {}\n", name, names[i], degrees_of(*tilt));
      }
    }
  }
  for (const std::string& sentence : result.sentences) {
    text += sentence + "\n";
  }
  if (!result.plan_lines.empty()) {
    text += fmt::format(
        "If the rocket was turned as instructed, these plan lines correct the mounting (checked with these turns). "
        "Send the plan with them, then turn the rocket again:\n{}",
        result.plan_lines);
  }
  return fmt::format("{}{}\n", text, unchecked_of_axes());
}

std::string axes_json(const AxesResult& seen, const result::Made& made) {
  json::Value upright{};
  json::Value tilts = json::Value::array();
  for (std::size_t i = 0; i < accelerometer_count; ++i) {
    if (seen.upright_m_s2[i]) {
      upright[std::string{keys[i]}] = in_g(*seen.upright_m_s2[i]);
    }
  }
  for (const TiltSeen& one : seen.tilts) {
    json::Value tilt = {{"gyro", value_of(one.gyro)}};
    for (std::size_t i = 0; i < accelerometer_count; ++i) {
      if (one.accelerometer[i]) {
        tilt[std::string{keys[i]}] = value_of(*one.accelerometer[i]);
      }
    }
    tilts.push_back(tilt);
  }
  json::Value all{{"right", seen.right},
                  {"upright_g", upright},
                  {"roll_seen_deg",
                   {{"x", json::rounded(degrees(seen.roll_rad.x), 3)},
                    {"y", json::rounded(degrees(seen.roll_rad.y), 3)},
                    {"z", json::rounded(degrees(seen.roll_rad.z), 3)}}},
                  {"tilts", tilts},
                  {"sentences", seen.sentences},
                  {"plan_lines", seen.plan_lines},
                  {"not_checked", std::string{unchecked_of_axes()}}};
  result::put_answer(all, seen.right ? result::Answer::yes : result::Answer::no,
                     fmt::format("{}", fmt::join(seen.sentences, " ")), made);
  return all.dump() + "\n";
}

}  // namespace fantail::bench
