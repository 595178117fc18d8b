// SPDX-License-Identifier: MIT
#include "telemetry/panel.hpp"

#include <fmt/core.h>

#include "replies/sentence.hpp"
#include "text/layout.hpp"

namespace fantail::telemetry {
namespace {

constexpr std::size_t events_shown = 5;

std::string cell(const std::optional<double>& value, int digits = 2) {
  if (!value) {
    return "-";
  }
  std::string text = fmt::format("{:+.{}f}", *value, digits);
  if (text.find_first_not_of("-0.") == std::string::npos) {
    text.front() = '+';  // nothing is not less than nothing
  }
  return text;
}

std::string unsigned_cell(const std::optional<double>& value, int digits = 2) {
  return value ? fmt::format("{:.{}f}", *value, digits) : "-";
}

// "+5.20 of 9.00 deg": all canards are seldom limited differently, so the smallest limit is the one that matters.
std::optional<double> smallest(const Each<std::optional<double>>& limits) {
  std::optional<double> least;
  for (const auto& limit : limits) {
    if (limit && (!least || *limit < *least)) {
      least = limit;
    }
  }
  return least;
}

}  // namespace

void Panel::look(hal::Microseconds now) {
  now_ = now;
  receiver_.look(now);
  news_ = receiver_.take_events();
  for (const Heard<Event>& event : news_) {
    newest_events_.push_back(event);
  }
  while (newest_events_.size() > events_shown) {
    newest_events_.pop_front();
  }
}

template <typename Content>
std::string Panel::age_text(const std::optional<Heard<Content>>& heard) const {
  if (!heard) {
    return "never received";
  }
  return is_stale(heard) ? fmt::format("STALE, {:.1f} s old", in_seconds(now_ - heard->came)) : "live";
}

std::string Panel::link_state() const {
  const auto& state = receiver_.state();
  if (!state) {
    return "SILENT";
  }
  return is_stale(state) ? fmt::format("STALE for {:.1f} s", in_seconds(now_ - state->came)) : "live";
}

std::string Panel::motion_text() const {
  const State& state = receiver_.state()->content;
  const auto& canards = receiver_.canards();
  const auto limit_rad = canards ? smallest(canards->content.limit_rad) : std::nullopt;
  return fmt::format(
      "motion  {}\n"
      "  phase {} ({}){}\n"
      "  roll {} deg, rate {} deg/s; reference {} deg, excitation {} deg\n"
      "  command {} of {} deg{}\n"
      "  height {} m, speed {} m/s along the guide, specific force {} m/s2\n",
      age_text(receiver_.state()), core::name(state.phase), core::name(state.reason),
      state.timing_fault ? ", TIMING FAULT" : "", cell(degrees(state.roll_angle_rad)),
      cell(degrees(state.roll_rate_rad_s)), cell(degrees(state.reference_rad)), cell(degrees(state.excitation_rad)),
      cell(degrees(state.command_rad)), unsigned_cell(degrees(limit_rad)), state.saturated ? ", SATURATED" : "",
      cell(state.height_m, 1), cell(state.speed_m_s, 1), cell(state.specific_force_m_s2));
}

std::string Panel::canards_text() const {
  std::string text = fmt::format("canards  {}\n", age_text(receiver_.canards()));
  if (!receiver_.canards()) {
    return text;
  }
  const Canards& canards = receiver_.canards()->content;
  text += "  canard  command   encoder  difference   limit  verdict\n";
  for (std::size_t i = 0; i < core::canard_count; ++i) {
    const auto command = degrees(canards.command_rad[i]);
    const auto encoder = degrees(canards.encoder_rad[i]);
    const auto difference = command && encoder ? std::optional{*encoder - *command} : std::nullopt;
    text += fmt::format("  {:>6} {:>8}  {:>8}    {:>8}  {:>6}  {}{}\n", i + 1, cell(command), cell(encoder),
                        cell(difference), unsigned_cell(degrees(canards.limit_rad[i])),
                        canards.verdicts[i] ? core::name(*canards.verdicts[i]) : "unknown",
                        canards.limited[i] ? ", limited" : "");
  }
  return text;
}

std::string Panel::health_text() const {
  std::string text = fmt::format("health  {}\n", age_text(receiver_.health()));
  if (!receiver_.health()) {
    return text;
  }
  const Health& health = receiver_.health()->content;
  text += fmt::format("  gyro {}, accelerometer {}", name(health.gyro), name(health.accelerometer));
  if (health.longest_tick_s) {
    text += fmt::format(", longest tick {:.0f} us", 1e6 * *health.longest_tick_s);
  }
  if (health.late_ticks) {
    text += fmt::format(", {} late ticks", *health.late_ticks);
  }
  text += "\n";
  if (health.bus) {
    text += fmt::format("  avionics' CAN bus: {}, {} unsent, {} overrun, {} bus errors\n",
                        replies::name(health.bus->state), health.bus->unsent, health.bus->overrun, health.bus->errors);
  }
  if (health.gateway) {
    text += fmt::format("  gateway's CAN bus: {}, {} frames, {} lost, {} damaged, {} foreign, {} overrun\n",
                        replies::name(health.gateway->state), health.gateway->frames, health.gateway->lost,
                        health.gateway->damaged, health.gateway->foreign, health.gateway->overrun);
  }
  return text;
}

std::string Panel::channels_text(std::size_t columns) const {
  const double span_s = in_seconds(receiver_.recent_span());
  text::Table table{
      {{""}, {"per s"}, {"received"}, {"lost"}, {"late"}, {"duplicate", 2}, {"ignored", 1}, {"unreadable", 3}}};
  table.row({fmt::format("link, last {:.0f} s     ", span_s), "per s", "  received", "    lost", "    late",
             "  duplicate", "  ignored", "  unreadable"});
  for (std::size_t i = 0; i < channel_count; ++i) {
    const auto channel = static_cast<Channel>(i);
    const ChannelFigures recent = receiver_.recent(channel);
    const double per_s = span_s > 0.0 ? static_cast<double>(recent.received) / span_s : 0.0;
    table.row({fmt::format("  {:<17}", name(channel)), fmt::format(" {:>7.1f}", per_s),
               fmt::format("  {:>8}", recent.received), fmt::format("  {:>6}", lost_lately(recent)),
               fmt::format("  {:>6}", recent.late), fmt::format("  {:>9}", recent.duplicate),
               fmt::format("  {:>7}", recent.ignored), fmt::format("  {:>10}", recent.unreadable)});
  }
  return table.text(columns);
}

std::string Panel::table(std::size_t columns) const {
  std::string text = fmt::format("{}  {}", url_, link_state());
  if (!receiver_.state()) {
    return text + ": nothing received yet\n" + channels_text(columns);
  }
  text += fmt::format(", {:.2f} s since power-up\n", in_seconds(receiver_.state()->stamp.time));
  text += motion_text() + canards_text() + health_text() + channels_text(columns);
  for (const Heard<Event>& event : newest_events_) {
    text += fmt::format("event  {:.3f} s  {}\n", in_seconds(event.stamp.time), event_text(event.content));
  }
  return text;
}

std::string Panel::lines() const {
  std::string text;
  for (const Heard<Event>& event : news_) {
    text += fmt::format("{:.3f} s  event: {}\n", in_seconds(event.stamp.time), event_text(event.content));
  }
  ChannelFigures recent;
  for (std::size_t i = 0; i < channel_count; ++i) {
    const ChannelFigures one = receiver_.recent(static_cast<Channel>(i));
    recent.received += one.received;
    recent.lost += lost_lately(one);
    recent.late += one.late;
    recent.duplicate += one.duplicate;
    recent.ignored += one.ignored;
    recent.unreadable += one.unreadable;
  }
  const std::string odd = recent.ignored + recent.unreadable > 0
                              ? fmt::format(", {} ignored, {} unreadable", recent.ignored, recent.unreadable)
                              : "";
  const std::string link = fmt::format("link: {}, {} received, {} lost, {} late, {} duplicate{} in {:.0f} s\n",
                                       link_state(), recent.received, recent.lost, recent.late, recent.duplicate, odd,
                                       in_seconds(receiver_.recent_span()));
  if (!receiver_.state()) {
    return text + link;
  }
  const State& state = receiver_.state()->content;
  return text + fmt::format(
                    "{:.3f} s  {}{} ({}), roll {} deg, rate {} deg/s, command {} deg{}, height {} m, speed {} "
                    "m/s along the guide; {}",
                    in_seconds(receiver_.state()->stamp.time), is_stale(receiver_.state()) ? "STALE: " : "",
                    core::name(state.phase), core::name(state.reason), cell(degrees(state.roll_angle_rad)),
                    cell(degrees(state.roll_rate_rad_s)), cell(degrees(state.command_rad)),
                    state.saturated ? " saturated" : "", cell(state.height_m, 1), cell(state.speed_m_s, 1), link);
}

}  // namespace fantail::telemetry
