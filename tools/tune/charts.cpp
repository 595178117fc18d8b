// SPDX-License-Identifier: MIT
#include <limits>

#include <fmt/core.h>

#include "page/chart.hpp"
#include "report/figures.hpp"
#include "text/degrees.hpp"
#include "text/number.hpp"
#include "tune/results.hpp"

namespace fantail::tune {
namespace {

using page::Role;
using text::brief;
using text::degrees;

constexpr const char* old_name = "old plan";
constexpr const char* new_name = "new plan";

page::Series series(const char* name, Role role) { return {.name = name, .role = role}; }

template <typename ValueOf>
page::Series over_speed(const Judged& judged, const char* name, Role role, ValueOf value_of) {
  page::Series line = series(name, role);
  for (const LoopAtSpeed& at : judged.loop) {
    line.x.push_back(at.speed_m_s);
    line.y.push_back(value_of(at));
  }
  return line;
}

template <typename ValueOf>
page::Series over_time(const flight::Flight& flight, const char* name, Role role, ValueOf value_of) {
  page::Series line = series(name, role);
  for (const flight::Row& row : flight.rows) {
    if (row.phase == core::Phase::controlling) {
      line.x.push_back(row.time_s);
      line.y.push_back(degrees(value_of(row)));
    }
  }
  return line;
}

}  // namespace

std::vector<result::Block> loop_pictures(const Tuning& t) {
  const auto margin = [](const LoopAtSpeed& at) { return degrees(at.least_phase_margin_rad); };
  const auto bandwidth = [](const LoopAtSpeed& at) {
    return at.crossover_rad_s.value_or(std::numeric_limits<double>::quiet_NaN());
  };
  const double asked_deg = degrees(t.request.phase_margin_rad);
  const page::Chart margins{.label = "Least phase margin over air speed, by both plans",
                            .x_label = "air speed / (m/s)",
                            .y_label = "phase margin / deg",
                            .width = page::half_page,
                            .series = {over_speed(t.before, old_name, Role::measured, margin),
                                       over_speed(*t.after, new_name, Role::model, margin)},
                            .levels = {{.value = asked_deg,
                                        .label = fmt::format("{} degrees asked for", brief(asked_deg, 1)),
                                        .role = Role::limit}}};
  const page::Chart bandwidths{.label = "Crossover over air speed, by both plans",
                               .x_label = "air speed / (m/s)",
                               .y_label = "crossover / (rad/s)",
                               .width = page::half_page,
                               .series = {over_speed(t.before, old_name, Role::measured, bandwidth),
                                          over_speed(*t.after, new_name, Role::model, bandwidth)}};
  return {
      result::Picture{margins, "How far the linear loop is from oscillating: the least of the spread at each speed."},
      result::Picture{bandwidths, "The bandwidth: where the loop's gain is one, for the vehicle as it is."}};
}

std::vector<result::Block> step_pictures(const Tuning& t) {
  const auto roll_of = [](const flight::Flight& flight) {
    return [zero_rad = report::true_zero_rad(flight)](const flight::Row& row) {
      return row.truth->roll_angle_rad - zero_rad;
    };
  };
  const auto command = [](const flight::Row& row) { return row.command_rad; };
  page::Series reference = over_time(t.after->flight, "reference", Role::reference,
                                     [](const flight::Row& row) { return row.reference_rad; });
  reference.mark = page::Mark::step;
  const page::Chart angles{
      .label = "Roll angle over time, by both plans",
      .x_label = "time after lift-off / s",
      .y_label = "roll angle / deg",
      .series = {over_time(t.before.flight, old_name, Role::measured, roll_of(t.before.flight)),
                 over_time(t.after->flight, new_name, Role::model, roll_of(t.after->flight)), reference}};
  const page::Chart commands{.label = "Canard command over time, by both plans",
                             .x_label = "time after lift-off / s",
                             .y_label = "command / deg",
                             .series = {over_time(t.before.flight, old_name, Role::measured, command),
                                        over_time(t.after->flight, new_name, Role::model, command)}};
  return {result::Picture{angles, "The vehicle as it is, flown by both plans without excitation."},
          result::Picture{commands, "What the law asked of the canards."}};
}

}  // namespace fantail::tune
