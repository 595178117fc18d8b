// SPDX-License-Identifier: MIT
#include "tunnel/swirl_report.hpp"

#include <fmt/core.h>

#include "text/degrees.hpp"
#include "tunnel/json.hpp"

namespace fantail::tunnel {
namespace {

using text::degrees;

Json session(const RollSession& session, const std::vector<OffsetPoint>& points) {
  Json all = Json::array();
  for (const OffsetPoint& p : points) {
    all.push_back({{"fan_rpm", rounded(p.segment.fan_rpm)},
                   {"begin_s", rounded(p.segment.begin_s)},
                   {"end_s", rounded(p.segment.end_s)},
                   {"speed_m_s", rounded(p.speed_m_s.mean)},
                   {"speed_standard_error_m_s", rounded(p.speed_m_s.standard_error)},
                   {"roll_rate_deg_s", angle(p.rate_rad_s.mean)},
                   {"roll_rate_standard_error_deg_s", angle(p.rate_rad_s.standard_error)},
                   {"independent_samples", rounded(p.rate_rad_s.independent_samples)},
                   {"canard_deg", angle(p.canard_rad)},
                   {"offset_deg", angle(p.offset_rad)},
                   {"offset_standard_error_deg", angle(p.standard_error_rad)}});
  }
  return {{"log", session.roll.name}, {"wind", session.wind.name}, {"set_points", all}};
}

std::string curve(const char* title, const RollSession& session, const std::vector<OffsetPoint>& points) {
  std::string text =
      fmt::format("{}: {}\n      speed          roll rate               offset\n", title, session.roll.name);
  for (const OffsetPoint& p : points) {
    text += fmt::format("  {:6.2f} m/s  {:8.2f} +- {:.2f} deg/s   {:7.3f} +- {:.3f} deg\n", p.speed_m_s.mean,
                        degrees(p.rate_rad_s.mean), degrees(p.rate_rad_s.standard_error), degrees(p.offset_rad),
                        degrees(p.standard_error_rad));
  }
  return text + "\n";
}

}  // namespace

std::string swirl_sentence(const Swirl& swirl) {
  if (!swirl.swirl) {
    return fmt::format("The sessions share no speed from {:g} m/s on: the swirl is not known.",
                       swirl.options.from_speed_m_s);
  }
  return fmt::format("The swirl is worth {:.3f} +- {:.3f} deg of canard (mean of {} speeds from {:g} m/s on).",
                     degrees(swirl.swirl->offset_rad), degrees(swirl.swirl->standard_error_rad), swirl.swirl->speeds,
                     swirl.options.from_speed_m_s);
}

std::string swirl_text(const SwirlSessions& sessions, const Swirl& swirl) {
  std::string text = swirl_sentence(swirl) + "\n\n";
  text += curve("without flow straightener", sessions.without, swirl.without);
  text += curve("with flow straightener", sessions.with, swirl.with);
  text += "difference: what the swirl adds\n";
  for (const OffsetDifference& d : swirl.differences) {
    text += fmt::format("  {:6.2f} m/s  {:7.3f} +- {:.3f} deg{}\n", d.speed_m_s, degrees(d.difference_rad),
                        degrees(d.standard_error_rad), d.counted ? "" : "   not counted");
  }
  text += fmt::format(
      "\nOffsets are alpha p / (beta v) with alpha {:g} m2 and beta {:g} m, less where the canards stood. An error of\n"
      "these two scales both curves and the difference; the +- are standard errors and do not hold it.\n",
      swirl.options.alpha_m2, swirl.options.beta_m);
  for (const std::string& remark : swirl.remarks) {
    text += "  " + remark + "\n";
  }
  return text;
}

std::string swirl_json(const SwirlSessions& sessions, const Swirl& swirl) {
  Json differences = Json::array();
  for (const OffsetDifference& d : swirl.differences) {
    differences.push_back({{"speed_m_s", rounded(d.speed_m_s)},
                           {"without_deg", angle(d.without_rad)},
                           {"with_deg", angle(d.with_rad)},
                           {"difference_deg", angle(d.difference_rad)},
                           {"standard_error_deg", angle(d.standard_error_rad)},
                           {"counted", d.counted}});
  }
  const auto of_mean = [&swirl](double SwirlOffset::* value) {
    return swirl.swirl ? angle(*swirl.swirl.*value) : Json{};
  };
  const Json all = {{"swirl_deg", of_mean(&SwirlOffset::offset_rad)},
                    {"swirl_standard_error_deg", of_mean(&SwirlOffset::standard_error_rad)},
                    {"swirl_deviation_deg", of_mean(&SwirlOffset::deviation_rad)},
                    {"from_speed_m_s", rounded(swirl.options.from_speed_m_s)},
                    {"alpha_m2", rounded(swirl.options.alpha_m2)},
                    {"beta_m", rounded(swirl.options.beta_m)},
                    {"without", session(sessions.without, swirl.without)},
                    {"with", session(sessions.with, swirl.with)},
                    {"differences", differences},
                    {"remarks", swirl.remarks}};
  return all.pretty();
}

}  // namespace fantail::tunnel
