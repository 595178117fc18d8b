// SPDX-License-Identifier: MIT
#include "report/phase_colors.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "flight/phase_names.hpp"

namespace fantail::report {

namespace {

struct PhaseColor {
  core::Phase phase;
  page::Role role;
};
constexpr std::array<PhaseColor, core::phases> colors{{{core::Phase::safe, page::Role::neutral},
                                                       {core::Phase::armed, page::Role::neutral},
                                                       {core::Phase::launched, page::Role::target},
                                                       {core::Phase::dormant, page::Role::waiting},
                                                       {core::Phase::controlling, page::Role::measured},
                                                       {core::Phase::finished, page::Role::neutral}}};

}  // namespace

page::Role color_of(core::Phase phase) { return std::ranges::find(colors, phase, &PhaseColor::phase)->role; }

std::vector<page::ShadedRange> phase_ranges(const flight::Flight& flight) {
  std::vector<page::ShadedRange> stripes;
  if (!flight.known.phase) {
    return stripes;
  }
  const flight::Row* before = nullptr;
  for (const flight::Row& row : flight.rows) {
    const bool is_after_outage =
        std::ranges::any_of(flight.outages, [&](const auto& outage) { return outage.to_s == row.time_s; });
    if (!stripes.empty() && (before->phase == row.phase || !is_after_outage)) {
      stripes.back().end = row.time_s;
    }
    if (before == nullptr || before->phase != row.phase) {
      stripes.push_back({row.time_s, row.time_s, flight::display_name(row.phase), color_of(row.phase)});
    }
    before = &row;
  }
  return stripes;
}

void shade_phases(page::Chart& chart, const flight::Flight& flight) {
  std::optional<page::Range> reach;
  for (const page::Series& series : chart.series) {
    std::ranges::for_each(series.x, [&](double x) { page::include(reach, x); });
  }
  if (!reach) {
    return;
  }
  chart.x_range = reach;
  for (page::ShadedRange& phase : chart.shaded_ranges = phase_ranges(flight)) {
    phase.begin = std::clamp(phase.begin, reach->low, reach->high);
    phase.end = std::clamp(phase.end, reach->low, reach->high);
  }
  std::erase_if(chart.shaded_ranges, [](const page::ShadedRange& phase) { return phase.end <= phase.begin; });
}

}  // namespace fantail::report
