// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "bench/words.hpp"
#include "telemetry/panel.hpp"
#include "telemetry/panel_values.hpp"
#include "telemetry/words.hpp"

namespace fantail::telemetry {
namespace {

using nlohmann::ordered_json;

template <typename Value>
ordered_json known(const std::optional<Value>& value) {
  return value ? ordered_json(*value) : ordered_json{};
}

// As many digits as a person can use; the messages themselves have all.
ordered_json rounded(const std::optional<double>& value) {
  return value ? ordered_json::parse(fmt::format("{:.4f}", *value)) : ordered_json{};
}

template <typename Content>
ordered_json section(const std::optional<Heard<Content>>& heard, hal::Microseconds now) {
  ordered_json json;
  json["stale"] = !heard || now - heard->came > Receiver::stale_after;
  json["age_s"] = heard ? rounded(in_seconds(now - heard->came)) : ordered_json{};
  json["time_s"] = heard ? ordered_json(in_seconds(heard->stamp.time)) : ordered_json{};
  json["sequence"] = heard ? ordered_json(heard->stamp.sequence) : ordered_json{};
  return json;
}

template <typename Content>
const Content& content_or_nothing(const std::optional<Heard<Content>>& heard) {
  static const Content nothing{};
  return heard ? heard->content : nothing;
}

ordered_json state_json(const std::optional<Heard<State>>& heard, hal::Microseconds now) {
  ordered_json json = section(heard, now);
  const State& state = content_or_nothing(heard);
  json["phase"] = heard ? ordered_json(core::name(state.phase)) : ordered_json{};
  json["reason"] = heard ? ordered_json(core::name(state.reason)) : ordered_json{};
  json["roll_angle_deg"] = rounded(degrees(state.roll_angle_rad));
  json["roll_rate_deg_s"] = rounded(degrees(state.roll_rate_rad_s));
  json["reference_deg"] = rounded(degrees(state.reference_rad));
  json["excitation_deg"] = rounded(degrees(state.excitation_rad));
  json["command_deg"] = rounded(degrees(state.command_rad));
  json["saturated"] = heard ? ordered_json(state.saturated) : ordered_json{};
  json["timing_fault"] = heard ? ordered_json(state.timing_fault) : ordered_json{};
  json["specific_force_m_s2"] = rounded(state.specific_force_m_s2);
  json["height_m"] = rounded(state.height_m);
  json["speed_m_s"] = rounded(state.speed_m_s);
  json["vertical_speed_m_s"] = rounded(state.vertical_speed_m_s);
  json["tilt_deg"] = rounded(degrees(state.tilt_rad));
  return json;
}

ordered_json canards_json(const std::optional<Heard<Canards>>& heard, hal::Microseconds now) {
  ordered_json json = section(heard, now);
  const Canards& canards = content_or_nothing(heard);
  json["canard_deg"] = rounded(degrees(canards.canard_rad));
  json["each"] = ordered_json::array();
  for (std::size_t i = 0; i < core::canard_count; ++i) {
    json["each"].push_back(
        {{"command_deg", rounded(degrees(canards.command_rad[i]))},
         {"encoder_deg", rounded(degrees(canards.encoder_rad[i]))},
         {"limit_deg", rounded(degrees(canards.limit_rad[i]))},
         {"verdict", canards.verdicts[i] ? ordered_json(core::name(*canards.verdicts[i])) : ordered_json{}},
         {"limited", heard ? ordered_json(canards.limited[i]) : ordered_json{}}});
  }
  return json;
}

ordered_json health_json(const std::optional<Heard<Health>>& heard, hal::Microseconds now) {
  ordered_json json = section(heard, now);
  const Health& health = content_or_nothing(heard);
  json["gyro"] = heard ? ordered_json(name(health.gyro)) : ordered_json{};
  json["accelerometer"] = heard ? ordered_json(name(health.accelerometer)) : ordered_json{};
  json["longest_tick_us"] = health.longest_tick_s ? ordered_json(1e6 * *health.longest_tick_s) : ordered_json{};
  json["late_ticks"] = known(health.late_ticks);
  json["bus"] = ordered_json{};
  if (health.bus) {
    json["bus"] = {{"state", bench::words(health.bus->state)},
                   {"unsent", health.bus->unsent},
                   {"overrun", health.bus->overrun},
                   {"errors", health.bus->errors}};
  }
  json["gateway"] = ordered_json{};
  if (health.gateway) {
    json["gateway"] = {{"state", bench::words(health.gateway->state)},
                       {"frames", health.gateway->frames},
                       {"lost", health.gateway->lost},
                       {"damaged", health.gateway->damaged},
                       {"foreign", health.gateway->foreign},
                       {"overrun", health.gateway->overrun}};
  }
  return json;
}

ordered_json figures_json(const ChannelFigures& figures, std::int64_t lost) {
  return {{"received", figures.received}, {"lost", lost},
          {"late", figures.late},         {"duplicate", figures.duplicate},
          {"ignored", figures.ignored},   {"unreadable", figures.unreadable}};
}

}  // namespace

std::string Panel::json() const {
  ordered_json json;
  json["url"] = url_;
  const auto& state = receiver_.state();
  json["link"] = !state ? "silent" : (is_stale(state) ? "stale" : "live");
  json["run"] = state ? ordered_json(state->stamp.run) : ordered_json{};
  json["restarts"] = receiver_.restarts();
  json["state"] = state_json(state, now_);
  json["canards"] = canards_json(receiver_.canards(), now_);
  json["health"] = health_json(receiver_.health(), now_);
  json["recent_s"] = rounded(in_seconds(receiver_.recent_span()));
  for (std::size_t i = 0; i < channel_count; ++i) {
    const auto channel = static_cast<Channel>(i);
    const ChannelFigures& total = receiver_.total(channel);
    const ChannelFigures recent = receiver_.recent(channel);
    json["channels"][std::string{name(channel)}] = {{"total", figures_json(total, total.lost)},
                                                    {"recent", figures_json(recent, lost_lately(recent))}};
  }
  json["events"] = ordered_json::array();
  for (const Heard<Event>& event : news_) {
    json["events"].push_back({{"time_s", in_seconds(event.stamp.time)}, {"text", words(event.content)}});
  }
  return json.dump() + "\n";
}

}  // namespace fantail::telemetry
