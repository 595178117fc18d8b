// SPDX-License-Identifier: MIT
#include "predict/wind_advice.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>

#include <fmt/core.h>

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

/// The first of the runs that came to the tilt limit, with their airframes, seeds and winds, in a part of those.
Tried fly_again(const Prediction& p, double part) {
  sim::Scenario changed = p.flown;
  changed.wind_spread = {};
  Tried tried;
  for (const Run& run : p.runs) {
    if (!run.ended_by_tilt || tried.runs == most_tried) {
      continue;
    }
    changed.wind = run.wind.value_or(p.flown.wind);
    changed.wind.speed_m_s *= part;
    changed.wind.gust_m_s *= part;
    const Run again = fly_run(changed, run.airframe, run.seed);
    ++tried.runs;
    tried.tilted += again.ended_by_tilt ? 1 : 0;
    tried.held += again.outcome == report::Outcome::held ? 1 : 0;
  }
  return tried;
}

}  // namespace

std::string advice_on_wind(const Prediction& p) {
  const auto tilted = static_cast<std::size_t>(std::ranges::count_if(p.runs, &Run::ended_by_tilt));
  if (tilted == 0 || p.flown.motion != sim::FlightMotion::six_dof) {
    return {};
  }
  const std::string_view count = tilted > most_tried ? "the first " : "";
  const std::string text =
      fmt::format("In {} of {} control ends at the plan's tilt limit.", tilted, runs(p.runs.size()));
  for (const Part& part : smaller_winds) {
    const Tried tried = fly_again(p, part.of_the_wind);
    if (tried.tilted == 0) {
      return text + fmt::format(" Of {}{} flown again in {} of their wind none does, and {} hold their roll.", count,
                                tried.runs, part.name,
                                tried.held == tried.runs ? "all" : fmt::format("{}", tried.held));
    }
  }
  const Tried calm = fly_again(p, 0.0);
  return text + fmt::format(" Of {}{} flown again without wind {}.", count, calm.runs,
                            calm.tilted == 0 ? "none does, but in a quarter of their wind some still do"
                                             : fmt::format("{} still do: wind is not the cause there", calm.tilted));
}

}  // namespace fantail::predict
