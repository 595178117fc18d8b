// SPDX-License-Identifier: MIT
#include "predict/model_end.hpp"

#include <algorithm>

#include <fmt/core.h>

#include "predict/sentences.hpp"
#include "text/number.hpp"

namespace fantail::predict {

std::optional<Criterion> within_model(const Prediction& p) {
  if (p.outside_model == 0) {
    return std::nullopt;
  }
  const Run& fastest = *std::ranges::max_element(p.runs, {}, &Run::top_mach);
  const std::string mach = text::fixed(fastest.top_mach, 2);
  const std::string end = text::brief(flight::model_ends_at_mach, 2);
  return Criterion{
      .key = "model",
      .label = "Every run stays within the model",
      .found = fmt::format("{} of {} are faster, up to Mach {}", p.outside_model, runs(p.runs.size()), mach),
      .required = fmt::format("at most Mach {}", end),
      .judgement = Judgement::not_judged,
      .clause = fmt::format(
          "outside the model: {} of {} are faster than Mach {}, up to Mach {}, and the simulation of roll ends there",
          p.outside_model, runs(p.runs.size()), end, mach)};
}

std::size_t steady_outside_model(const Prediction& p) {
  return static_cast<std::size_t>(std::ranges::count(p.runs, report::Outcome::outside_model, &Run::outcome));
}

}  // namespace fantail::predict
