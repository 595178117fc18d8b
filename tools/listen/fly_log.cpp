// SPDX-License-Identifier: MIT
#include "listen/fly_log.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include <fmt/core.h>

#include "core/autopilot.hpp"
#include "listen/lift_off.hpp"
#include "listen/sensors.hpp"
#include "listen/sentences.hpp"
#include "logs/interpolator.hpp"
#include "text/error.hpp"

namespace fantail::listen {
namespace {

using core::Microseconds;

constexpr double tick_s = 1e-3;
constexpr Microseconds first_tick{1'000'000};  // any time but zero, as on a board
constexpr std::int64_t trace_every = 10;
constexpr double trace_before_s = 3.0;
constexpr double trace_after_s = 3.0;
constexpr std::size_t most_traced = 60'000;
// Before lift-off by the rule of lift_off.hpp the thrust is already there.
constexpr double early_s = 0.2;

Event event_of(double time_s, const core::TickRecord& record) {
  return {.time_s = time_s,
          .to = record.phase,
          .reason = record.reason,
          .height_m = static_cast<double>(record.motion.height_m),
          .speed_m_s = static_cast<double>(record.motion.speed_m_s),
          .tilt_rad = static_cast<double>(record.motion.tilt.radians())};
}

// The last event is Controlling, and the last Launched before it led there, with or without a wait for a gate.
void follow_control(Heard& heard, bool early) {
  if (early) {
    heard.early_control_s = heard.events.back().time_s;
    return;
  }
  if (!heard.detected_s) {
    heard.detected_s =
        std::ranges::find(heard.events.rbegin(), heard.events.rend(), core::Phase::launched, &Event::to)->time_s;
  }
  heard.control = heard.events.back();
}

void add_tick(Disagreement& disagreement, double time_s) {
  disagreement.first_s = disagreement.in_all_s == 0.0 ? time_s : disagreement.first_s;
  disagreement.in_all_s += tick_s;
}

// What the law does not do because two accelerometers differ. Beyond the guide nothing else holds control back
// (core/flight_phase.cpp).
void follow_disagreement(Heard& heard, double time_s, const core::TickRecord& record, bool is_new) {
  if (record.detection == core::DetectionState::disagreement && !heard.detected_s && time_s < listened_until_s(heard)) {
    add_tick(heard.no_hold, time_s);
  }
  const core::GuidePlan& guide = heard.flown.guide;
  if (record.phase == core::Phase::launched && !is_new &&
      record.motion.distance_along_guide_m >= guide.length_m + guide.clearance_m &&
      record.motion.speed_m_s > guide.minimum_speed_m_s) {
    add_tick(heard.no_control, time_s);
  }
}

// Detections, control and apogee, as the ticks go by.
void follow(Heard& heard, double time_s, const core::TickRecord& record) {
  const bool is_new = heard.events.empty() || heard.events.back().to != record.phase;
  if (is_new) {
    heard.events.push_back(event_of(time_s, record));
  }
  const bool early = !heard.lift_off_s || time_s < *heard.lift_off_s - early_s;
  if (is_new && record.phase == core::Phase::launched) {
    if (early) {
      heard.false_detections_s.push_back(time_s);
    } else if (!heard.detected_s) {
      heard.detected_s = time_s;
    }
  }
  if (is_new && record.phase == core::Phase::controlling) {
    follow_control(heard, early);
  }
  if (heard.lift_off_s && time_s >= *heard.lift_off_s) {
    follow_disagreement(heard, time_s, record, is_new);
  }
  if (early || !heard.detected_s) {
    heard.longest_rest_s =
        std::max(heard.longest_rest_s, static_cast<double>(core::seconds(record.motion.at_rest_for)));
  }
  if (!heard.control || heard.apogee_s) {
    return;
  }
  heard.is_lower_bound = record.motion.speed_is_lower_bound;
  if (static_cast<double>(record.motion.speed_m_s) > heard.fastest.value) {
    heard.fastest = {static_cast<double>(record.motion.speed_m_s), time_s};
  }
  if (record.motion.vertical_speed_m_s < 0.0F) {
    heard.apogee_s = time_s;
    heard.apogee_m = static_cast<double>(record.motion.height_m);
    heard.tilt_at_apogee_rad = static_cast<double>(record.motion.tilt.radians());
  }
}

void trace(Trace& trace, double time_s, const core::TickRecord& record) {
  trace.time_s.push_back(time_s);
  trace.axial_m_s2.push_back(static_cast<double>(record.motion.specific_force_m_s2.x));
  trace.height_m.push_back(static_cast<double>(record.motion.height_m));
  trace.speed_m_s.push_back(static_cast<double>(record.motion.speed_m_s));
  trace.tilt_rad.push_back(static_cast<double>(record.motion.tilt.radians()));
  trace.roll_rate_rad_s.push_back(static_cast<double>(record.motion.roll_rate_rad_s));
}

// Nothing is left to hear.
bool is_over(const Heard& heard, double time_s) {
  if (!heard.apogee_s || heard.events.back().to != core::Phase::finished) {
    return false;
  }
  return time_s > std::max(*heard.apogee_s, heard.log_height.apogee_s.value_or(*heard.apogee_s)) + trace_after_s;
}

// Many loggers are faster in the first seconds than on the pad and under the parachute.
double interval_around_s(const Signal& axial, double lift_off_s, double usual_s) {
  constexpr double before_s = 1.0;
  constexpr double after_s = 5.0;
  std::vector<double> time_s;
  std::ranges::copy_if(axial.time_s, std::back_inserter(time_s),
                       [&](double t) { return t >= lift_off_s - before_s && t <= lift_off_s + after_s; });
  return time_s.size() < 10 ? usual_s : logs::usual_interval_s(time_s);
}

void find_peaks(Heard& heard) {
  const double from_s = heard.lift_off_s.value_or(heard.log.begin_s());
  const double to_s = heard.log_height.apogee_s.value_or(heard.apogee_s.value_or(heard.log.end_s()));
  const auto peak = [&](const Signal& signal, double until_s, double largest) {
    std::optional<Peak> found;
    for (std::size_t i = 0; i < signal.time_s.size(); ++i) {
      const bool is_within = signal.time_s[i] >= from_s && signal.time_s[i] <= until_s && signal.value[i] <= largest;
      if (is_within && (!found || signal.value[i] > found->value)) {
        found = Peak{signal.value[i], signal.time_s[i]};
      }
    }
    return found;
  };
  heard.log_fastest = peak(heard.log.speed, to_s, std::numeric_limits<double>::infinity());
  // The charge that throws out the parachute pushes, too, but behind top speed.
  heard.hardest = peak(heard.log.axial, heard.control ? heard.fastest.time_s : to_s,
                       static_cast<double>(core::largest_specific_force_m_s2))
                      .value_or(Peak{});
}

void find_clipped(Heard& heard) {
  const ImuLog& log = heard.log;
  for (const auto& [what, signal] : {std::pair{"axial", &log.axial}, std::pair{"second_axial", &log.second_axial},
                                     std::pair{"lateral_y", &log.lateral_y}, std::pair{"lateral_z", &log.lateral_z},
                                     std::pair{"roll_rate", &log.roll_rate}, std::pair{"pitch_rate", &log.pitch_rate},
                                     std::pair{"yaw_rate", &log.yaw_rate}}) {
    for (const Side side : {Side::positive, Side::negative}) {
      if (const auto end = range_end(*signal, side)) {
        heard.clipped.push_back({what, *end});
      }
    }
  }
}

}  // namespace

Heard fly_log(ImuLog log, const Question& question, const Watch& watch) {
  if (question.plan.run.start != core::Start::launch) {
    throw text::Error{text::ErrorKind::bad_configuration,
                      fmt::format("the plan {} begins on command, in the tunnel; a plan that waits for a launch is "
                                  "needed (run.start = \"launch\")",
                                  question.plan_name)};
  }
  Heard heard{.log = std::move(log), .plan = question.plan_name, .flown = question.plan};
  heard.further_lift_offs_s = lift_offs_s(heard.log.axial);
  if (!heard.further_lift_offs_s.empty()) {
    heard.lift_off_s = heard.further_lift_offs_s.front();
    heard.further_lift_offs_s.erase(heard.further_lift_offs_s.begin());
    heard.log.interval_s = interval_around_s(heard.log.axial, *heard.lift_off_s, heard.log.interval_s);
  }
  const double stale_s = static_cast<double>(core::seconds(question.plan.motion.stale_time));
  heard.longest_bridge_s = question.longest_bridge_s.value_or(longest_bridge_s(heard.log.interval_s, stale_s));
  heard.gaps = gaps(heard.log.axial, heard.longest_bridge_s);
  for (const Gap& gap : heard.gaps) {
    if (heard.lift_off_s && gap.from_s < *heard.lift_off_s && *heard.lift_off_s <= gap.to_s) {
      heard.lift_off_gap = gap;
      heard.lift_off_s = gap.from_s;
    }
  }
  heard.log_height =
      log_height(heard.log.height, heard.lift_off_s,
                 heard.further_lift_offs_s.empty() ? std::nullopt : std::optional{heard.further_lift_offs_s.front()});
  find_clipped(heard);

  const double begin_s = heard.log.begin_s() - question.pad_s;
  const auto ticks = static_cast<std::int64_t>((heard.log.end_s() - begin_s) / tick_s + 1e-6);
  const double trace_from_s = heard.lift_off_s.value_or(begin_s) - trace_before_s;
  Sensors sensors{heard.log, heard.longest_bridge_s, heard.lift_off_s.value_or(begin_s) - 0.1, question.plan};
  core::Autopilot autopilot{question.plan};
  core::Inputs inputs{.arm_switch_closed = true, .arm_command = true};
  for (std::int64_t tick = 0; tick <= ticks; ++tick) {
    const double time_s = begin_s + static_cast<double>(tick) * tick_s;
    sensors.read(time_s, first_tick + tick * core::tick_period, inputs);
    const core::TickRecord& record = autopilot.step(inputs);
    follow(heard, time_s, record);
    for (std::size_t canard = 0; canard < core::canard_count; ++canard) {
      inputs.encoders[canard] = record.canards[canard].angle;
    }
    inputs.arm_command = false;
    if (tick % trace_every == 0 && time_s >= trace_from_s && heard.trace.time_s.size() < most_traced) {
      trace(heard.trace, time_s, record);
    }
    if (watch && tick % 1000 == 0) {
      watch(static_cast<double>(tick) * tick_s);
    }
    if (is_over(heard, time_s)) {
      break;
    }
  }
  find_peaks(heard);
  heard.doubts = doubts_of(heard);
  heard.notes = notes_of(heard, question);
  return heard;
}

}  // namespace fantail::listen
