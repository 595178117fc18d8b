// SPDX-License-Identifier: MIT
#include "live/feed.hpp"

#include <algorithm>
#include <cctype>

#include <fmt/core.h>

#include "telemetry/panel.hpp"

namespace fantail::live {
namespace {

using Json = json::Value;
using telemetry::Channel;
using telemetry::degrees;
using telemetry::in_seconds;

Json angle(const std::optional<double>& radians) { return json::printed(degrees(radians), 2); }

bool is_flying(core::Phase phase) { return core::is_flight(phase) || phase == core::Phase::finished; }

std::string in_words(std::string_view name) {
  std::string words{name};
  std::ranges::replace(words, '_', ' ');
  return words;
}

/// "Launched: launch detected", "Canard 3: stalled, before: healthy".
std::string event_words(const telemetry::Event& event) {
  if (event.verdict) {
    return fmt::format("Canard {}: {}, before: {}", event.verdict->canard + 1,
                       in_words(core::name(event.verdict->verdict)), in_words(core::name(event.verdict->before)));
  }
  std::string words = in_words(core::name(event.phase->phase));
  words.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(words.front())));
  return fmt::format("{}: {}", words, in_words(core::name(event.phase->reason)));
}

Json told(double time_s, const std::string& text) { return {{"time_s", time_s}, {"text", text}}; }

}  // namespace

void Feed::take(std::string_view channel, std::span<const std::byte> bytes, hal::Microseconds now) {
  const std::scoped_lock lock{mutex_};
  first_came_ = first_came_.value_or(now);
  receiver_.take(channel, bytes, now);
  follow_state();
  follow_events();
}

void Feed::follow_state() {
  const auto& state = receiver_.state();
  if (!state) {
    return;
  }
  if (run_ != state->stamp.run) {
    run_ = state->stamp.run;
    plots_.clear();
    launched_.reset();
    phase_.reset();
    events_.clear();
    untold_events_ = 0;
  }
  const auto& canards = receiver_.canards();
  plots_.add(state->stamp.time, sample_of(state->content, canards ? canards->content.canard_rad : std::nullopt));
  const core::Phase phase = state->content.phase;
  if (!is_flying(phase)) {
    launched_.reset();
  } else if (!launched_ && phase_ && !is_flying(*phase_)) {
    launched_ = state->stamp.time;  // the event itself was lost, or comes behind
  }
  phase_ = phase;
}

void Feed::follow_events() {
  for (const telemetry::Heard<telemetry::Event>& event : receiver_.take_events()) {
    if (run_ && event.stamp.run != *run_) {
      continue;
    }
    if (event.content.phase && event.content.phase->phase == core::Phase::launched) {
      launched_ = event.stamp.time;
    }
    events_.push_back({in_seconds(event.stamp.time), event_words(event.content)});
    untold_events_ += 1;
  }
  while (events_.size() > most_events) {
    events_.pop_front();
  }
  untold_events_ = std::min(untold_events_, events_.size());
}

void Feed::end() {
  const std::scoped_lock lock{mutex_};
  ended_ = true;
}

std::string Feed::frame(hal::Microseconds now) {
  const std::scoped_lock lock{mutex_};
  receiver_.look(now);
  number_ += 1;
  Json frame = now_json(now);
  frame["plot"] = plots_.take_news();
  frame["events"] = Json::array();
  for (std::size_t i = events_.size() - untold_events_; i < events_.size(); ++i) {
    frame["events"].push_back(told(events_[i].time_s, events_[i].text));
  }
  untold_events_ = 0;
  return frame.dump();
}

std::string Feed::greeting(hal::Microseconds now) const {
  const std::scoped_lock lock{mutex_};
  Json frame = now_json(now);
  frame["source"] = source_.name;
  frame["settles_off_deg"] = angle(source_.settles_off_rad);
  frame["plot"] = plots_.all_told();
  frame["events"] = Json::array();
  for (std::size_t i = 0; i + untold_events_ < events_.size(); ++i) {
    frame["events"].push_back(told(events_[i].time_s, events_[i].text));
  }
  return frame.dump();
}

Json Feed::now_json(hal::Microseconds now) const {
  const auto& state = receiver_.state();
  Json json;
  json["frame"] = number_;
  json["link"] = link_json(now);
  json["ended"] = ended_ ? Json{source_.what_ends} : Json{};
  json["run"] = run_ ? Json{std::to_string(*run_)} : Json{};  // as text: a browser's numbers have 53 bits
  if (!state) {
    return json;
  }
  const telemetry::State& content = state->content;
  json["time_s"] = in_seconds(state->stamp.time);
  json["since_launch_s"] = launched_ ? Json{in_seconds(state->stamp.time - *launched_)} : Json{};
  json["phase"] = core::name(content.phase);
  json["reason"] = core::name(content.reason);
  json["roll_deg"] = angle(content.roll_angle_rad);
  json["rate_deg_s"] = angle(content.roll_rate_rad_s);
  json["reference_deg"] = angle(reference_in_force(content));
  json["command_deg"] = angle(content.command_rad);
  json["saturated"] = content.saturated;
  json["timing_fault"] = content.timing_fault;
  json["force_m_s2"] = json::printed(content.specific_force_m_s2, 1);
  json["height_m"] = json::printed(content.height_m, 1);
  json["speed_m_s"] = json::printed(content.speed_m_s, 1);
  json["tilt_deg"] = angle(content.tilt_rad);
  json["canards"] = canards_json();
  json["health"] = health_json();
  return json;
}

Json Feed::link_json(hal::Microseconds now) const {
  const auto& state = receiver_.state();
  telemetry::ChannelFigures recent;
  for (std::size_t i = 0; i < telemetry::channel_count; ++i) {
    const telemetry::ChannelFigures one = receiver_.recent(static_cast<Channel>(i));
    recent.received += one.received;
    recent.lost += telemetry::lost_lately(one);
    recent.late += one.late;
  }
  // Before the first message there was nothing to receive.
  const hal::Microseconds span =
      std::min(receiver_.recent_span(), first_came_ ? now - *first_came_ : hal::Microseconds{});
  const bool is_old = state && now - state->came > telemetry::Receiver::stale_after;
  return {{"is", !state   ? "silent"
                 : is_old ? "old"
                          : "live"},
          {"age_s", state ? json::printed(in_seconds(now - state->came), 1) : Json{}},
          {"span_s", json::printed(in_seconds(span), 1)},
          {"received", recent.received},
          {"lost", recent.lost},
          {"late", recent.late},
          {"restarts", receiver_.restarts()}};
}

Json Feed::canards_json() const {
  Json all = Json::array();
  const auto& heard = receiver_.canards();
  for (std::size_t i = 0; heard && i < core::canard_count; ++i) {
    const telemetry::Canards& canards = heard->content;
    all.push_back({{"command_deg", angle(canards.command_rad[i])},
                   {"encoder_deg", angle(canards.encoder_rad[i])},
                   {"limit_deg", angle(canards.limit_rad[i])},
                   {"limited", canards.limited[i]},
                   {"verdict", canards.verdicts[i] ? Json{core::name(*canards.verdicts[i])} : Json{}}});
  }
  return all;
}

Json Feed::health_json() const {
  const auto& heard = receiver_.health();
  if (!heard) {
    return {};
  }
  const telemetry::Health& health = heard->content;
  return {{"gyro", core::name(health.gyro)},
          {"accelerometer", core::name(health.accelerometer)},
          {"longest_tick_us", health.longest_tick_s ? json::printed(1e6 * *health.longest_tick_s, 0) : Json{}},
          {"late_ticks", health.late_ticks}};
}

}  // namespace fantail::live
