// SPDX-License-Identifier: MIT
// Section 4.3.2: the second launch, which the tunnel had predicted.
#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/core.h>

#include "core/chirp.hpp"
#include "identify/identification.hpp"
#include "paper/paper_page.hpp"
#include "paper/recomputed.hpp"
#include "paper/runs.hpp"
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

// The wind turns the rocket, which takes six degrees of freedom.
Claim ground_wind(double calm_apogee_m, const Tell& tell) {
  const std::vector<input::Override> wind{{"flight", "motion", "\"six_dof\""}, {"wind", "speed_m_s", "3"}};
  const Run run = fly("tasha3_launch2", wind, tell);
  return unpublished("Section 4.3.2", "Wind on the ground", "3 m/s", "Neither its direction nor its height is printed.",
                     fmt::format("apogee {:.0f} m in six degrees of freedom with it, {:.0f} m straight up without",
                                 *report::figures(run.flight).apogee_m, calm_apogee_m));
}

void add_ascent(std::vector<Claim>& claims, const flight::Flight& flight, const report::Figures& figures) {
  const std::string motor = "With the motor and drag area of launch 1, which were fitted to both.";
  claims.push_back(compare(Numbers{.place = "Section 4.3.2",
                                   .what = "Apogee",
                                   .theirs = 422,
                                   .ours = *figures.apogee_m,
                                   .unit = "m",
                                   .decimals = 1,
                                   .tolerance = 0.02 * 422,
                                   .kind = Kind::fitted,
                                   .remark = motor}));
  claims.push_back(compare(Numbers{.place = "Section 4.3.2",
                                   .what = "Highest speed",
                                   .theirs = 81,
                                   .ours = *figures.max_speed_m_s,
                                   .unit = "m/s",
                                   .decimals = 1,
                                   .tolerance = 0.02 * 81,
                                   .kind = Kind::fitted,
                                   .remark = motor}));
  claims.push_back(compare(Numbers{
      .place = "Section 4.3.2, figure 27",
      .what = "Control starts, after lift-off: 2.4 \u2212 0.4 s on a clock that starts 1.5 s before it",
      .theirs = 2.4 - 0.4 - 1.5,
      .ours = *flight.events.control_start_s,
      .unit = "s",
      .decimals = 2,
      .tolerance = 0.1,
      .kind = Kind::fitted,
      .why_otherwise =
          fmt::format("The printed times are rounded to 0.1 s. To be 6 m up after 0.5 s takes {:.0f} m/s2 on average. "
                      "Launch 1, 0.5 kg lighter, was 7 m up after 0.63 s, which is {:.0f} m/s2.",
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

// Figure 27: how much the roll rate changes in the quarter second behind the second set point, and at most in any
// other one between the begin of control and that.
void add_second_set_point(std::vector<Claim>& claims, const flight::Flight& flight) {
  const double step_s = *flight.events.control_start_s + 2.0;
  double before_deg_s = 0.0;
  double after_deg_s = 0.0;
  double at_step_deg_s = 0.0;
  for (const flight::Row& row : flight.rows) {
    const double after_step_s = row.time_s - step_s;
    if (!row.truth || after_step_s < -0.5 || after_step_s > 0.25) {
      continue;
    }
    const double rate_deg_s = true_rate_deg_s(row);
    if (after_step_s < 0.0) {
      before_deg_s = std::max(before_deg_s, std::abs(rate_deg_s));
      at_step_deg_s = rate_deg_s;
    } else {
      after_deg_s = std::max(after_deg_s, std::abs(rate_deg_s - at_step_deg_s));
    }
  }
  claims.push_back(
      compare(InWords{.place = "Section 4.3.2, figure 27",
                      .what = "The roll rate at the second set point",
                      .theirs = "a sharp change",
                      .ours = fmt::format("{:.0f} deg/s within 0.25 s; below {:.0f} deg/s in the half second before",
                                          after_deg_s, before_deg_s),
                      .holds = after_deg_s > 2.0 * before_deg_s,
                      .why = "With the gains of the tunnel; the chirp is nearly at rest at that time."}));
}

void add_windows(std::vector<Claim>& claims, const identify::result::Identification& first,
                 const identify::result::Identification& second) {
  const std::string log = "The flight's log is not published.";
  const auto pair = [](const identify::model::RollModel& model) {
    return fmt::format("{:g} and {:g}", model.alpha_m2, model.beta_m);
  };
  claims.push_back(compare(InWords{.place = "Eq 47",
                                   .what = "Damping and torque constant, first window",
                                   .theirs = "23.0 and 9.0",
                                   .ours = pair(first.model),
                                   .holds = first.model.alpha_m2 == 23.0 && first.model.beta_m == 9.0,
                                   .kind = Kind::read_back,
                                   .why = "Our flight was made with them."}));
  claims.push_back(unpublished("Eq 50, section 4.3.2", "Damping and torque constant, second window",
                               "23.0 and 9.0; in the text a larger damping, and 8", log,
                               pair(second.model) + " in our flight, made with 23 and 9"));
  claims.push_back(compare(Numbers{.place = "Section 4.3.2, figure 29",
                                   .what = "Mean offset of the first window, printed without its sign",
                                   .theirs = -4.9,
                                   .ours = text::degrees(first.model.node_rad.front()),
                                   .unit = "deg",
                                   .tolerance = 0.05,
                                   .kind = Kind::read_back,
                                   .remark = "Our flight was made with it, constant."}));
  claims.push_back(unpublished("Section 4.3.2, figure 31", "Mean offset of the second window", "\u22124.7 deg", log,
                               text::with_minus(fmt::format("{:.2f} deg in our flight, made with \u22124.9",
                                                            text::degrees(second.model.node_rad.front())))));
}

}  // namespace

Chapter second_launch_chapter(const Tell& tell) {
  const Run run = fly("tasha3_launch2", {}, tell);
  const flight::Flight& flight = run.flight;
  Chapter chapter{.title = "Launch 2",
                  .introduction =
                      "Tasha III, 4 December 2015. Canards limited to 9 degrees, 0 degrees held, then \u221220 from 2 "
                      "s after control start, with a chirp that makes the damping identifiable. The gains are not "
                      "printed; those of the tunnel are taken.",
                  .claims = {},
                  .figures_html = {}};
  std::vector<Claim>& claims = chapter.claims;
  add_ascent(claims, flight, report::figures(flight));
  add_second_set_point(claims, flight);
  claims.push_back(ground_wind(*report::figures(flight).apogee_m, tell));

  tell("identifying launch 2");
  const double zero_s = *flight.events.control_start_s;
  const auto record_of = [&](const Windowed& window) {
    return true_record(run, zero_s + window.from_s, zero_s + window.to_s, 0.01);
  };
  const identify::model::Record first = record_of(first_window);
  const identify::model::Airframe rocket = airframe(run.scenario);
  const identify::result::Identification open = identify::identify(
      first, rocket, {.nodes = identify::EvenNodes{first_window.intervals}, .method = identify::result::Method::grid});
  const identify::model::Record second = record_of(second_window);
  const identify::result::Identification later = identify::identify(
      second, rocket,
      {.nodes = identify::EvenNodes{second_window.intervals}, .method = identify::result::Method::grid});

  add_windows(claims, open, later);
  std::ranges::move(offset_intervals(first, run), std::back_inserter(claims));
  const std::string over = "Over that wave, which was fitted to the first window; the real flight had other effects.";
  claims.push_back(errors_over_a_wave({.place = "Eq 48 and 49, figure 28",
                                       .what = "Mean absolute errors of angle and rate, first window",
                                       .angle_deg = 0.26,
                                       .rate_deg_s = 4.10,
                                       .why = over},
                                      first, run, first_window.intervals));
  claims.push_back(errors_over_a_wave({.place = "Eq 51 and 52, figure 30",
                                       .what = "The same, second window, with two intervals",
                                       .angle_deg = 0.99,
                                       .rate_deg_s = 8.32,
                                       .why = over + " The real offset of this window varied less."},
                                      second, run, second_window.intervals));

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
