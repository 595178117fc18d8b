// SPDX-License-Identifier: MIT
#include <algorithm>

#include <fmt/core.h>

#include "predict/decision.hpp"
#include "text/apart.hpp"
#include "text/number.hpp"

namespace fantail::predict {
namespace {

// The usual rule of thumb, as for a rocket from its shape.
constexpr double least_margin_calibres = 1.0;

std::vector<flight::Extremes> extremes_of(const std::vector<Run>& runs) {
  std::vector<flight::Extremes> all;
  std::ranges::transform(runs, std::back_inserter(all), &Run::extremes);
  return all;
}

}  // namespace

std::optional<Criterion> within_model(const Prediction& p) {
  if (p.outside_model == 0) {
    return std::nullopt;
  }
  const std::vector<flight::Extremes> all = extremes_of(p.runs);
  const std::string which = flight::which_are_beyond(all);
  return Criterion{.key = "model",
                   .label = "Every run stays within the model",
                   .found = which,
                   .required = flight::what_the_model_asks(flight::worst_of(all)),
                   .judgement = Judgement::not_judged,
                   .clause = fmt::format("outside the model: {}. The simulation of roll is not valid there", which)};
}

bool is_outside_by_wind_alone(const Prediction& p) {
  flight::Extremes worst = flight::worst_of(extremes_of(p.runs));
  worst.angle_of_attack_rad.reset();
  return !flight::is_beyond_model(worst);
}

std::size_t steady_outside_model(const Prediction& p) {
  return static_cast<std::size_t>(std::ranges::count(p.runs, report::Outcome::outside_model, &Run::outcome));
}

std::string stability_caution(const Prediction& p) {
  if (!p.flown.vehicle.airframe) {
    return "static margin and roll resonance are unknown, because the vehicle has no [airframe]";
  }
  const std::optional<double> margin = flight::worst_of(extremes_of(p.runs)).static_margin_calibres;
  return margin && *margin < least_margin_calibres
             ? fmt::format("the static margin falls to {} calibres, and {} is usual",
                           text::apart(*margin, least_margin_calibres, 2), text::brief(least_margin_calibres, 1))
             : "";
}

}  // namespace fantail::predict
