// SPDX-License-Identifier: MIT
#include <algorithm>

#include <fmt/core.h>

#include "identify/choices.hpp"
#include "identify/doubts.hpp"
#include "input/messages.hpp"
#include "sim/compressibility.hpp"
#include "text/number.hpp"

namespace fantail::identify {
namespace {

using input::about;

double growth(double mach) { return sim::compressibility_factor(sim::Compressibility::prandtl_glauert, mach); }

std::string range(double low, double high, int decimals) {
  const std::string from = text::fixed(low, decimals);
  const std::string to = text::fixed(high, decimals);
  return from == to ? to : from + " to " + to;
}

}  // namespace

sim::RollInertiaCourse inertia_on_clock(const logs::RollLog& log, const sim::RollInertiaCourse& since_ignition,
                                        std::vector<std::string>& warnings) {
  if (since_ignition.empty()) {
    return {};
  }
  const double full_kg_m2 = since_ignition.begin()->second;
  const auto [end_s, empty_kg_m2] = *since_ignition.rbegin();
  const auto burnout = burnout_s(log);
  if (!burnout) {
    warnings.push_back(fmt::format(
        "The vehicle's roll inertia is {} kg m2 at lift-off and {} after burn-out, and the log shows no burn-out. "
        "The value at lift-off is used. With the other one (--inertia) alpha and beta are {} times as large.",
        about(full_kg_m2), about(empty_kg_m2), text::fixed(empty_kg_m2 / full_kg_m2, 3)));
    return {};
  }
  sim::RollInertiaCourse course;
  for (const auto& [time_s, inertia_kg_m2] : since_ignition) {
    course[*burnout + (time_s - end_s)] = inertia_kg_m2;
  }
  return course;
}

std::optional<std::string> remark_on_inertia(const model::Record& record, const sim::RollInertiaCourse& course) {
  if (record.roll_inertia_kg_m2.empty()) {
    return {};
  }
  const double first = record.roll_inertia_kg_m2.front();
  const double last = record.roll_inertia_kg_m2.back();
  if (first != last) {
    return fmt::format("Roll inertia: {} to {} kg m2 in this window, as the propellant burns; the fit includes that.",
                       about(first), about(last));
  }
  return fmt::format("Roll inertia: {} kg m2 throughout this window, the value {}.", about(first),
                     last == course.rbegin()->second ? "after burn-out" : "at lift-off");
}

std::optional<std::string> remark_on_mach(const model::Record& record, const std::optional<bool>& grows) {
  constexpr double worth_a_word = 0.01;
  constexpr double fast = 0.3;
  const auto [low, high] = std::ranges::minmax(record.mach);
  const std::string values = range(low, high, 2);
  const std::string shares = range(100.0 * (growth(low) - 1.0), 100.0 * (growth(high) - 1.0), 1);
  if (record.grows_with_mach && growth(high) - 1.0 > worth_a_word) {
    return fmt::format(
        "The vehicle's alpha and beta grow with the Mach number (here {}), by {} %. The fit includes that and gives "
        "their values at low speed.",
        values, shares);
  }
  if (!grows && high > fast) {
    return fmt::format(
        "The Mach number is {} in this window. By the Prandtl-Glauert rule alpha and beta are {} % above their values "
        "at low speed; the fit gives a mean. A vehicle with compressibility would apply that growth again.",
        values, shares);
  }
  return {};
}

}  // namespace fantail::identify
