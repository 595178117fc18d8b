// SPDX-License-Identifier: MIT
#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include "report/hold.hpp"
#include "text/degrees.hpp"
#include "text/number.hpp"

namespace fantail::report {
namespace {

std::string brief(double value) { return text::brief(value, 2); }

/// "Here u_d is -4.9 deg and kp is 0.5, so it rests -4.9/0.5 = -9.8 deg from R.", or between what it rests when that
/// changes under control. Empty without truth.
std::string in_numbers(const flight::Flight& flight) {
  std::vector<double> offsets_deg;
  std::vector<double> rests_deg;  // from R
  for (const flight::Row& row : flight.rows) {
    const auto settles_rad = flight::settle_point_rad(row, flight);
    if (row.phase == core::Phase::controlling && settles_rad) {
      offsets_deg.push_back(text::degrees(row.truth->disturbance_rad));
      rests_deg.push_back(text::degrees(*settles_rad - row.reference_rad));
    }
  }
  if (rests_deg.empty()) {
    return {};
  }
  const std::string lowest = brief(std::ranges::min(rests_deg));
  const std::string highest = brief(std::ranges::max(rests_deg));
  if (lowest != highest) {
    return fmt::format(" Here that is between {} and {} deg from R.", lowest, highest);
  }
  const std::string offset = brief(std::ranges::min(offsets_deg));
  const std::string gain = text::brief(static_cast<double>(flight.plan.controller.proportional_gain), 4);
  return flight.left_by_fins != 1.0
             ? fmt::format(
                   " Here that is {} deg from R: u_d is {} deg, kp is {}, and {} times the canards' roll torque "
                   "remains.",
                   lowest, offset, gain, brief(flight.left_by_fins))
             : fmt::format(" Here u_d is {} deg and kp is {}, so it settles {}/{} = {} deg from R.", offset, gain,
                           offset, gain, lowest);
}

}  // namespace

std::string settling_left_out(const flight::Flight& flight, bool again) {
  const core::ReferencePlan& reference = flight.plan.reference;
  const bool has_steps = reference.kind == core::ReferenceKind::square_wave ||
                         (reference.kind == core::ReferenceKind::steps && reference.step_times_count > 0);
  const std::string_view control = again ? "each spell of control" : "control";
  if (first_settling_time_s(flight) != step_settling_time_s(flight)) {
    return fmt::format("the first {} s of {}{}", text::brief(first_settling_time_s(flight), 1), control,
                       has_steps ? " and the first second of each step" : "");
  }
  return fmt::format("the first {} of {}{}", flight.tunnel ? "two seconds" : "second", control,
                     has_steps ? " and of each step" : "");
}

std::string once_settled(const flight::Flight& flight, bool again) {
  return "after " + settling_left_out(flight, again);
}

std::string settle_point_name(const flight::Flight& flight) {
  if (flight.known.plan && flight::rejects_offset(flight.plan)) {
    return "R";
  }
  return flight.plan.gain_schedule.speeds_count > 0 ? "R + u_d/(f kp)" : "R + u_d/kp";
}

std::string settle_point_text(const flight::Flight& flight, bool can_settle) {
  const std::string balanced = flight.tunnel ? " the fin offset and the swirl." : " the fin offset.";
  const std::string here = can_settle ? in_numbers(flight) : " Here it cannot get there.";
  const std::string why =
      flight::rejects_offset(flight.plan)
          ? "This law subtracts its estimate of u_d from the command. So it settles at the reference R, "
            "if the canards reach far enough, as soon as the estimate is right."
      : flight.plan.gain_schedule.speeds_count > 0
          ? "This loop settles at R\u00a0+\u00a0u_d/(f\u00a0kp), f the factor of the gain schedule, not at the "
            "reference R: an angle error has to balance" +
                balanced + here
          : "A proportional-derivative loop settles at R\u00a0+\u00a0u_d/kp, not at the reference R: an angle "
            "error has to balance" +
                balanced + here;
  const bool leaves_out_capture = first_settling_time_s(flight) != step_settling_time_s(flight);
  return fmt::format(
      "{} The hold error is measured from there, without the {} after each beginning of control and {}after each "
      "reference step.",
      why,
      leaves_out_capture ? text::brief(first_settling_time_s(flight), 1) + " s for capture"
      : flight.tunnel    ? "two seconds"
                         : "second",
      leaves_out_capture ? "the second " : "");
}

}  // namespace fantail::report
