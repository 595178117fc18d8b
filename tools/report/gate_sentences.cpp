// SPDX-License-Identifier: MIT
#include <cctype>
#include <vector>

#include <fmt/format.h>

#include "flight/gate.hpp"
#include "report/verdict_parts.hpp"
#include "text/degrees.hpp"
#include "text/number.hpp"

namespace fantail::report {
namespace {

std::string in_s(double time_s, int decimals = 2) { return text::fixed(time_s, decimals) + " s"; }

/// "at 151 m and 81 m/s through the air, turning at -155 deg/s, with a roll angle of -260 deg"
std::string at_opening(const flight::Flight& flight, const Figures& f) {
  const Opening& o = f.opening;
  std::vector<std::string> parts;
  if (f.control_start_height_m) {
    parts.push_back(text::fixed(*f.control_start_height_m, 0) + " m");
  }
  if (o.speed_m_s) {
    parts.push_back(fmt::format("{} m/s {}", text::fixed(*o.speed_m_s, 0), speed_kind(flight)));
  }
  std::string text = parts.empty() ? "" : fmt::format("at {}", fmt::join(parts, " and "));
  if (o.roll_rate_rad_s && o.roll_angle_rad) {
    text += fmt::format("{}turning at {} deg/s, with a roll angle of {} deg", text.empty() ? "" : ", ",
                        text::fixed(text::degrees(*o.roll_rate_rad_s), 0),
                        text::fixed(text::degrees(*o.roll_angle_rad), 0));
  }
  return text;
}

/// A gate that is past before burn-out lets control begin under thrust, and a page has to say so. A trajectory shows a
/// motor only where it pushes with more than the drag.
std::string motor(const flight::Flight& flight) {
  const auto& start_s = flight.events.control_start_s;
  const auto& burnout_s = flight.events.burnout_s;
  if (start_s && burnout_s && *start_s < *burnout_s) {
    return fmt::format("The motor still burned: its thrust ended {} later.", in_s(*burnout_s - *start_s, 3));
  }
  if (start_s && flight.path_frame == flight::PathFrame::plane) {
    return "The motor may still have burned then: the trajectory does not show thrust below drag.";
  }
  const core::DormantUntil until = flight.plan.dormancy.until;
  const bool may_burn = until != core::DormantUntil::burn_out && until != core::DormantUntil::burn_out_and_height;
  return start_s && !burnout_s && may_burn ? "The motor may still have burned then: the log does not show burn-out."
                                           : "";
}

std::string captured(const Capture& c) {
  constexpr double seen_s = 0.005;  // less is 0.00 s
  const bool is_at_once = c.after_s && *c.after_s < seen_s;
  const std::string held = is_at_once  ? "roll was within 10 deg of its rest as control began, and stayed there"
                           : c.after_s ? fmt::format("roll was captured in {}", in_s(*c.after_s))
                           : c.watched_s
                               ? fmt::format("roll was not captured in the first {} of control", in_s(*c.watched_s))
                               : "";
  const std::string chosen = !c.turn          ? ""
                             : *c.turn == 0.0 ? "capture chose no whole turn"
                                              : fmt::format("capture chose turn {}", text::fixed(*c.turn, 0));
  std::string text = fmt::format("{}{}{}.", chosen, chosen.empty() || held.empty() ? "" : "; ", held);
  text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
  return text == "." ? "" : text;
}

std::string neutral(const Neutral& n) {
  if (!n.from_s || !n.command_rad) {
    return {};
  }
  const auto within = [](double angle_rad) { return text::fixed(text::degrees(angle_rad), 2); };
  std::string text = fmt::format("From {} to {}, all canards were commanded within {} deg of trim", in_s(*n.from_s),
                                 in_s(*n.until_s), within(*n.command_rad));
  if (n.encoder_rad) {
    text += fmt::format("; their encoders showed at most {} deg", within(*n.encoder_rad));
  }
  text += n.missing_s > 0.0 ? fmt::format(". Of that time, {} are not on record.", in_s(n.missing_s)) : ".";
  return text +
         (n.unread_s > 0.0 ? fmt::format(" For {} in all, an encoder could not be read.", in_s(n.unread_s)) : "");
}

}  // namespace

void add_gate_sentences(std::vector<std::string>& to, const flight::Flight& flight, const Figures& f) {
  if (!flight::shows_gate(flight)) {
    return;
  }
  const auto add = [&to](std::string sentence) {
    if (!sentence.empty()) {
      to.push_back(std::move(sentence));
    }
  };
  if (const auto& start_s = flight.events.control_start_s; start_s && f.control_time_s) {
    const std::string gate = !flight::has_gate(flight) ? "" : " (" + flight::gate_has_opened(flight) + ")";
    const std::string state = at_opening(flight, f);
    add(fmt::format("Control began at {}{}{}{}.", in_s(*start_s), gate, state.empty() ? "" : ", ", state));
    if (flight::has_gate(flight)) {
      add(motor(flight));
    }
    add(captured(f.capture));
    for (const Reopening& again : f.reopenings) {
      const std::string held = captured(again.capture);
      add(fmt::format("The gate closed and reopened at {}.{}{}", in_s(again.time_s), held.empty() ? "" : " ", held));
    }
  }
  if (flight::has_gate(flight)) {
    add(neutral(f.neutral));
  }
}

}  // namespace fantail::report
