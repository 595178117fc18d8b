// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "report/verdict_parts.hpp"
#include "text/degrees.hpp"
#include "text/number.hpp"

namespace fantail::report {
namespace {

using flight::BeforeBurnout;

std::string seconds(double time_s) { return text::fixed(time_s, 2) + " s"; }

struct Happening {
  double time_s;
  std::string sentence;  ///< without its subject, where that is the rocket
};

std::vector<Happening> in_order(const flight::Flight& flight, const BeforeBurnout& b) {
  std::vector<Happening> all;
  if (b.sank_s) {
    // Along a straight line nothing else tells that this flight is none.
    const char* straight =
        flight.path.empty() ? ". A real rocket turns over when it sinks; the simulated one keeps to its line" : "";
    all.push_back(
        {*b.sank_s, fmt::format("sank by {} m from {} on, before burn-out{}{}.", text::fixed(b.sank_m, 1),
                                seconds(*b.sank_s), b.rose_again ? ", and the motor lifted it again" : "", straight)});
  }
  if (b.parachute_s) {
    all.push_back(
        {*b.parachute_s, fmt::format("opened its parachute at {}, before burn-out.", seconds(*b.parachute_s))});
  }
  if (b.ground_s) {
    all.push_back({*b.ground_s,
                   b.left_again_s
                       ? fmt::format("fell back on its pad at {} and left it again at {}; times count from the first "
                                     "lift-off.",
                                     seconds(*b.ground_s), seconds(*b.left_again_s))
                       : fmt::format("came down at {}, before burn-out.", seconds(*b.ground_s))});
  }
  std::ranges::stable_sort(all, {}, &Happening::time_s);
  if (b.turned_over_s) {
    all.insert(all.begin(),
               {*b.turned_over_s,
                fmt::format("turned over while the motor burned: from {} on its nose pointed below the horizon, up to "
                            "{} deg from upright.",
                            seconds(*b.turned_over_s), text::fixed(text::degrees(b.largest_tilt_rad), 0))});
  }
  return all;
}

struct NamedTime {
  const char* name;
  std::optional<double> BeforeBurnout::* time_s;
};
constexpr std::array named_times{
    NamedTime{"turned_over_s", &BeforeBurnout::turned_over_s}, NamedTime{"sank_s", &BeforeBurnout::sank_s},
    NamedTime{"parachute_s", &BeforeBurnout::parachute_s}, NamedTime{"ground_s", &BeforeBurnout::ground_s},
    NamedTime{"left_pad_again_s", &BeforeBurnout::left_again_s}};

std::optional<double> number(const json::Value& object, const char* name) {
  const json::Value* value = object.find(name);
  return value != nullptr && value->is_number() ? std::optional{value->number()} : std::nullopt;
}

}  // namespace

std::string before_burnout(const flight::Flight& flight) {
  if (!flight.before_burnout) {
    return {};
  }
  std::string text;
  for (const Happening& happening : in_order(flight, *flight.before_burnout)) {
    text += fmt::format("{} {}", text.empty() ? "The rocket" : " It", happening.sentence);
  }
  if (const auto& burnout_s = flight.events.burnout_s) {
    text += fmt::format(" Burn-out was at {}.", seconds(*burnout_s));
  }
  return text;
}

// Near its highest point any rocket may meet the air from behind, and nobody minds.
std::optional<double> tumbled_s(const flight::Flight& flight) {
  constexpr double broadside_rad = 0.5 * std::numbers::pi;
  if (!flight::is_beyond(flight::ModelEnd::stability, flight.extremes) || !flight.events.apogee_s) {
    return std::nullopt;
  }
  const auto found = std::ranges::find_if(flight.path, [&](const flight::PathPoint& point) {
    return point.time_s > flight.events.liftoff_s.value_or(0.0) && point.angle_of_attack_rad > broadside_rad;
  });
  return found != flight.path.end() && found->time_s < *flight.events.apogee_s - near_apogee_s
             ? std::optional{found->time_s}
             : std::nullopt;
}

bool ascent_failed(const flight::Flight& flight) {
  return (flight.before_burnout && flight.before_burnout->ascent_failed()) || tumbled_s(flight);
}

std::string failed_ascent(const flight::Flight& flight) {
  const std::string before = before_burnout(flight);
  const auto from_s = tumbled_s(flight);
  if (!from_s || (flight.before_burnout && flight.before_burnout->ascent_failed())) {
    return before;
  }
  return fmt::format("{}{}The rocket is not stable and tumbled: from {} on it flew tail first, {} before apogee.",
                     before, before.empty() ? "" : " ", seconds(*from_s), seconds(*flight.events.apogee_s - *from_s));
}

json::Value before_burnout_json(const flight::Flight& flight) {
  if (!flight.before_burnout) {
    return {};
  }
  const BeforeBurnout& b = *flight.before_burnout;
  json::Value all;
  for (const auto& [name, time_s] : named_times) {
    all[name] = json::rounded(b.*time_s);
  }
  all["largest_tilt_deg"] = b.turned_over_s ? json::rounded(text::degrees(b.largest_tilt_rad)) : json::Value{};
  all["sank_m"] = b.sank_s ? json::rounded(b.sank_m) : json::Value{};
  all["rose_again"] = b.rose_again;
  return all;
}

std::optional<BeforeBurnout> read_before_burnout(const json::Value& json) {
  BeforeBurnout b;
  for (const auto& [name, time_s] : named_times) {
    b.*time_s = number(json, name);
  }
  b.largest_tilt_rad = text::radians(number(json, "largest_tilt_deg").value_or(0.0));
  b.sank_m = number(json, "sank_m").value_or(0.0);
  const json::Value* rose_again = json.find("rose_again");
  b.rose_again = rose_again != nullptr && *rose_again == json::Value(true);
  return b.happened() ? std::optional{b} : std::nullopt;
}

}  // namespace fantail::report
