// SPDX-License-Identifier: MIT
#include "predict/sentences.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "text/degrees.hpp"
#include "text/number.hpp"

namespace fantail::predict {

using text::brief;
using text::fixed;

std::string percent(double share) {
  const double value = 100.0 * share;
  if (value > 0.0 && value < 1.0) {
    return fixed(std::max(value, 0.1), 1) + " %";
  }
  return (value > 99.0 && value < 100.0 ? fixed(std::min(value, 99.9), 1) : fixed(value, 0)) + " %";
}

std::string percent_at_least(double share) { return fixed(std::floor(100.0 * share), 0) + " %"; }

std::string runs(std::size_t count) { return text::counted(count, "run"); }

std::string cause(const Run& run) {
  std::string_view text = run.verdict;
  if (constexpr std::string_view outside = "Outside the model: "; text.starts_with(outside)) {
    text.remove_prefix(std::min(text.size(), text.find(". ") + 2));  // told of all runs
  }
  for (const std::string_view heading : {"No control: ", "Roll not judged: ", "Roll not held: "}) {
    if (text.starts_with(heading)) {
      text.remove_prefix(heading.size());
    }
  }
  text = text.substr(0, std::min({text.find(". "), text.find("; "), text.find(": roll stayed")}));
  return std::string{text.ends_with('.') ? text.substr(0, text.size() - 1) : text};
}

std::string of_the_runs(double share) {
  return share == 0.0 ? "none of the runs" : share == 1.0 ? "all runs" : percent(share) + " of the runs";
}

std::string missing_spread(const Prediction& p) {
  if (p.runs.size() == 1) {
    return "A single run shows no spread.";
  }
  // What a table prints as the same, and what the noise of identical steps comes to.
  constexpr double same_offset_rad = text::radians(0.1);
  constexpr double same_share = 0.02;
  const auto range = [&p](double TunnelStep::* member) {
    const auto [least, most] = std::ranges::minmax(p.tunnel.steps, {}, member);
    return std::pair{least.*member, most.*member};
  };
  const auto within = [&range](double TunnelStep::* member, double tolerance) {
    const auto [least, most] = range(member);
    return most - least < tolerance;
  };
  const auto alike = [&range](double TunnelStep::* member) {
    const auto [least, most] = range(member);
    return most - least < same_share * most;
  };
  if (p.tunnel.steps.empty() || !within(&TunnelStep::offset_begin_rad, same_offset_rad) ||
      !within(&TunnelStep::offset_end_rad, same_offset_rad)) {
    return {};
  }
  const std::string offset = fmt::format("The fin offset is the same to 0.1 degrees in all rows of {}", p.tunnel.name);
  return alike(&TunnelStep::damping_m2) && alike(&TunnelStep::torque_m)
             ? offset +
                   ", damping and torque to 2 %. This is one airframe measured several times, so the runs do not show "
                   "how airframes differ."
             : offset + ". The runs do not show how offsets differ.";
}

std::string wind_sentence(const sim::Scenario& scenario) {
  const sim::WindParameters& wind = scenario.wind;
  const sim::WindSpread& spread = scenario.wind_spread;
  const bool is_known = spread.speed_m_s == 0.0 && spread.direction_rad == 0.0;
  if (scenario.motion != sim::FlightMotion::six_dof || (is_known && wind.speed_m_s == 0.0)) {
    return {};
  }
  const std::string turbulence = wind.turbulence > 0.0 ? "; each run has its own turbulence" : "";
  const double from_deg = text::degrees(wind.from_rad);
  if (is_known) {
    return fmt::format(
        "The wind is {} m/s from {} degrees in all runs{}: neither wind.speed_spread_m_s nor "
        "wind.direction_spread_deg is stated.",
        brief(wind.speed_m_s, 2), brief(from_deg, 1), turbulence);
  }
  const std::string speed =
      spread.speed_m_s > 0.0
          ? fmt::format(
                "drawn from a normal distribution about {} m/s with a standard deviation of {} m/s, cut at zero",
                brief(wind.speed_m_s, 2), brief(spread.speed_m_s, 2))
          : fmt::format("{} m/s", brief(wind.speed_m_s, 2));
  const std::string direction = spread.direction_rad >= text::radians(180.0) ? "from anywhere"
                                : spread.direction_rad > 0.0
                                    ? fmt::format("from anywhere within {} degrees of {} degrees",
                                                  brief(text::degrees(spread.direction_rad), 1), brief(from_deg, 1))
                                    : fmt::format("from {} degrees", brief(from_deg, 1));
  return fmt::format("The wind of each run is {}, {}{}.", speed, direction, turbulence);
}

std::string wind_caution(const sim::Scenario& scenario) {
  if (scenario.motion != sim::FlightMotion::six_dof || scenario.wind.speed_m_s == 0.0 ||
      scenario.wind_spread.speed_m_s > 0.0) {
    return {};
  }
  return fmt::format("the wind speed is {} m/s in all runs. Vary it with --set wind.speed_spread_m_s=M_S",
                     brief(scenario.wind.speed_m_s, 2));
}

std::string_view name(Judgement judgement) {
  switch (judgement) {
    case Judgement::met: return "met";
    case Judgement::not_met: return "not_met";
    case Judgement::not_judged: break;
  }
  return "not_judged";
}

std::string_view label(Judgement judgement) {
  switch (judgement) {
    case Judgement::met: return "met";
    case Judgement::not_met: return "not met";
    case Judgement::not_judged: break;
  }
  return "not judged";
}

std::string changes_sentence(const Prediction& p) {
  return p.request.changes.empty()
             ? ""
             : fmt::format("Changed on the command line: {}.", fmt::join(p.request.changes, ", "));
}

std::string resonance_warning(const Prediction& p) {
  return p.resonance ? warning(*p.resonance, std::abs(p.reach.angle_rad)) : "";
}

std::string resonance_caution(const Prediction& p) {
  return p.resonance && p.resonance->with_canards > 0 ? caution(*p.resonance) : "";
}

std::string spread_not_drawn(const Prediction& p) {
  constexpr std::size_t named = 3;
  const std::vector<std::string>& fields = p.request.not_drawn;
  if (fields.empty()) {
    return {};
  }
  const std::size_t shown = std::min(named, fields.size());
  return fmt::format("The scenario's [[spread]] of {}{}: fantail campaign draws {}.",
                     fmt::join(fields.begin(), fields.begin() + static_cast<std::ptrdiff_t>(shown), ", "),
                     shown < fields.size() ? fmt::format(" and {} more are not drawn here", fields.size() - shown)
                     : shown == 1          ? " is not drawn here"
                                           : " are not drawn here",
                     fields.size() == 1 ? "it" : "them");
}

std::vector<std::string> not_in_verdict(const Prediction& p, const Decision& decision) {
  std::vector<std::string> all;
  std::ranges::remove_copy_if(p.flight_notes, std::back_inserter(all), is_figure_alone);
  if (p.resonance && p.resonance->with_canards > 0 && !decision.go) {
    all.insert(all.begin(), in_short(*p.resonance, std::abs(p.reach.angle_rad)));
  }
  return all;
}

std::string repeat_command(const Prediction& p, std::string_view run) {
  return fmt::format("{} --run {}", p.request.command, run);
}

std::vector<std::string> basis(const Prediction& p) {
  std::vector<std::string> all;
  all.reserve(p.tunnel.sources.size() + 4);
  for (const std::string& source : p.tunnel.sources) {
    all.push_back(fmt::format("Source of {}: {}.", p.tunnel.name, source));
  }
  all.push_back(fmt::format(
      "{} drawn from Student's t distribution with {} degrees of freedom, fitted to the {} rows of {}. Damping, torque "
      "and offset are correlated as there. Each is flown with its own sensor noise.",
      text::counted(p.runs.size(), "airframe"), p.tunnel.steps.size() - 1, p.tunnel.steps.size(), p.tunnel.name));
  all.push_back(
      p.tunnel.standard_errors.empty()
          ? fmt::format("{} states no standard errors, so all scatter of its rows counts as scatter of the airframes.",
                        p.tunnel.name)
          : fmt::format("The variance of measurement, from the standard errors in {}, is subtracted from the spread.",
                        p.tunnel.name));
  all.push_back(p.tunnel.swirl_words);
  if (p.damping.low != 1.0 || p.damping.high != 1.0) {
    all.push_back(fmt::format("Damping is multiplied by a factor between {} and {} (--damping-factor).",
                              brief(p.damping.low, 3), brief(p.damping.high, 3)));
  }
  if (const std::string sentence = wind_sentence(p.flown); !sentence.empty()) {
    all.push_back(sentence);
  }
  all.push_back(fmt::format("Servo: first-order lag {} ms; dead time of the whole loop {} ms.",
                            brief(1e3 * p.servo_lag_s, 1), brief(1e3 * p.delay_s, 1)));
  all.insert(all.end(), p.notes.begin(), p.notes.end());
  std::ranges::copy_if(p.flight_notes, std::back_inserter(all), is_figure_alone);
  return all;
}

}  // namespace fantail::predict
