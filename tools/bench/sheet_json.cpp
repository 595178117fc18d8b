// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "bench/sheet.hpp"
#include "bench/sheet_parts.hpp"
#include "bench/watch.hpp"
#include "core/flight_plan.hpp"
#include "core/tick_record.hpp"
#include "json/value.hpp"
#include "text/degrees.hpp"

namespace fantail::bench {
namespace {

using Json = json::Value;
using json::rounded;
using json::text_or_null;
using text::degrees;

Json angle(const std::optional<double>& radians) { return radians ? rounded(degrees(*radians)) : Json{}; }

Json angles(const Each<double>& radians) {
  Json all = Json::array();
  for (const double value : radians) {
    all.push_back(rounded(degrees(value)));
  }
  return all;
}

void add_figures(Json& to, const TurnResult& turn) {
  const Figures& f = turn.figures;
  to["sign"] = f.sign;
  to["gain"] = rounded(f.gain);
  to["slope"] = rounded(f.slope);
  to["reached_positive_deg"] = angle(f.reached_positive_rad);
  to["reached_negative_deg"] = angle(f.reached_negative_rad);
  to["largest_command_deg"] = angle(f.largest_command_rad);
  to["limit_reported"] = f.limit_reported;
  to["tracking_error_deg"] = angle(f.tracking_error_rad);
  to["lag_s"] = rounded(f.lag_s);
  to["centring_error_deg"] = angle(f.centring_error_rad);
  to["backlash_deg"] = angle(f.backlash_rad);
  to["slew_deg_s"] = angle(f.slew_rad_s);
  to["step_time_s"] = rounded(f.step_time_s);
  to["overshoot_deg"] = angle(f.overshoot_rad);
  to["noise_deg"] = angle(f.noise_rad);
  to["dropouts"] = f.dropouts;
  to["dropout_share"] = rounded(f.dropout_share());
  to["ticks"] = f.received_ticks;
  to["others_moved_deg"] = angle(f.others_moved_rad);
  to["amplitude_ratio"] = rounded(f.amplitude_ratio);
  to["phase_lag_deg"] = angle(f.phase_lag_rad);
  Json failed = Json::array();
  for (const Check& check : turn.checks) {
    if (!check.passed) {
      failed.push_back(text_of(check.measure).key);
    }
  }
  to["failed"] = failed;
}

// As the page has it: where there is no verdict, nothing is said of a canard.
Json canard(const CanardResult& result, const Sheet& sheet) {
  const auto& monitor = sheet.heading.monitor[result.canard];
  const bool judged = sheet.judgement() != Judgement::none;
  const Finding found = finding(sheet, result, judged);
  Json all = {{"canard", result.canard + 1},
              {"passed", judged ? Json(result.passed()) : Json{}},
              {"cause", found.name},
              {"sentence", judged ? sentence(result.canard, found.text, result.diagnosis)
                                  : fmt::format("Canard {} {}.", result.canard + 1, found.text)},
              {"monitor", monitor ? Json(core::name(*monitor)) : Json{}}};
  add_figures(all, result.alone ? *result.alone : *result.together);
  if (result.alone && result.together) {
    Json together = {{"passed", judged ? Json(result.together->passed()) : Json{}},
                     {"cause", judged ? name(result.together->diagnosis.cause) : found.name}};
    add_figures(together, *result.together);
    all["together"] = together;
  }
  return all;
}

Json tolerances(const sim::CanardTolerances& t) {
  return {{"reach_deg", rounded(degrees(t.reach_rad))},
          {"tracking_error_deg", rounded(degrees(t.tracking_rad))},
          {"centring_error_deg", rounded(degrees(t.centring_rad))},
          {"backlash_deg", rounded(degrees(t.backlash_rad))},
          {"slew_deg_s", rounded(degrees(t.slowest_slew_rad_s))},
          {"step_time_s", rounded(t.longest_step_time_s)},
          {"noise_deg", rounded(degrees(t.noise_rad))},
          {"dropout_share", rounded(t.dropout_share)},
          {"others_moved_deg", rounded(degrees(most_others_move_rad()))}};
}

}  // namespace

std::string sheet_json(const Sheet& sheet, const result::Made& made) {
  const Heading& heading = sheet.heading;
  Json canards = Json::array();
  for (const CanardResult& result : sheet.canards) {
    canards.push_back(canard(result, sheet));
  }
  Json general = Json::array();
  for (const GeneralCheck& check : sheet.general) {
    general.push_back({{"passed", check.passed}, {"text", check.text}});
  }
  Json all = {{"exercise", name(sheet.kind)},
              {"passed", sheet.passed()},
              {"judgement", name(sheet.judgement())},
              {"doubts", sheet.doubts},
              {"conclusions", conclusions(sheet)},
              {"vehicle", text_or_null(heading.vehicle)},
              {"plan", text_or_null(heading.plan)},
              {"plan_crc", text_or_null(heading.plan_crc)},
              {"gate", text_or_null(heading.gate)},
              {"date", text_or_null(heading.date)},
              {"avionics", text_or_null(heading.avionics)},
              {"hard_limit_deg", rounded(static_cast<double>(core::hard_canard_limit.degrees()))},
              {"limit_deg", angles(sheet.bounds.limit_rad)},
              {"centre_deg", angles(sheet.bounds.centre_rad)},
              {"tolerances", tolerances(sheet.tolerances)},
              {"canards", canards},
              {"general", general},
              {"ticks", sheet.ticks},
              {"lost_ticks", sheet.lost_ticks},
              {"duration_s", rounded(sheet.duration_s)},
              {"notes", heading.notes},
              {"version", heading.version}};
  add_board(all, heading.board, "plan_source");
  result::put_answer(all, answer(sheet.judgement()), fmt::format("{}", fmt::join(conclusions(sheet), " ")), made);
  return all.pretty();
}

}  // namespace fantail::bench
