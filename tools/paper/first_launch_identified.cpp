// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/core.h>
#include <fmt/ranges.h>

#include "paper/recomputed.hpp"
#include "text/degrees.hpp"
#include "text/number.hpp"

namespace fantail::paper {
namespace {

// "8.52 and 10.03"
std::string pair(const identify::model::RollModel& model) {
  return fmt::format("{:.2f} and {:.2f}", model.alpha_m2, model.beta_m);
}

// What the open loop finds with so many intervals: mean angle error in degrees, and the model.
struct Trial {
  double error_deg;
  identify::model::RollModel model;
};
Trial trial(const FirstLaunchIdentified& ours, std::size_t in_thrust, std::size_t in_coast) {
  const identify::result::Identification found = identify::identify(
      ours.record, ours.rocket,
      {.nodes = times_in_thrust_and_coast(ours.thrust_s, in_thrust, ours.record.time_s.back(), in_coast),
       .with_uncertainty = false,
       .with_error_map = false});
  return {text::degrees(found.simulation.mean_abs_angle_error_rad), found.model};
}

void add_intervals(std::vector<Claim>& claims, const FirstLaunchIdentified& ours) {
  const std::string log = "The flight's log is not published.";
  const Trial two = trial(ours, 2, 2);
  double gained_deg = 0.0;
  double alpha_apart_m2 = 0.0;
  double beta_apart_m = 0.0;
  for (std::size_t in_thrust = 3; in_thrust <= 6; ++in_thrust) {
    const Trial more = trial(ours, in_thrust, 2);
    gained_deg = std::max(gained_deg, two.error_deg - more.error_deg);
    alpha_apart_m2 = std::max(alpha_apart_m2, std::abs(more.model.alpha_m2 - two.model.alpha_m2));
    beta_apart_m = std::max(beta_apart_m, std::abs(more.model.beta_m - two.model.beta_m));
  }
  claims.push_back(unpublished("Section 4.2", "Two to six thrust intervals: gain in the roll angle; damping and torque",
                               "less than 0.1 deg; unchanged and within 0.05", log,
                               fmt::format("{:.2f} deg; damping within {:.2f}, torque constant within {:.2f}",
                                           gained_deg, alpha_apart_m2, beta_apart_m)));
  claims.push_back(
      unpublished("Section 4.2", "One coast interval instead of two", "a consistently large error", log,
                  fmt::format("{:.2f} instead of {:.2f} deg", trial(ours, 2, 1).error_deg, two.error_deg)));
}

}  // namespace

identify::model::NodeTimes times_in_thrust_and_coast(double thrust_s, std::size_t in_thrust, double end_s,
                                                     std::size_t in_coast) {
  identify::model::NodeTimes times{0.0};
  times.reserve(1 + in_thrust + in_coast);
  for (std::size_t i = 1; i <= in_thrust; ++i) {
    times.push_back(thrust_s * static_cast<double>(i) / static_cast<double>(in_thrust));
  }
  for (std::size_t j = 1; j <= in_coast; ++j) {
    times.push_back(thrust_s + (end_s - thrust_s) * static_cast<double>(j) / static_cast<double>(in_coast));
  }
  return times;
}

std::vector<Claim> first_launch_identified(const FirstLaunchIdentified& ours) {
  std::vector<Claim> claims;
  const std::string left_out = "They measure the effects in a real flight that the model leaves out.";
  claims.push_back(unpublished(
      "Eq 37", "Damping and torque constant, open loop", "8.5 and 10.0",
      "The flight's log is not published. Ours is not 7.5 because the times of Eq 35 are not where our offset bends.",
      fmt::format("{} in our flight, made with 7.5 and 10", pair(ours.open.model))));
  claims.push_back(compare(InWords{
      .place = "Eq 40",
      .what = "Damping and torque constant, closed loop",
      .theirs = "7.5 and 10.0",
      .ours = pair(ours.closed.model),
      .holds = std::abs(ours.closed.model.alpha_m2 - 7.5) < 0.5 && std::abs(ours.closed.model.beta_m - 10.0) < 0.5,
      .kind = Kind::read_back,
      .why = "Our flight was made with the printed values. Its servos have a delay and play that the "
             "closed-loop model does not have. Its offset does not bend at the times of Eq 35."}));
  claims.push_back(unpublished("Eq 38 and 39", "Mean absolute errors of roll rate and angle, open loop",
                               "9.82 deg/s, 1.51 deg", left_out));
  claims.push_back(unpublished("Eq 41 and 42", "The same, closed loop", "9.76 deg/s, 1.50 deg", left_out));
  claims.push_back(
      compare(InWords{.place = "Eq 35 and 36",
                      .what = "Times of two disturbance intervals in thrust and two in coast",
                      .theirs = "T_thrust / 2, T_thrust, halfway to T_end, T_end",
                      .ours = fmt::format("{:.2f} s in our flight", fmt::join(ours.open.model.node_time_s.begin() + 1,
                                                                              ours.open.model.node_time_s.end(), ", ")),
                      .holds = true,
                      .kind = Kind::definition,
                      .why = "T_thrust and T_end are in figure 19 only."}));
  claims.push_back(compare(InWords{
      .place = "Section 4.2, figure 21b",
      .what = "Disturbance: quite low in the first 0.5 s, near \u22127 degrees after about 1 s, little more at the end",
      .theirs = "yes",
      .ours = text::with_minus(fmt::format("{:.1f} deg at these times and the begin",
                                           fmt::join(text::in_degrees(ours.open.model.node_rad), ", "))),
      .holds = std::abs(ours.open.model.node_rad.front()) < text::radians(2.0) &&
               std::abs(ours.open.model.node_rad.back()) > text::radians(6.0),
      .kind = Kind::read_back,
      .why = "The offset of our flight was read off this figure."}));
  double apart_rad = 0.0;
  const std::vector<double>& open_rad = ours.open.simulation.roll_angle_rad;
  for (std::size_t i = 0; i < open_rad.size(); ++i) {
    apart_rad +=
        std::abs(open_rad[i] - ours.closed.simulation.roll_angle_rad[i]) / static_cast<double>(open_rad.size());
  }
  claims.push_back(compare(InWords{
      .place = "Section 4.2, figures 20 and 22",
      .what = "Open and closed loop give the same response and disturbance",
      .theirs = "very similar",
      .ours = fmt::format("{:.2f} deg apart in the mean; mean errors {:.2f} and {:.2f} deg", text::degrees(apart_rad),
                          text::degrees(ours.open.simulation.mean_abs_angle_error_rad),
                          text::degrees(ours.closed.simulation.mean_abs_angle_error_rad)),
      .holds = text::degrees(apart_rad) < 3.0,
      .kind = Kind::read_back,
      .why = "Our flight was made with this model, so both find it."}));
  claims.push_back(unpublished("Section 4.2", "Longer simulation of the closed loop than of the open", "about 50 %",
                               "It measures their program on their computer."));
  add_intervals(claims, ours);
  claims.push_back(unpublished(
      "Section 4.2", "Wind on the ground", "1 to 2 m/s",
      "Neither its direction nor its effect is printed; this flight follows a straight line, without wind."));
  return claims;
}

}  // namespace fantail::paper
