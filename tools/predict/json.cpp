// SPDX-License-Identifier: MIT
#include "json/value.hpp"
#include "predict/results.hpp"
#include "predict/sentences.hpp"

namespace fantail::predict {
namespace {

using Json = json::Value;
using json::rounded;
using text::degrees;

Json json(const Quantiles& s, double scale = 1.0) {
  return {{"mean", rounded(scale * s.mean)},
          {"p5", rounded(scale * s.p5)},
          {"p50", rounded(scale * s.p50)},
          {"p95", rounded(scale * s.p95)}};
}

Json json(const std::optional<Quantiles>& s, double scale = 1.0) { return s ? json(*s, scale) : Json{}; }

Json json(const Share& s) {
  return {{"count", s.count},
          {"of", s.of},
          {"share", rounded(s.value)},
          {"low", rounded(s.low)},
          {"high", rounded(s.high)}};
}

Json json(const MarginsAtSpeed& at) {
  return {{"speed_m_s", rounded(at.speed_m_s)},
          {"phase_margin_deg", json(at.phase_margin_rad, degrees(1.0))},
          {"crossover_rad_s", json(at.crossover_rad_s)},
          {"gain_margin", json(at.gain_margin)}};
}

Json stability(const Prediction& p) {
  Json over_speed = Json::array();
  for (const MarginsAtSpeed& at : p.over_speed) {
    over_speed.push_back(json(at));
  }
  return {{"servo_lag_s", rounded(p.servo_lag_s)},
          {"delay_s", rounded(p.delay_s)},
          {"worst", p.worst_speed ? json(*p.worst_speed) : Json{}},
          {"over_speed", over_speed}};
}

Json criteria(const Decision& decision) {
  Json all = Json::array();
  for (const Criterion& c : decision.criteria) {
    all.push_back({{"criterion", c.key},
                   {"judgement", name(c.judgement)},
                   {"found", c.found},
                   {"required", c.required},
                   {"sentence", c.clause}});
  }
  return all;
}

Json resonance(const Prediction& p) {
  if (!p.resonance) {
    return {};
  }
  const RollResonance& r = *p.resonance;
  return {
      {"pitch_frequency_per_speed_rad_m", Json::array({rounded(r.least_frequency_1_m), rounded(r.most_frequency_1_m)})},
      {"resonant_deg", json(r.resonant_rad, degrees(1.0))},
      {"near_runs", r.near},
      {"past_runs", r.past},
      {"with_canards_runs", r.with_canards},
      {"warning", resonance_warning(p)}};
}

Json tunnel(const Prediction& p) {
  return {{"file", p.tunnel.name},
          {"steps", p.tunnel.steps.size()},
          {"swirl_deg", rounded(degrees(p.tunnel.swirl_rad))},
          {"sources", p.tunnel.sources},
          {"vehicle", p.tunnel.vehicle ? Json{*p.tunnel.vehicle} : Json{}},
          {"reference_area_m2", p.tunnel.reference_area_m2 ? Json{*p.tunnel.reference_area_m2} : Json{}},
          {"area_factor", p.area ? Json::array({rounded(p.area->low), rounded(p.area->high)}) : Json{}},
          {"damping_factor", Json::array({p.damping.low, p.damping.high})}};
}

}  // namespace

std::string prediction_json(const Prediction& p, const Decision& decision, std::string_view version) {
  const double in_degrees = degrees(1.0);
  Json all = {{"scenario", p.scenario},
              {"vehicle", p.vehicle},
              {"plan", p.plan_name},
              {"seed", p.seed},
              {"changes", p.request.changes},
              {"repeat_run", repeat_command(p, "RUN")},
              {"runs", p.runs.size()},
              {"go", decision.go},
              {"verdict", decision.text},
              {"cautions", decision.cautions},
              {"not_in_verdict", not_in_verdict(p)},
              {"criteria", criteria(decision)},
              {"advice", decision.advice},
              {"tunnel", tunnel(p)},
              {"canard_limit_deg", rounded(degrees(p.reach.angle_rad))},
              {"offset_size_deg", json(p.offset_size_rad, in_degrees)},
              {"authority_margin_deg", json(p.authority_margin_rad, in_degrees)},
              {"authority", json(p.authority)},
              {"held", json(p.held)},
              {"not_judged", p.not_judged},
              {"without_control", p.without_control},
              {"outside_model", p.outside_model},
              {"rest_limit_deg", rounded(degrees(p.flown.rest_limit_rad))},
              {"settle_deg", json(p.settle_rad, in_degrees)},
              {"settle_reference_deg", json(p.settle_reference_rad, in_degrees)},
              {"settle_off_deg", json(p.settle_off_rad, in_degrees)},
              {"saturated_share", json(p.saturated_share)},
              {"spin_rate_deg_s", json(p.spin_rate_rad_s, in_degrees)},
              {"top_speed_m_s", json(p.top_speed_m_s)},
              {"apogee_m", json(p.apogee_m)},
              {"drift_m", json(p.drift_m)},
              {"wind_m_s", json(p.wind_m_s)},
              {"stability", stability(p)},
              {"roll_resonance", resonance(p)},
              {"flight_notes", p.flight_notes},
              {"basis", basis(p)},
              {"version", version}};
  json::keep_exact(all, "seed");
  return all.pretty();
}

}  // namespace fantail::predict
