// SPDX-License-Identifier: MIT
#include "json/value.hpp"
#include "text/degrees.hpp"
#include "tune/results.hpp"

namespace fantail::tune {
namespace {

using Json = json::Value;
using json::rounded;
using text::degrees;

Json angle(const std::optional<double>& rad) { return rad ? Json{rounded(degrees(*rad))} : Json{}; }
Json number(const std::optional<double>& value) { return value ? Json{rounded(*value)} : Json{}; }

Json schedule(const core::GainSchedulePlan& plan) {
  Json rows = Json::array();
  for (std::size_t i = 0; i < plan.speeds_count; ++i) {
    rows.push_back({{"speed_m_s", rounded(static_cast<double>(plan.speeds_m_s[i]))},
                    {"factor", rounded(static_cast<double>(plan.factors[i]))}});
  }
  return rows;
}

Json judged(const Judged& j) {
  const core::FlightPlan& plan = j.plan;
  const auto offset = plan.offset.rejection;
  const auto value = [](bool is, float number) { return is ? Json{rounded(static_cast<double>(number))} : Json{}; };
  Json loop = Json::array();
  for (const LoopAtSpeed& at : j.loop) {
    loop.push_back({{"speed_m_s", rounded(at.speed_m_s)},
                    {"least_phase_margin_deg", rounded(degrees(at.least_phase_margin_rad))},
                    {"crossover_rad_s", number(at.crossover_rad_s)}});
  }
  return {{"proportional_gain", rounded(static_cast<double>(plan.controller.proportional_gain))},
          {"derivative_gain_s", rounded(static_cast<double>(plan.controller.derivative_gain_s))},
          {"integral_gain_per_s", value(offset == core::OffsetRejection::integral, plan.offset.integral_gain_per_s)},
          {"observer_bandwidth_rad_s",
           value(offset == core::OffsetRejection::observer, plan.offset.observer_bandwidth_rad_s)},
          {"gain_schedule", schedule(plan.gain_schedule)},
          {"least_phase_margin_deg", rounded(degrees(j.least.phase_margin_rad))},
          {"at_speed_m_s", rounded(j.least.speed_m_s)},
          {"settling_s", number(j.settling_s)},
          {"command_noise_deg", angle(j.noise_rad)},
          {"over_speed", loop}};
}

Json flown(const Flown& f) {
  const auto error = compared(f);
  return {{"outcome", report::name(f.outcome)},
          {"mean_error_deg", angle(error ? std::optional{error->mean_rad} : std::nullopt)},
          {"largest_error_deg", angle(error ? std::optional{error->largest_rad} : std::nullopt)},
          {"saturated_share", rounded(f.saturated_share)}};
}

Json total(const Sum& sum) {
  return {{"flights", sum.flights},
          {"held", sum.held},
          {"off_command", sum.off_command},
          {"outside_model", sum.outside_model},
          {"settled", sum.is_settled},
          {"mean_error_deg", angle(sum.mean_rad)},
          {"largest_error_deg", angle(sum.largest_rad)}};
}

}  // namespace

result::Answer answer(const Tuning& t) {
  return !t.is_proposed()                             ? result::Answer::no
         : t.is_better() && model_sentence(t).empty() ? result::Answer::yes
                                                      : result::Answer::undecided;
}

std::string tuning_json(const Tuning& t, const std::string& plan_file, const result::Made& made) {
  Json flights = Json::array();
  for (const Pair& pair : t.pairs) {
    flights.push_back({{"seed", pair.seed},
                       {"alpha_m2", rounded(pair.damping_m2)},
                       {"beta_m", rounded(pair.torque_m)},
                       {"before", flown(pair.before)},
                       {"after", flown(pair.after)}});
  }
  Json all{{"scenario", t.scenario},
           {"vehicle", t.vehicle},
           {"version", t.request.version},
           {"command", t.request.command},
           {"proposed", t.is_proposed()},
           {"better", t.is_better()},
           {"why_none", t.why_none.empty() ? Json{} : Json{t.why_none}},
           {"plan", plan_file.empty() ? Json{} : Json{plan_file}},
           {"lowest_speed_m_s", rounded(t.speeds.range.lowest_m_s)},
           {"median_speed_m_s", rounded(t.speeds.median_m_s)},
           {"highest_speed_m_s", rounded(t.speeds.range.highest_m_s)},
           {"spread", rounded(t.request.spread)},
           {"largest_offset_deg", rounded(degrees(t.largest_offset_rad))},
           {"canards_balance_deg", rounded(degrees(t.reach_rad))},
           {"before", judged(t.before)},
           {"after", t.after ? judged(*t.after) : Json{}}};
  all["alternative"] = t.alternative.empty() ? Json{} : Json{t.alternative};
  if (t.after) {
    all["flown_before"] = total(t.flown_before());
    all["flown_after"] = total(t.flown_after());
  }
  all["outside_model"] = json::text_or_null(model_sentence(t));
  all["flights"] = flights;
  result::put_answer(all, answer(t), t.after ? flights_sentence(t) : t.why_none, made);
  return all.pretty();
}

}  // namespace fantail::tune
