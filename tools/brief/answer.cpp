// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include "brief/brief.hpp"
#include "brief/sentences.hpp"
#include "hal/signal_pattern.hpp"
#include "json/value.hpp"
#include "text/bearing.hpp"
#include "text/number.hpp"

namespace fantail::brief {
namespace {

using result::Cell;
using namespace result::units;
using B = Brief;

constexpr result::Unit kg{"_kg", "kg"}, n_s{"_n_s", "N s"};

Cell cell(const std::optional<double>& value) { return value ? Cell{*value} : Cell{}; }
Cell of_start(const B& b, double Moment::* member) {
  return b.nominal.control_start ? Cell{(*b.nominal.control_start).*member} : Cell{};
}
Cell of_landing(const B& b, std::optional<double> Landing::* member) {
  return b.landing ? cell((*b.landing).*member) : Cell{};
}
Cell of_fall(const B& b, double Landing::* member) { return b.landing ? Cell{(*b.landing).*member} : Cell{}; }

constexpr auto brief_fields = result::fields<B>({
    {"length", "length", m, 2, &B::length_m, "of the rocket; null: the vehicle does not say"},
    {"diameter", "diameter", m, 3, &B::diameter_m, "of the body; null: the vehicle does not say"},
    {"mass", "lift-off mass", kg, 2, &B::mass_kg, "at lift-off, propellant included"},
    {"impulse", "total impulse", n_s, 0, &B::impulse_n_s, "of the motor"},
    {"motor_class", "motor class", none, 0, &B::motor_class, "letter of the total impulse"},
    {"guide_length", "guide", m, 1, &B::guide_length_m, "length of the launch guide"},
    {"guide_tilt", "guide tilt", deg, 1, &B::guide_tilt_rad, "of the launch guide from the vertical"},
    {"guide_azimuth", "guide azimuth", deg, 0, [](const B& b) { return Cell{text::bearing_rad(b.guide_azimuth_rad)}; },
     "where the guide leans to, from north over east"},
    {"guide_exit_speed", "speed at guide exit", m_s, 1, [](const B& b) { return Cell{b.nominal.guide_exit.speed_m_s}; },
     "when the rocket leaves the guide"},
    {"apogee", "apogee", m, 0, [](const B& b) { return Cell{b.nominal.apogee_m}; }, "above the site"},
    {"top_speed", "top speed over ground", m_s, 0, [](const B& b) { return Cell{b.nominal.top_speed_m_s}; },
     "over ground in six degrees of freedom, else along the guide's line"},
    {"wind", "wind flown", m_s, 1, [](const B& b) { return b.is_six_dof ? Cell{b.wind_m_s} : Cell{}; },
     "at its reference height; null: wind is not flown"},
    {"wind_from", "wind from", deg, 0,
     [](const B& b) { return b.is_six_dof ? Cell{text::bearing_rad(b.wind_from_rad)} : Cell{}; },
     "where that wind comes from"},
    {"wind_passed", "wind passed", m_s, 0,
     [](const B& b) { return b.wind_limit ? cell(b.wind_limit->passed_m_s) : Cell{}; },
     "largest wind tried up to which control stays within the roll model and the tilt limit does not end it early; "
     "null: none, or not computed"},
    {"control_start", "control begins", s, 2, [](const B& b) { return of_start(b, &Moment::time_s); },
     "after lift-off; null: control never begins"},
    {"control_start_height", "at a height of", m, 0, [](const B& b) { return of_start(b, &Moment::height_m); },
     "height at that time"},
    {"control_start_speed", "at a speed of", m_s, 0, [](const B& b) { return of_start(b, &Moment::speed_m_s); },
     "speed at that time"},
    {"landing", "landing", m, 0, [](const B& b) { return of_landing(b, &Landing::healthy_m); },
     "under the parachute, from the foot of the guide; null: not computed"},
    {"landing_bearing", "landing bearing", deg, 0,
     [](const B& b) {
       const auto bearing_rad = b.landing ? b.landing->healthy_bearing_rad : std::nullopt;
       return bearing_rad ? Cell{text::bearing_rad(*bearing_rad)} : Cell{};
     },
     "of that place, from north over east"},
    {"landing_failed", "landing, failed canard", m, 0, [](const B& b) { return of_landing(b, &Landing::failed_m); },
     "the farthest landing under the parachute of all flights with a failed canard"},
    {"fall", "fall without parachute", m, 0, [](const B& b) { return of_fall(b, &Landing::healthy_fall_m); },
     "from the foot of the guide, of a fall without parachute, drag, lift and wind"},
    {"fall_failed", "the same, failed canard", m, 0, [](const B& b) { return of_fall(b, &Landing::failed_fall_m); },
     "the farthest of all flights with a failed canard"},
    {"failure_flights", "flights with a failed canard", none, 0,
     [](const B& b) { return b.landing ? Cell{std::uint64_t{b.landing->flights}} : Cell{}; }, "how many were flown"},
    {"failure_flights_without_landing", "of these without a landing", none, 0,
     [](const B& b) {
       return b.landing && b.landing->has_parachute ? Cell{std::uint64_t{b.landing->failed_without_landing}} : Cell{};
     },
     "how many of them did not reach the ground under the parachute; null: there is none"},
    {"failure_step", "between two failures", s, 2, [](const B& b) { return of_fall(b, &Landing::step_s); },
     "time between the instants at which a canard fails"},
});

result::Data signal_data() {
  json::Value all = json::Value::array();
  for (const SignalMeaning& one : signal_meanings()) {
    const hal::SignalPattern pattern = hal::pattern(one.signal);
    all.push_back({{"phase", std::string{one.phase}},
                   {"light", std::string{pattern.light}},
                   {"sound", std::string{pattern.sound}},
                   {"meaning", std::string{one.meaning}}});
  }
  return {"signals", all};
}

result::Data rule_data(const std::optional<Rules>& rules) {
  if (!rules) {
    return {"rules", {}};
  }
  json::Value clauses = json::Value::array();
  for (const Rules::Clause& clause : rules->clauses) {
    clauses.push_back({{"id", clause.id}, {"outcome", clause.outcome}});
  }
  return {"rules",
          {{"pack", rules->pack},
           {"sentence", rules->sentence},
           {"flown", rules->flown},
           {"caution", rules->caution},
           {"clauses", clauses}}};
}

std::vector<std::string> rule_sentences(const std::optional<Rules>& rules) {
  if (!rules) {
    return {"rules: not checked (--rules PACK)"};
  }
  std::vector<std::string> all{fmt::format("{}: {}", rules->pack, rules->sentence), rules->flown, rules->caution};
  std::erase(all, "");
  return all;
}

}  // namespace

std::vector<result::Listed> listed_fields() { return {result::listed("", brief_fields)}; }

result::Document answer(const Brief& of, const result::Made& made) {
  using enum result::Readers;
  return {
      .kind = "brief for the range safety officer",
      .title = of.vehicle,
      .subtitle = fmt::format("scenario {}, plan {}", of.scenario, of.plan_name),
      .verdict = {.answer = result::Answer::none, .heading = "Simulated only", .sentence = headline(of)},
      .facts = {{"scenario", "", of.scenario},
                {"vehicle", "", of.vehicle},
                {"plan", "", of.plan_name},
                {"why_no_landing", "", json::text_or_null(of.why_no_landing)},
                {"version", "version", made.version},
                {"command", "command", made.command}},
      .sections = {{"Figures", {result::figures("", of, brief_fields)}},
                   {"Wind limit", {result::Sentences{"wind_limit", wind_sentences(of)}}},
                   {"Where it comes down", {result::Sentences{"where_it_comes_down", landing_sentences(of)}}},
                   {"When canards may move", {result::Sentences{"gate", gate_sentences(of)}}},
                   {"What ends control", {result::Sentences{"ends_control", end_sentences(of)}}},
                   {"Abort input", {result::Sentences{"abort_input", {abort_sentence(of.plan.run.abort_input)}}}},
                   {"To disarm", {result::Sentences{"to_disarm", disarm_sentences(of.plan.run.abort_input)}}, files},
                   {"Rules", {result::Sentences{{}, rule_sentences(of.rules)}}},
                   {"For programs", {signal_data(), rule_data(of.rules)}, programs}},
      .made = made};
}

}  // namespace fantail::brief
