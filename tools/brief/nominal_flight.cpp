// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <utility>

#include "brief/brief.hpp"
#include "campaign/flown_run.hpp"
#include "flight/model_end.hpp"
#include "flight/phase_names.hpp"
#include "report/verdict.hpp"
#include "text/error.hpp"

namespace fantail::brief {
namespace {

double speed_m_s(const flight::PathPoint& at) { return std::hypot(at.north_m_s, at.east_m_s, at.up_m_s); }

/// The first row with an event. Its speed is over ground where the flight has a path, between two of its points, which
/// are ten ticks apart.
class FirstRow {
 public:
  void look(bool has_come, const flight::Row& row, const std::vector<flight::PathPoint>& path) {
    if (has_come && !moment_) {
      moment_ = Moment{.time_s = row.time_s, .height_m = row.truth->height_m, .speed_m_s = row.truth->speed_m_s};
      before_ = path.empty() ? std::nullopt : std::optional{path.back()};
    } else if (before_ && path.back().time_s > before_->time_s) {
      moment_->speed_m_s = std::lerp(speed_m_s(*before_), speed_m_s(path.back()),
                                     (moment_->time_s - before_->time_s) / (path.back().time_s - before_->time_s));
      before_.reset();
    }
  }
  [[nodiscard]] std::optional<Moment> moment(const flight::Flight& flight) const {
    std::optional<Moment> found = moment_;
    if (found) {
      found->time_s = flight.clock(found->time_s);
    }
    return found;
  }

 private:
  std::optional<Moment> moment_{};
  std::optional<flight::PathPoint> before_{};  ///< while the next one is waited for
};

std::optional<ControlEnd> control_end(const flight::Flight& flight) {
  constexpr double seen_s = 0.05;  // the avionics detect apogee a few hundredths before or after it
  const auto& [end_s, apogee_s] = std::pair{flight.events.control_end_s, flight.events.apogee_s};
  const auto change = std::ranges::find(flight.phase_changes, end_s, &flight::PhaseChange::time_s);
  if (!flight.events.control_start_s || change == flight.phase_changes.end() || !change->reason || !apogee_s ||
      *apogee_s - *end_s < seen_s) {
    return std::nullopt;
  }
  return ControlEnd{.time_s = *end_s,
                    .before_apogee_s = *apogee_s - *end_s,
                    .why = std::string{flight::display_name(*change->reason)}};
}

}  // namespace

NominalFlight fly_nominal(const sim::Scenario& scenario) {
  FirstRow off_guide;
  FirstRow in_control;
  const campaign::JudgedFlight flown =
      campaign::fly_and_judge(scenario, [&](const flight::Row& row, const flight::Flight& so_far) {
        off_guide.look(so_far.events.guide_clear_s.has_value(), row, so_far.path);
        in_control.look(so_far.events.control_start_s.has_value(), row, so_far.path);
      });
  const auto guide_exit = off_guide.moment(flown.flight);
  const flight::Events& events = flown.flight.events;
  if (!guide_exit || !events.apogee_s || !flown.figures.apogee_m || !flown.figures.max_speed_m_s) {
    throw text::Error{text::ErrorKind::bad_configuration,
                      scenario.name + ": the rocket does not leave its guide, or it does not reach an apogee"};
  }
  return {.apogee_m = *flown.figures.apogee_m,
          .top_speed_m_s = *flown.figures.max_speed_m_s,
          .guide_exit = *guide_exit,
          .control_start = in_control.moment(flown.flight),
          .control_end = control_end(flown.flight),
          .was_armed = flown.flight.why_not_armed.empty(),
          .was_dormant = events.dormant_s.has_value(),
          .burns_at_control_start =
              events.control_start_s && (!events.burnout_s || *events.control_start_s < *events.burnout_s),
          .roll = std::string{report::display_name(flown.verdict.outcome)},
          .ascent_failed = flown.verdict.outcome == report::Outcome::ascent_failed,
          .beyond_model = flight::how_far_beyond(flown.flight.extremes)};
}

}  // namespace fantail::brief
