// SPDX-License-Identifier: MIT
#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "report/chart_drawer.hpp"
#include "report/figures.hpp"
#include "text/degrees.hpp"

namespace fantail::report {
namespace {

using page::Role;

/// Of the flight's verdicts on a canard the first that is not healthy.
std::array<std::string, core::canard_count> complaints(const flight::Flight& flight) {
  std::array<std::string, core::canard_count> all{};
  for (const auto& [time_s, canard, verdict] : flight.canard_verdict_changes) {
    if (verdict != core::CanardVerdict::healthy && all[canard].empty()) {
      all[canard] = core::name(verdict);
    }
  }
  return all;
}

RowValue deflection(const flight::Flight& flight, std::size_t canard) {
  return [canard, plan = flight.plan.canards.each[canard]](const flight::Row& row) {
    return row.encoders_rad[canard] ? text::degrees(deflection_rad(plan, *row.encoders_rad[canard])) : unknown_value;
  };
}

}  // namespace

page::Chart canards_together(const flight::Flight& flight, const ChartDrawer& drawer) {
  std::vector<page::Series> lines;
  if (flight.known.plan && flight.plan.excitation.form != core::ExcitationForm::none) {
    lines.push_back(drawer.line("excitation", Role::neutral, drawer.in_control(column("excitation_deg"))));
  }
  lines.push_back(drawer.line("command", Role::target, column("command_deg")));
  lines.push_back(drawer.line("encoder mean", Role::measured, column("canard_deg")));
  std::vector<RowValue> healthy;
  if (flight.known.plan) {  // else their trims are not known
    const auto wrong = complaints(flight);
    for (std::size_t i = 0; i < wrong.size(); ++i) {
      if (wrong[i].empty()) {
        healthy.push_back(deflection(flight, i));
      } else {
        lines.push_back(
            drawer.line(fmt::format("canard {} ({})", i + 1, wrong[i]), Role::second_model, deflection(flight, i)));
      }
    }
  }
  page::Chart chart = drawer.chart("Command and canards", "deg", page::full_page, flat_chart, std::move(lines));
  if (healthy.size() > 1) {
    chart.areas.push_back(
        drawer.band(healthy.size() == core::canard_count ? "all four, from trim" : "the others, from trim",
                    Role::measured, healthy));
  }
  return drawer.with_limits(std::move(chart));
}

std::vector<page::Chart> canards_alone(const ChartDrawer& drawer) {
  std::vector<page::Chart> all;
  for (std::size_t i = 1; i <= core::canard_count; ++i) {
    all.push_back(drawer.with_limits(
        drawer.chart(fmt::format("Canard {}", i), "deg", page::half_page, small_chart,
                     {drawer.line("command", Role::target, column(fmt::format("command_{}_deg", i))),
                      drawer.line("encoder", Role::measured, column(fmt::format("encoder_{}_deg", i)))})));
  }
  return all;
}

}  // namespace fantail::report
