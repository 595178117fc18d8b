// SPDX-License-Identifier: MIT
#include "paper/first_launch_identified.hpp"

#include <cmath>
#include <string>

#include <fmt/core.h>
#include <fmt/ranges.h>

#include "text/degrees.hpp"
#include "text/number.hpp"

namespace fantail::paper {
namespace {

// "8.52 and 10.03"
std::string pair(const identify::model::RollModel& model) {
  return fmt::format("{:.2f} and {:.2f}", model.alpha_m2, model.beta_m);
}

}  // namespace

std::vector<Claim> first_launch_identified(const FirstLaunchIdentified& ours) {
  std::vector<Claim> claims;
  const std::string log = "The flight's log is not published.";
  const std::string left_out = "They measure what the model leaves out of a real flight.";
  claims.push_back(unpublished("Eq 37", "Damping and torque constant, open loop", "8.5 and 10.0",
                               log + " Ours is not 7.5 because the times of Eq 35 are not where our offset bends.",
                               fmt::format("{} in our flight, made with 7.5 and 10", pair(ours.open.model))));
  claims.push_back(compare(InWords{
      .place = "Eq 40",
      .what = "Damping and torque constant, closed loop",
      .theirs = "7.5 and 10.0",
      .ours = pair(ours.closed.model),
      .holds = std::abs(ours.closed.model.alpha_m2 - 7.5) < 0.5 && std::abs(ours.closed.model.beta_m - 10.0) < 0.5,
      .kind = Kind::read_back,
      .why = "Our flight was made with the printed values. Its servos have a delay and play that the "
             "closed-loop model does not have, and its offset does not bend at the times of "
             "Eq 35."}));
  claims.push_back(unpublished("Eq 38 and 39", "Mean absolute errors of roll rate and angle, open loop",
                               "9.82 deg/s, 1.51 deg", left_out));
  claims.push_back(unpublished("Eq 41 and 42", "The same, closed loop", "9.76 deg/s, 1.50 deg", left_out));
  claims.push_back(compare(InWords{
      .place = "Eq 35 and 36",
      .what = "Times of two disturbance intervals in thrust and two in coast",
      .theirs = "T_thrust / 2, T_thrust, halfway to T_end, T_end",
      .ours = fmt::format("{:.2f} s in our flight", fmt::join(ours.nodes_s.begin() + 1, ours.nodes_s.end(), ", ")),
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
  claims.push_back(
      unpublished("Section 4.2", "Longer simulation of the closed loop than of the open", "about 50 %",
                  "It measures their program on their computer. The manual compares ours, on its page on the model."));
  claims.push_back(
      unpublished("Section 4.2", "Gain in the roll angle from two to six thrust intervals", "less than 0.1 deg", log));
  claims.push_back(unpublished("Section 4.2", "One coast interval instead of two", "a consistently large error", log));
  claims.push_back(unpublished("Section 4.2", "Wind on the ground", "1 to 2 m/s",
                               "Neither its direction nor what it did is printed; this flight is along a straight "
                               "line, without wind."));
  return claims;
}

}  // namespace fantail::paper
