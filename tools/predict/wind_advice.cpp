// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include <fmt/core.h>

#include "predict/advice.hpp"
#include "predict/sentences.hpp"

namespace fantail::predict {
namespace {

constexpr std::size_t most_tried = 20;

struct Part {
  double of_the_wind;
  std::string_view name;
};
constexpr std::array smaller_winds{Part{0.75, "three quarters"}, Part{0.5, "half"}, Part{0.25, "a quarter"}};

struct Tried {
  std::size_t runs = 0;
  std::size_t tilted = 0;
  std::size_t held = 0;
};

enum class Guide : std::uint8_t { as_it_stands, upright };

/// The first of the runs whose control ended early at the tilt limit, with their airframes, seeds and winds, in a part
/// of those.
Tried fly_again(const Prediction& p, double part_of_wind, Guide guide, const Look& look) {
  sim::Scenario changed = p.flown;
  changed.wind_spread = {};
  changed.guide.tilt_rad = guide == Guide::upright ? 0.0 : changed.guide.tilt_rad;
  Tried tried;
  for (const Run& run : p.runs) {
    if (!run.ended_by_tilt || tried.runs == most_tried) {
      continue;
    }
    changed.wind = run.wind.value_or(p.flown.wind);
    changed.wind.speed_m_s *= part_of_wind;
    changed.wind.gust_m_s *= part_of_wind;
    const Run again = fly_run(changed, run.airframe, run.seed);
    look();
    ++tried.runs;
    tried.tilted += again.ended_by_tilt ? 1 : 0;
    tried.held += again.outcome == report::Outcome::held ? 1 : 0;
  }
  return tried;
}

std::string came_to(const Tried& tried) {
  return tried.tilted > 0 ? fmt::format("it still does so in {} of them", tried.tilted)
         : tried.held == tried.runs
             ? "it does so in none and all hold their roll"
             : fmt::format("it does so in none, and {} hold{} the roll", tried.held, tried.held == 1 ? "s" : "");
}

std::string with_less_wind(const Prediction& p, const Look& look) {
  for (const Part& part : smaller_winds) {
    const Tried tried = fly_again(p, part.of_the_wind, Guide::as_it_stands, look);
    if (tried.tilted == 0) {
      return fmt::format(" In {} of their wind, {}.", part.name, came_to(tried));
    }
  }
  const Tried calm = fly_again(p, 0.0, Guide::as_it_stands, look);
  return fmt::format(" {}ithout wind, {}.", calm.tilted == 0 ? "In a quarter of their wind, it still does so. W" : "W",
                     came_to(calm));
}

}  // namespace

std::string advice_on_wind(const Prediction& p, const Look& look) {
  const auto tilted = static_cast<std::size_t>(std::ranges::count_if(p.runs, &Run::ended_by_tilt));
  if (tilted == 0 || p.flown.motion != sim::FlightMotion::six_dof) {
    return {};
  }
  std::string found;
  const auto blows = [](const Run& run) {
    return run.wind && (run.wind->speed_m_s > 0.0 || run.wind->gust_m_s != 0.0);
  };
  if (std::ranges::any_of(p.runs, blows)) {
    found = with_less_wind(p, look);
  }
  if (p.flown.guide.tilt_rad > 0.0) {
    found += fmt::format(" From an upright guide, {}.", came_to(fly_again(p, 1.0, Guide::upright, look)));
  }
  const std::string text =
      fmt::format("In {} of {}, the plan's tilt limit ends control early.", tilted, runs(p.runs.size()));
  const std::string again = tilted == 1 ? "It was"
                                        : fmt::format("{} {} of them were", tilted > most_tried ? "The first" : "All",
                                                      std::min(tilted, most_tried));
  return found.empty() ? text : fmt::format("{} {} flown again.{}", text, again, found);
}

}  // namespace fantail::predict
