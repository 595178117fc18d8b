// SPDX-License-Identifier: MIT
#include <cmath>

#include "brief/brief.hpp"
#include "campaign/flown_run.hpp"
#include "flight/model_end.hpp"
#include "report/verdict.hpp"
#include "text/error.hpp"

namespace fantail::brief {
namespace {

/// Over ground where the flight has a path.
double speed_m_s(const flight::PathPoint& at) { return std::hypot(at.north_m_s, at.east_m_s, at.up_m_s); }

/// Points of a path are ten ticks apart; without a path the row has it.
double speed_at(const std::vector<flight::PathPoint>& path, const Moment& moment) {
  const flight::PathPoint* before = flight::point_at(path, moment.time_s);
  if (before == nullptr || before == &path.back()) {
    return before == nullptr ? moment.speed_m_s : speed_m_s(*before);
  }
  const flight::PathPoint& after = *(before + 1);
  return std::lerp(speed_m_s(*before), speed_m_s(after),
                   (moment.time_s - before->time_s) / (after.time_s - before->time_s));
}

Moment moment(const flight::Row& row) {
  return {.time_s = row.time_s, .height_m = row.truth->height_m, .speed_m_s = row.truth->speed_m_s};
}

}  // namespace

NominalFlight fly_nominal(const sim::Scenario& scenario) {
  std::optional<Moment> guide_exit;
  std::optional<Moment> control_start;
  const campaign::JudgedFlight flown =
      campaign::fly_and_judge(scenario, [&](const flight::Row& row, const flight::Flight& so_far) {
        if (so_far.events.guide_clear_s && !guide_exit) {
          guide_exit = moment(row);
        }
        if (so_far.events.control_start_s && !control_start) {
          control_start = moment(row);
        }
      });
  const flight::Events& events = flown.flight.events;
  if (!guide_exit || !events.apogee_s || !flown.figures.apogee_m || !flown.figures.max_speed_m_s) {
    throw text::Error{text::ErrorKind::bad_configuration,
                      scenario.name + ": the rocket does not leave its guide, or it does not reach an apogee"};
  }
  for (std::optional<Moment>* one : {&guide_exit, &control_start}) {
    if (*one) {
      (*one)->speed_m_s = speed_at(flown.flight.path, **one);
      (*one)->time_s = flown.flight.clock((*one)->time_s);
    }
  }
  return {.apogee_m = *flown.figures.apogee_m,
          .top_speed_m_s = *flown.figures.max_speed_m_s,
          .guide_exit = *guide_exit,
          .control_start = control_start,
          .was_armed = flown.flight.why_not_armed.empty(),
          .was_dormant = events.dormant_s.has_value(),
          .burns_at_control_start =
              events.control_start_s && (!events.burnout_s || *events.control_start_s < *events.burnout_s),
          .roll = std::string{report::display_name(flown.verdict.outcome)},
          .ascent_failed = flown.verdict.outcome == report::Outcome::ascent_failed,
          .beyond_model = flight::how_far_beyond(flown.flight.extremes)};
}

}  // namespace fantail::brief
