// SPDX-License-Identifier: MIT
// Section 4.3.1 and Table 2: eight steps of 45 degrees in the wind tunnel, each identified by itself.
#include <cmath>

#include <fmt/core.h>

#include "identify/closed_loop/closed_loop.hpp"
#include "identify/identification.hpp"
#include "input/scenario_file.hpp"
#include "paper/chapters.hpp"
#include "paper/drawing.hpp"
#include "paper/published_steps.hpp"
#include "sim/units.hpp"
#include "text/degrees.hpp"
#include "text/number.hpp"

namespace fantail::paper {
namespace {

using sim::radians_per_degree;

constexpr double step_s = 5.0;

struct Repeated {
  identify::model::Record record;
  identify::result::Identification found;
};

// The step that a row of the table describes, flown by the real controller without noise and servo lag, and identified
// from its log at 100 Hz as the published ones were.
Repeated repeat(const PublishedStep& row, const sim::Scenario& tunnel) {
  identify::model::Record record;
  record.window = "step " + std::to_string(row.step);
  for (int i = 0; i <= static_cast<int>(step_s * 100.0); ++i) {
    record.time_s.push_back(0.01 * i);
  }
  const std::size_t samples = record.size();
  record.roll_angle_rad.assign(samples, 0.0);
  record.roll_rate_rad_s.assign(samples, 0.0);
  record.canard_rad.assign(samples, 0.0);
  record.speed_m_s.assign(samples, 22.0);
  record.density_kg_m3.assign(samples, tunnel.tunnel.density_kg_m3);
  record.reference_rad.assign(samples, 45.0 * radians_per_degree);
  record.excitation_rad.assign(samples, 0.0);
  record.in_control.assign(samples, true);
  const identify::model::RollModel truth{
      .alpha_m2 = row.alpha_m2,
      .beta_m = row.beta_m,
      .node_time_s = {0.0, step_s},
      .node_rad = {row.disturbance_begin_deg * radians_per_degree, row.disturbance_end_deg * radians_per_degree},
      .initial = {{.angle_rad = 0.0, .rate_rad_s = 0.0}}};
  const identify::model::Airframe rocket = airframe(tunnel);
  const identify::model::Simulation flown =
      identify::closed_loop::simulate(record, rocket, {.controller = tunnel.plan.controller}, truth);
  record.roll_angle_rad = flown.roll_angle_rad;
  record.roll_rate_rad_s = flown.roll_rate_rad_s;
  record.canard_rad = flown.canard_rad;
  return {.record = record,
          .found = identify::identify(
              record, rocket,
              {.nodes = identify::model::NodeTimes{0.0, step_s}, .method = identify::result::Method::grid})};
}

// The print lost the minus sign of this one.
double end_as_printed_deg(const PublishedStep& row) {
  constexpr int step_without_minus = 7;
  return row.step == step_without_minus ? -row.disturbance_end_deg : row.disturbance_end_deg;
}

Claim row_claim(const PublishedStep& row, const identify::result::Identification& found) {
  const identify::model::RollModel& model = found.model;
  const double begin_deg = text::degrees(model.node_rad.front());
  const double end_deg = text::degrees(model.node_rad.back());
  const bool agrees = model.alpha_m2 == row.alpha_m2 && model.beta_m == row.beta_m &&
                      std::abs(begin_deg - row.disturbance_begin_deg) <= 0.03 &&
                      std::abs(end_deg - row.disturbance_end_deg) <= 0.03;
  const auto numbers = [](double alpha_m2, double beta_m, double from_deg, double to_deg) {
    return text::with_minus(fmt::format("{:g}, {:g}, {:.2f} to {:.2f} deg", alpha_m2, beta_m, from_deg, to_deg));
  };
  return {.place = "Table 2, step " + std::to_string(row.step),
          .what = "Damping, torque constant, offset at the begin and end",
          .theirs = numbers(row.alpha_m2, row.beta_m, row.disturbance_begin_deg, end_as_printed_deg(row)),
          .ours = numbers(model.alpha_m2, model.beta_m, begin_deg, end_deg),
          .difference = text::with_minus(fmt::format("{:g}, {:g}, {:.3f} and {:.3f} deg", model.alpha_m2 - row.alpha_m2,
                                                     model.beta_m - row.beta_m, begin_deg - row.disturbance_begin_deg,
                                                     end_deg - row.disturbance_end_deg)),
          .finding = agrees ? Finding::reproduced : Finding::differs,
          .basis = Basis::round_trip,
          .why = agrees ? "The step flown with the printed numbers and identified on the published grid: the search "
                          "returns what was put in. It says nothing of the measured step."
                        : "The reason is not known."};
}

double mean_of(const std::vector<PublishedStep>& rows, double PublishedStep::* member) {
  double sum = 0.0;
  for (const PublishedStep& row : rows) {
    sum += row.*member;
  }
  return sum / static_cast<double>(rows.size());
}

void add_means(std::vector<Claim>& claims, const std::vector<PublishedStep>& rows) {
  struct Mean {
    const char* what;
    double PublishedStep::* member;
    double printed;
    const char* unit;
    int decimals;
    bool minus_lost = false;
  };
  static constexpr Mean means[] = {
      {"Mean damping", &PublishedStep::alpha_m2, 19.4, "m2", 1},
      {"Mean torque constant", &PublishedStep::beta_m, 9.6, "m", 1},
      {"Mean offset at the begin", &PublishedStep::disturbance_begin_deg, -5.47, "deg", 2},
      {"Mean offset at the end", &PublishedStep::disturbance_end_deg, -6.62, "deg", 2, true},
      {"Mean angle error", &PublishedStep::mean_abs_angle_error_deg, 0.88, "deg", 2},
      {"Mean rate error", &PublishedStep::mean_abs_rate_error_deg_s, 3.52, "deg/s", 2}};
  for (const Mean& mean : means) {
    claims.push_back(compare({.place = "Table 2, mean",
                              .what = mean.what,
                              .theirs = mean.printed,
                              .ours = mean_of(rows, mean.member),
                              .unit = mean.unit,
                              .decimals = mean.decimals + 1,
                              .tolerance = 0.51 * std::pow(10.0, -mean.decimals),
                              .otherwise = Finding::error_in_print,
                              .why_otherwise = "The eight rows have another mean; \u22125.47 is the entry of step 8.",
                              .remark = mean.minus_lost ? "Printed without its minus sign." : ""}));
  }
}

}  // namespace

Chapter steps_chapter(const Tell& tell) {
  tell("repeating the eight steps of Table 2");
  const sim::Scenario tunnel = input::load_scenario("tunnel_steps", {});
  const std::vector<PublishedStep> rows = published_steps();
  Chapter chapter{.title = "Steps in the wind tunnel",
                  .introduction =
                      "Launch 2's rocket on a string at 22 m/s, eight steps of 45 degrees, gains 0.5 and 0.05 s, "
                      "five seconds of each identified with a disturbance that runs straight. The measured "
                      "steps are not published: each is flown here with the numbers that were printed for it, "
                      "and the published search must find them again."};
  std::optional<Repeated> sixth;
  for (const PublishedStep& row : rows) {
    Repeated repeated = repeat(row, tunnel);
    chapter.claims.push_back(row_claim(row, repeated.found));
    if (row.step == 6) {
      sixth = std::move(repeated);
    }
  }
  add_means(chapter.claims, rows);
  const double offset_deg =
      0.5 * (mean_of(rows, &PublishedStep::disturbance_begin_deg) + mean_of(rows, &PublishedStep::disturbance_end_deg));
  chapter.claims.push_back(compare({.place = "Section 4.3.1",
                                    .what = "Average fin offset over all steps",
                                    .theirs = -6.1,
                                    .ours = offset_deg,
                                    .unit = "deg",
                                    .decimals = 2,
                                    .tolerance = 0.051}));
  chapter.claims.push_back(compare({.place = "Section 4.3.1",
                                    .what = "The same without 2 degrees of swirl",
                                    .theirs = -4.1,
                                    .ours = offset_deg + 2.0,
                                    .unit = "deg",
                                    .decimals = 2,
                                    .tolerance = 0.051}));
  chapter.claims.push_back(unpublished("Table 2", "Mean absolute errors of each step", "0.26 to 1.64 deg",
                                       "They measure what the model leaves out of a real step."));
  const auto figure = [&](const std::string& label, const std::string& unit, const std::vector<double>& flown,
                          const std::vector<double>& model, const std::string& caption) {
    chapter.figures_html.push_back(half_width_figure(
        {.label = label,
         .x_label = "time / s",
         .y_label = unit,
         .series = {curve(sixth->record.time_s, text::in_degrees(flown), "step 6, flown with the printed numbers",
                          page::Role::measured),
                    curve(sixth->record.time_s, text::in_degrees(model), "identified", page::Role::model)}},
        caption));
  };
  figure("Roll angle of step 6", "roll angle / deg", sixth->record.roll_angle_rad,
         sixth->found.simulation.roll_angle_rad,
         "As figure 24a. The loop settles at reference plus disturbance over gain, not at 45 degrees.");
  figure("Roll rate of step 6", "roll rate / deg/s", sixth->record.roll_rate_rad_s,
         sixth->found.simulation.roll_rate_rad_s, "As figure 24b.");
  return chapter;
}

}  // namespace fantail::paper
