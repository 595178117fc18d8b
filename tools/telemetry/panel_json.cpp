// SPDX-License-Identifier: MIT
#include "json/value.hpp"
#include "replies/sentence.hpp"
#include "telemetry/panel.hpp"

namespace fantail::telemetry {
namespace {

using Json = json::Value;

// As many digits as a person can use; the messages themselves have all.
Json rounded(const std::optional<double>& value) { return json::printed(value, 4); }

template <typename Content>
Json section(const std::optional<Heard<Content>>& heard, hal::Microseconds now) {
  Json json;
  json["stale"] = !heard || now - heard->came > Receiver::stale_after;
  json["age_s"] = heard ? rounded(in_seconds(now - heard->came)) : Json{};
  json["time_s"] = heard ? Json(in_seconds(heard->stamp.time)) : Json{};
  json["sequence"] = heard ? Json(heard->stamp.sequence) : Json{};
  return json;
}

template <typename Content>
const Content& content_or_nothing(const std::optional<Heard<Content>>& heard) {
  static const Content nothing{};
  return heard ? heard->content : nothing;
}

Json state_json(const std::optional<Heard<State>>& heard, hal::Microseconds now) {
  Json json = section(heard, now);
  const State& state = content_or_nothing(heard);
  json["phase"] = heard ? Json(core::name(state.phase)) : Json{};
  json["reason"] = heard ? Json(core::name(state.reason)) : Json{};
  json["roll_angle_deg"] = rounded(degrees(state.roll_angle_rad));
  json["roll_rate_deg_s"] = rounded(degrees(state.roll_rate_rad_s));
  json["reference_deg"] = rounded(degrees(state.reference_rad));
  json["excitation_deg"] = rounded(degrees(state.excitation_rad));
  json["command_deg"] = rounded(degrees(state.command_rad));
  json["saturated"] = heard ? Json(state.saturated) : Json{};
  json["timing_fault"] = heard ? Json(state.timing_fault) : Json{};
  json["specific_force_m_s2"] = rounded(state.specific_force_m_s2);
  json["height_m"] = rounded(state.height_m);
  json["speed_m_s"] = rounded(state.speed_m_s);
  json["vertical_speed_m_s"] = rounded(state.vertical_speed_m_s);
  json["tilt_deg"] = rounded(degrees(state.tilt_rad));
  return json;
}

Json canards_json(const std::optional<Heard<Canards>>& heard, hal::Microseconds now) {
  Json json = section(heard, now);
  const Canards& canards = content_or_nothing(heard);
  json["canard_deg"] = rounded(degrees(canards.canard_rad));
  json["each"] = Json::array();
  for (std::size_t i = 0; i < core::canard_count; ++i) {
    json["each"].push_back({{"command_deg", rounded(degrees(canards.command_rad[i]))},
                            {"encoder_deg", rounded(degrees(canards.encoder_rad[i]))},
                            {"limit_deg", rounded(degrees(canards.limit_rad[i]))},
                            {"verdict", canards.verdicts[i] ? Json(core::name(*canards.verdicts[i])) : Json{}},
                            {"limited", heard ? Json(canards.limited[i]) : Json{}}});
  }
  return json;
}

Json health_json(const std::optional<Heard<Health>>& heard, hal::Microseconds now) {
  Json json = section(heard, now);
  const Health& health = content_or_nothing(heard);
  json["gyro"] = heard ? Json(name(health.gyro)) : Json{};
  json["accelerometer"] = heard ? Json(name(health.accelerometer)) : Json{};
  json["longest_tick_us"] = health.longest_tick_s ? Json(1e6 * *health.longest_tick_s) : Json{};
  json["late_ticks"] = health.late_ticks;
  json["bus"] = Json{};
  if (health.bus) {
    json["bus"] = {{"state", replies::name(health.bus->state)},
                   {"unsent", health.bus->unsent},
                   {"overrun", health.bus->overrun},
                   {"errors", health.bus->errors}};
  }
  json["gateway"] = Json{};
  if (health.gateway) {
    json["gateway"] = {{"state", replies::name(health.gateway->state)},
                       {"frames", health.gateway->frames},
                       {"lost", health.gateway->lost},
                       {"damaged", health.gateway->damaged},
                       {"foreign", health.gateway->foreign},
                       {"overrun", health.gateway->overrun}};
  }
  return json;
}

Json figures_json(const ChannelFigures& figures, std::int64_t lost) {
  return {{"received", figures.received}, {"lost", lost},
          {"late", figures.late},         {"duplicate", figures.duplicate},
          {"ignored", figures.ignored},   {"unreadable", figures.unreadable}};
}

}  // namespace

std::string Panel::json() const {
  Json json;
  json["url"] = url_;
  const auto& state = receiver_.state();
  json["link"] = !state ? "silent" : (is_stale(state) ? "stale" : "live");
  json["run"] = state ? Json(state->stamp.run) : Json{};
  json["restarts"] = receiver_.restarts();
  json["state"] = state_json(state, now_);
  json["canards"] = canards_json(receiver_.canards(), now_);
  json["health"] = health_json(receiver_.health(), now_);
  json["recent_s"] = rounded(in_seconds(receiver_.recent_span()));
  for (std::size_t i = 0; i < channel_count; ++i) {
    const auto channel = static_cast<Channel>(i);
    const ChannelFigures& total = receiver_.total(channel);
    const ChannelFigures recent = receiver_.recent(channel);
    json["channels"][name(channel)] = {{"total", figures_json(total, total.lost)},
                                       {"recent", figures_json(recent, lost_lately(recent))}};
  }
  json["events"] = Json::array();
  for (const Heard<Event>& event : news_) {
    json["events"].push_back({{"time_s", in_seconds(event.stamp.time)}, {"text", event_text(event.content)}});
  }
  return json.dump() + "\n";
}

}  // namespace fantail::telemetry
