// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include <fmt/core.h>

#include "predict/advice.hpp"
#include "predict/margins.hpp"
#include "predict/sentences.hpp"
#include "text/number.hpp"

namespace fantail::predict {
namespace {

struct Part {
  double of_the_offset;
  std::string_view name;
};
constexpr std::array straighter_fins{Part{0.75, "three quarters"}, Part{0.5, "half"}, Part{0.25, "a quarter"}};
constexpr std::array integral_gains_per_s{1.0, 0.5, 0.2, 0.1};

/// Of the first runs, flown again with this part of their fin offset; empty: too few of them, and the rest was not
/// flown.
std::optional<Share> held_again(const Prediction& p, const sim::Scenario& changed, double part_of_offset,
                                double asked_share, const Look& look) {
  const std::size_t count = std::min(most_flown_again, p.runs.size());
  std::size_t lost = 0;
  for (std::size_t i = 0; i < count; ++i) {
    TunnelStep airframe = p.runs[i].airframe;
    airframe.offset_begin_rad *= part_of_offset;
    airframe.offset_end_rad *= part_of_offset;
    lost += fly_run(changed, airframe, p.runs[i].seed).outcome == report::Outcome::held ? 0 : 1;
    look();
    if (share(count - lost, count).value < asked_share) {
      return std::nullopt;
    }
  }
  return share(count - lost, count);
}

bool has_phase_margin(const Prediction& p, const sim::Scenario& changed, double asked_rad) {
  return std::ranges::all_of(margins_over_speed(changed, p.runs, p.speeds_m_s),
                             [&](const MarginsAtSpeed& at) { return at.phase_margin_rad.p5 >= asked_rad; });
}

std::string held_in(const Share& share) {
  return fmt::format("the roll is held in {} of the first {}", share.count, runs(share.of));
}

/// With each of the integral gains that leave the phase margin, the largest first.
std::vector<sim::Scenario> with_integral_action(const Prediction& p, sim::Scenario changed, double phase_margin_rad) {
  std::vector<sim::Scenario> all;
  changed.plan.offset.rejection = core::OffsetRejection::integral;
  for (const double gain_per_s : integral_gains_per_s) {
    changed.plan.offset.integral_gain_per_s = static_cast<float>(gain_per_s);
    if (has_phase_margin(p, changed, phase_margin_rad)) {
      all.push_back(changed);
    }
  }
  return all;
}

std::string integral_words(const sim::Scenario& scenario) {
  return fmt::format("offset.rejection=integral and offset.integral_gain_per_s={}",
                     text::brief(static_cast<double>(scenario.plan.offset.integral_gain_per_s), 1));
}

/// With the whole offset, the first of these launches that holds: a sentence, or nothing.
std::string with_another_law(const Prediction& p, const std::vector<sim::Scenario>& launches, double asked_share,
                             bool more, const Look& look) {
  for (const sim::Scenario& launch : launches) {
    if (const auto held = held_again(p, launch, 1.0, asked_share, look)) {
      return fmt::format("With {}{}, {}.", integral_words(launch), more ? " as well" : "", held_in(*held));
    }
  }
  return {};
}

/// The same with as large a part of the offset as one of them holds with.
std::string with_straighter_fins(const Prediction& p, const std::vector<sim::Scenario>& launches, double asked_share,
                                 const std::function<std::string(const sim::Scenario&)>& and_what, const Look& look) {
  for (const Part& part : straighter_fins) {
    for (const sim::Scenario& launch : launches) {
      if (const auto held = held_again(p, launch, part.of_the_offset, asked_share, look)) {
        return fmt::format("With {} of the fin offset{}, {}.", part.name, and_what(launch), held_in(*held));
      }
    }
  }
  return {};
}

}  // namespace

std::vector<std::string> advice_on_offset(const Prediction& p, const sim::Scenario& advised, bool more,
                                          const Asked& asked, const Look& look) {
  const auto integral = advised.plan.offset.rejection == core::OffsetRejection::none
                            ? with_integral_action(p, advised, asked.phase_margin_rad)
                            : std::vector<sim::Scenario>{};
  const auto as_it_is = [](const sim::Scenario&) { return " and the plan as it is"; };
  std::vector<std::string> all{with_another_law(p, integral, asked.held_share, more, look),
                               with_straighter_fins(p, {p.flown}, asked.held_share, as_it_is, look)};
  std::erase(all, "");
  if (all.empty()) {
    const auto law = [more](const sim::Scenario& launch) {
      return fmt::format(", {}{}", integral_words(launch), more ? " as well" : "");
    };
    all.push_back(with_straighter_fins(p, integral, asked.held_share, law, look));
    std::erase(all, "");
  }
  if (all.empty()) {
    all.push_back(
        fmt::format("{}traighter fins, down to a quarter of the offset, were tried: too few runs hold their "
                    "roll. No change is known with which the roll is held.",
                    integral.empty() ? "S" : "Integral action and s"));
  }
  return all;
}

}  // namespace fantail::predict
