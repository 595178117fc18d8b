// SPDX-License-Identifier: MIT
// Section 4.3.2: the second launch, which the tunnel had predicted.
#include <array>
#include <cmath>

#include <fmt/core.h>

#include "core/chirp.hpp"
#include "identify/identification.hpp"
#include "paper/chapters.hpp"
#include "paper/drawing.hpp"
#include "report/results.hpp"
#include "text/degrees.hpp"
#include "text/number.hpp"

namespace fantail::paper {
namespace {

struct Windowed {
  double from_s;  ///< after control start
  double to_s;
  std::size_t intervals;
};

// The first ends with the step to -20 degrees; the second with the excitation.
constexpr Windowed first_window{.from_s = 0.4, .to_s = 2.0, .intervals = 4};
constexpr Windowed second_window{.from_s = 2.0, .to_s = 7.0, .intervals = 2};

void add_ascent(std::vector<Claim>& claims, const flight::Flight& flight, const report::Figures& figures) {
  const std::string motor = "With the motor and drag area of launch 1, which were fitted to both.";
  claims.push_back(compare({.place = "Section 4.3.2",
                            .what = "Apogee",
                            .theirs = 422,
                            .ours = *figures.apogee_m,
                            .unit = "m",
                            .decimals = 1,
                            .tolerance = 0.02 * 422,
                            .basis = Basis::fitted,
                            .remark = motor}));
  claims.push_back(compare({.place = "Section 4.3.2",
                            .what = "Highest speed",
                            .theirs = 81,
                            .ours = *figures.max_speed_m_s,
                            .unit = "m/s",
                            .decimals = 1,
                            .tolerance = 0.02 * 81,
                            .basis = Basis::fitted,
                            .remark = motor}));
  claims.push_back(compare(
      {.place = "Section 4.3.2, figure 27",
       .what = "Control starts, after lift-off: 2.4 \u2212 0.4 s on a clock that starts 1.5 s before it",
       .theirs = 2.4 - 0.4 - 1.5,
       .ours = *flight.events.control_start_s,
       .unit = "s",
       .decimals = 2,
       .tolerance = 0.1,
       .basis = Basis::fitted,
       .why_otherwise = fmt::format(
           "The printed times are rounded to 0.1 s. To be 6 m up after 0.5 s takes {:.0f} m/s2 on average; launch "
           "1 was 7 m up after 0.63 s, {:.0f} m/s2, with a rocket that was 0.5 kg lighter.",
           2.0 * 6.0 / (0.5 * 0.5), 2.0 * 7.0 / (0.63 * 0.63))}));
}

// Figure 26: the published chirp by itself.
page::Series chirp_curve(const core::ExcitationPlan& plan) {
  core::Chirp chirp{plan};
  page::Series series{.name = "excitation", .role = page::Role::measured, .mark = page::Mark::line, .x = {}, .y = {}};
  for (int ms = 0; ms <= 7500; ms += 2) {
    series.x.push_back(1e-3 * ms);
    series.y.push_back(static_cast<double>(chirp.update(core::Microseconds{1000 * ms}).degrees()));
  }
  return series;
}

std::string curve_over_nodes(const std::vector<identify::result::NodeTrial>& trials) {
  std::string text;
  for (const identify::result::NodeTrial& trial : trials) {
    text += (text.empty() ? "" : ", ") + text::fixed(text::degrees(trial.mean_abs_angle_error_rad), 2);
  }
  return text + " deg";
}

}  // namespace

Chapter second_launch_chapter(const Tell& tell) {
  const Run run = fly("tasha3_launch2", {}, tell);
  const flight::Flight& flight = run.flight;
  Chapter chapter{.title = "Launch 2",
                  .introduction =
                      "Tasha III, 4 December 2015: canards limited to 9 degrees, 0 degrees held, then \u221220 from "
                      "2 s after control start, with a chirp that makes the damping identifiable. The gains are "
                      "not printed; those of the tunnel are taken.",
                  .claims = {},
                  .figures_html = {}};
  std::vector<Claim>& claims = chapter.claims;
  add_ascent(claims, flight, report::figures(flight));

  tell("identifying launch 2");
  const double zero_s = *flight.events.control_start_s;
  const auto record_of = [&](const Windowed& window) {
    return true_record(run, zero_s + window.from_s, zero_s + window.to_s, 0.01);
  };
  const identify::model::Record first = record_of(first_window);
  const identify::model::Airframe rocket = airframe(run.scenario);
  const identify::result::Identification over_nodes =
      identify::identify(first, rocket, {.nodes = identify::AutomaticNodes{6}, .with_error_map = false});
  const identify::result::Identification open = identify::identify(
      first, rocket, {.nodes = identify::EvenNodes{first_window.intervals}, .method = identify::result::Method::grid});
  const identify::model::Record second = record_of(second_window);
  const identify::result::Identification later = identify::identify(
      second, rocket,
      {.nodes = identify::EvenNodes{second_window.intervals}, .method = identify::result::Method::grid});

  const auto found = [](const identify::model::RollModel& model) {
    return fmt::format("our flight was made with 23 and 9; the published search finds {:g} and {:g} in it",
                       model.alpha_m2, model.beta_m);
  };
  claims.push_back(unpublished("Eq 47", "Damping and torque constant, first window", "23.0 and 9.0",
                               "The flight's log is not published.", found(open.model)));
  claims.push_back(unpublished("Section 4.3.2", "Torque constant, second window", "8 (printed 9.0)",
                               "The flight's log is not published.", found(later.model)));
  claims.push_back(unpublished(
      "Section 4.3.2", "Mean angle error over one to six disturbance intervals, first window",
      "2.36, 2.15, 0.57, 0.26 deg, then no better",
      "The curve's shape is that of the real disturbance. Ours is constant, so one interval is enough for it.",
      curve_over_nodes(over_nodes.node_trials)));
  claims.push_back(unpublished("Section 4.3.2", "Mean absolute errors of rate and angle, both windows",
                               "4.10 deg/s, 0.26 deg; 8.32 deg/s, 0.99 deg",
                               "They measure what the model leaves out of a real flight."));
  claims.push_back(
      unpublished("Figures 29 and 31", "Mean offset of the windows", "\u22124.9 and \u22124.7 deg",
                  "The flight's log is not published.",
                  fmt::format("planted \u22124.9, found {} and {} deg",
                              text::with_minus(text::fixed(text::degrees(open.model.node_rad.front()), 2)),
                              text::with_minus(text::fixed(text::degrees(later.model.node_rad.front()), 2)))));

  const auto figure = [&](const page::Chart& chart, const std::string& caption) {
    chapter.figures_html.push_back(half_width_figure(chart, caption));
  };
  figure({.label = "Excitation",
          .x_label = "time after control start / s",
          .y_label = "excitation / deg",
          .series = {chirp_curve(run.scenario.plan.excitation)}},
         "As figure 26, without the unpublished variations: product form, on from 0.4 to 7 s. Its frequency falls to "
         "zero at "
         "2.5 s and rises to 18 Hz.");
  const Stretch flown{.zero_s = zero_s, .from_s = zero_s - 0.5, .to_s = zero_s + 8.0};
  figure({.label = "Roll rate of launch 2",
          .x_label = "time after control start / s",
          .y_label = "roll rate / deg/s",
          .series = {curve(run, flown, "simulated", page::Role::measured, true_rate_deg_s)}},
         "As figure 27.");
  const auto both = [&](const identify::model::Record& record, const identify::result::Identification& model,
                        double offset_s, const std::string& caption) {
    std::vector<double> time_s = record.time_s;
    for (double& t : time_s) {
      t += offset_s;
    }
    figure(
        {.label = "Roll angle and model",
         .x_label = "time after control start / s",
         .y_label = "roll angle / deg",
         .series = {curve(time_s, text::in_degrees(record.roll_angle_rad), "simulated flight", page::Role::measured),
                    curve(time_s, text::in_degrees(model.simulation.roll_angle_rad), "identified", page::Role::model)}},
        caption);
  };
  both(first, open, first_window.from_s, "As figure 28a: the first window and its model.");
  both(second, later, second_window.from_s, "As figure 30a: the second window and its model.");
  return chapter;
}

}  // namespace fantail::paper
