// SPDX-License-Identifier: MIT
#include "listen/mounting.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <utility>

#include <fmt/core.h>

#include "text/degrees.hpp"
#include "text/error.hpp"
#include "text/number.hpp"

namespace fantail::listen {
namespace {

constexpr double whole_turn_deg = 360.0;

[[noreturn]] void refuse(std::string_view text) {
  throw text::Error{text::ErrorKind::bad_configuration,
                    fmt::format("\"{}\" is not a mounting; allowed: \"pad\", or angles from -360 to 360 degrees about "
                                "x, y or z: \"90 about z, 10 "
                                "about x\"",
                                text)};
}

/// "45 about x".
sim::Quaternion one_turn(std::string_view turn, std::string_view all, char& axis) {
  constexpr std::string_view about = " about ";
  const std::size_t at = turn.find(about);
  if (at == std::string_view::npos) {
    refuse(all);
  }
  const auto angle_deg = text::number(text::trimmed(turn.substr(0, at)));
  const std::string_view which = text::trimmed(turn.substr(at + about.size()));
  if (!angle_deg || !(std::abs(*angle_deg) <= whole_turn_deg) || which.size() != 1 ||
      std::string_view{"xyz"}.find(which) == std::string_view::npos) {
    refuse(all);
  }
  axis = which.front();
  const double half_rad = 0.5 * text::radians(*angle_deg);
  const double sine = std::sin(half_rad);
  return {.w = std::cos(half_rad),
          .x = axis == 'x' ? sine : 0.0,
          .y = axis == 'y' ? sine : 0.0,
          .z = axis == 'z' ? sine : 0.0};
}

struct Component {
  Signal* signal;
  const char* name;
};
using Vector = std::array<Component, 3>;

/// Rounding of sine and cosine leaves 1e-16 where a component plays no part.
bool needs(const sim::Quaternion& to_rocket, std::size_t from) {
  constexpr double nothing = 1e-9;
  const std::array<sim::Vector3, 3> axes{sim::Vector3{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}};
  const sim::Vector3 turned = rotated(to_rocket, axes[from]);
  const std::array<double, 3> parts{turned.x, turned.y, turned.z};
  return std::abs(parts[from] - 1.0) > nothing;
}

void turn(const ImuLog& log, const Vector& vector, const Mounting& mounting) {
  std::array<bool, 3> moves{};
  bool any_is_there = false;
  for (std::size_t i = 0; i < moves.size(); ++i) {
    moves[i] = needs(mounting.to_rocket, i);
    any_is_there = any_is_there || (moves[i] && vector[i].signal->is_there());
  }
  if (!any_is_there) {
    return;
  }
  const Signal* first = nullptr;
  for (std::size_t i = 0; i < moves.size(); ++i) {
    if (moves[i] && !vector[i].signal->is_there()) {
      throw text::Error{text::ErrorKind::bad_data,
                        fmt::format("{}: --mounting \"{}\" needs {}, which is not in the log", log.name, mounting.words,
                                    vector[i].name)};
    }
    first = moves[i] && first == nullptr ? vector[i].signal : first;
  }
  std::array<Signal, 3> out;
  std::array<std::size_t, 3> next{};
  for (const double time_s : first->time_s) {
    std::array<double, 3> v{};
    bool all_have_it = true;
    for (std::size_t i = 0; i < v.size() && all_have_it; ++i) {
      if (!moves[i]) {
        continue;
      }
      const Signal& signal = *vector[i].signal;
      while (next[i] < signal.time_s.size() && signal.time_s[next[i]] < time_s) {
        ++next[i];
      }
      all_have_it = next[i] < signal.time_s.size() && signal.time_s[next[i]] == time_s;
      v[i] = all_have_it ? signal.value[next[i]] : 0.0;
    }
    if (!all_have_it) {
      continue;
    }
    const sim::Vector3 turned = rotated(mounting.to_rocket, {v[0], v[1], v[2]});
    const std::array<double, 3> parts{turned.x, turned.y, turned.z};
    for (std::size_t i = 0; i < parts.size(); ++i) {
      out[i].time_s.push_back(time_s);
      out[i].value.push_back(parts[i]);
    }
  }
  if (2 * out[0].time_s.size() < first->time_s.size()) {
    throw text::Error{text::ErrorKind::bad_data,
                      fmt::format("{}: --mounting \"{}\" needs axes that were sampled at the same times; only {} of {} "
                                  "samples were",
                                  log.name, mounting.words, out[0].time_s.size(), first->time_s.size())};
  }
  for (std::size_t i = 0; i < out.size(); ++i) {
    if (moves[i]) {
      vector[i].signal->time_s = std::move(out[i].time_s);
      vector[i].signal->value = std::move(out[i].value);
    }
  }
}

/// The shortest rotation that takes a direction to x.
sim::Quaternion to_nose(const sim::Vector3& up) {
  const sim::Vector3 nose{1.0, 0.0, 0.0};
  const sim::Vector3 axis = cross(up, nose);
  const double w = 1.0 + dot(up, nose);
  constexpr double opposite = 1e-9;
  if (w < opposite) {  // half a turn, about any axis across
    return {.w = 0.0, .x = 0.0, .y = 0.0, .z = 1.0};
  }
  const double norm = std::sqrt(w * w + dot(axis, axis));
  return {.w = w / norm, .x = axis.x / norm, .y = axis.y / norm, .z = axis.z / norm};
}

/// Of the first samples at about 1 g, before any push. What is no reading yet, as zeros of a logger that has just
/// begun, is left out.
sim::Quaternion by_pad(const ImuLog& log) {
  constexpr double shortest_s = 0.2;
  constexpr double longest_s = 5.0;
  constexpr double least_g = 0.8;
  constexpr double most_g = 1.2;
  constexpr double push_g = 2.0;
  const auto& [x, y, z] = std::tie(log.axial, log.lateral_y, log.lateral_z);
  const std::size_t samples = std::min({x.value.size(), y.value.size(), z.value.size()});
  sim::Vector3 sum{};
  double begin_s = 0.0;
  double end_s = 0.0;
  bool is_at_rest = false;
  for (std::size_t i = 0; i < samples; ++i) {
    const sim::Vector3 force{x.value[i], y.value[i], z.value[i]};
    const double g = length(force) / one_g_m_s2;
    if (g > push_g || (is_at_rest && x.time_s[i] - begin_s > longest_s)) {
      break;
    }
    if (g < least_g || g > most_g) {
      if (end_s - begin_s >= shortest_s) {
        break;
      }
      is_at_rest = false;
      continue;
    }
    sum = is_at_rest ? sum + force : force;
    begin_s = is_at_rest ? begin_s : x.time_s[i];
    end_s = x.time_s[i];
    is_at_rest = true;
  }
  if (end_s - begin_s < shortest_s) {
    throw text::Error{
        text::ErrorKind::bad_data,
        fmt::format(
            "{}: which way the logger sits is not known, without {} s at rest ({} to {} g) before the first push; "
            "allowed: --mounting \"DEG about AXIS\"",
            log.name, shortest_s, least_g, most_g)};
  }
  return to_nose((1.0 / length(sum)) * sum);
}

}  // namespace

Mounting parse_mounting(std::string_view text) {
  Mounting mounting{.words = std::string{text}};
  if (text == mounting_by_pad) {
    mounting.by_pad = mounting.turns_axis = true;
    return mounting;
  }
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t comma = std::min(text.find(',', begin), text.size());
    char axis = 'x';
    mounting.to_rocket = one_turn(text::trimmed(text.substr(begin, comma - begin)), text, axis) * mounting.to_rocket;
    mounting.turns_axis = mounting.turns_axis || axis != 'x';
    begin = comma + 1;
  }
  return mounting;
}

void turn_into_rocket(ImuLog& log, Mounting mounting, bool axial_is_from_rest) {
  if (mounting.turns_axis && axial_is_from_rest) {
    throw text::Error{
        text::ErrorKind::bad_data,
        fmt::format("{}: --mounting \"{}\" turns the axial force, of which the reading on the pad was taken "
                    "off; allowed with it: angles about x. A column that reads 1 g there can be turned: --columns "
                    "axial=COLUMN:UNIT",
                    log.name, mounting.words)};
  }
  if (mounting.by_pad) {
    mounting.to_rocket = by_pad(log);
  }
  turn(log, {Component{&log.axial, "the axial force"}, {&log.lateral_y, "lateral_y"}, {&log.lateral_z, "lateral_z"}},
       mounting);
  turn(log, {Component{&log.roll_rate, "roll_rate"}, {&log.pitch_rate, "pitch_rate"}, {&log.yaw_rate, "yaw_rate"}},
       mounting);
  const std::string second =
      mounting.turns_axis && log.second_axial.is_there() ? " The second accelerometer was left as it is." : "";
  log.notes.push_back(
      mounting.by_pad
          ? fmt::format("The nose is where the force on the pad points: force and rates were turned so that it is x. A "
                        "guide that leans counts as upright.{}",
                        second)
          : fmt::format("The logger is mounted at \"{}\": force and rates were turned into the rocket's axes.{}",
                        mounting.words, second));
}

}  // namespace fantail::listen
