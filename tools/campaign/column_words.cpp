// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <utility>

#include "campaign/results.hpp"

namespace fantail::campaign {
namespace {

bool take_end(std::string& name, std::string_view end) {
  if (name.size() <= end.size() || !name.ends_with(end)) {
    return false;
  }
  name.resize(name.size() - end.size());
  return true;
}

std::string take_unit(std::string& name) {
  // One that ends as another does stands before it.
  constexpr auto units = std::to_array<std::pair<std::string_view, std::string_view>>({
      {"_n_m_per_rad", "N m/rad"},
      {"_calibres", "calibres"},
      {"_kg_m3", "kg/m3"},
      {"_kg_m2", "kg m2"},
      {"_n_m_s", "N m s"},
      {"_deg_s", "deg/s"},
      {"_m_s2", "m/s2"},
      {"_rpms", "rpm"},
      {"_m_s", "m/s"},
      {"_n_m", "N m"},
      {"_deg", "deg"},
      {"_rpm", "rpm"},
      {"_kg", "kg"},
      {"_m3", "m3"},
      {"_m2", "m2"},
      {"_hz", "Hz"},
      {"_us", "us"},
      {"_g", "g"},
      {"_m", "m"},
      {"_s", "s"},
  });
  for (const auto& [end, unit] : units) {
    if (take_end(name, end)) {
      return std::string{unit};
    }
  }
  return {};
}

}  // namespace

ColumnWords column_words(std::string_view column) {
  std::string name{column};
  const bool is_factor = take_end(name, "_factor");
  const bool is_offset = !is_factor && take_end(name, "_offset");
  std::string unit = take_unit(name);
  std::ranges::replace(name, '_', ' ');
  if (const std::size_t dot = name.find('.'); dot != std::string::npos) {
    name.replace(dot, 1, ": ");
  }
  if (is_factor) {
    return {.words = name + ", factor", .unit = {}};
  }
  return {.words = name + (is_offset ? ", added" : ""), .unit = std::move(unit)};
}

std::string outcome_words(std::string outcome) {
  std::ranges::replace(outcome, '_', ' ');
  return outcome;
}

}  // namespace fantail::campaign
