// SPDX-License-Identifier: MIT
// Which of a design's fins are the fins, which the canards, and which are left out.
#include <algorithm>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "airframe/openrocket/reader.hpp"

namespace fantail::airframe::openrocket {

using sim::Geometry;

/// A person may have drawn a set as single fins, each turned to its own side.
void Reader::join_single_fins() {
  const auto alike = [](const Geometry::FinSet& a, const Geometry::FinSet& b) {
    return a.position_m == b.position_m && a.root_chord_m == b.root_chord_m && a.tip_chord_m == b.tip_chord_m &&
           a.span_m == b.span_m && a.sweep_m == b.sweep_m;
  };
  std::vector<std::pair<std::string, Geometry::FinSet>> joined;
  for (const auto& [name, set] : fins_) {
    const auto same = std::ranges::find_if(joined, [&](const auto& one) { return alike(one.second, set); });
    if (set.count == 1 && same != joined.end() && same->second.count < 8) {
      ++same->second.count;
    } else {
      joined.emplace_back(name, set);
    }
  }
  for (const auto& [name, set] : joined) {
    if (set.count == 1) {
      design_.not_used.push_back(
          fmt::format("Fin \"{}\": its force, because it is a single fin; its mass is used.", name));
      design_.left_out.push_back({.what = fmt::format("fin \"{}\": its force", name), .is_force = true});
    }
  }
  std::erase_if(joined, [](const auto& one) { return one.second.count == 1; });
  fins_ = std::move(joined);
}

void Reader::choose_fins() {
  join_single_fins();
  std::ranges::sort(fins_, {}, [](const auto& one) { return one.second.position_m; });
  Geometry& g = design_.geometry;
  // Two fins hold the rocket in one plane only: no margin is computed with them.
  if (!fins_.empty() && fins_.back().second.count >= 3 && fins_.back().second.position_m > 0.5 * g.length_m) {
    g.fins = fins_.back().second;
    fins_.pop_back();
  }
  const auto canards = std::ranges::find_if(fins_, [&](const auto& one) {
    return one.second.count == 4 && one.second.position_m < 0.5 * g.length_m &&
           one.second.position_m >= g.nose_length_m;
  });
  if (canards != fins_.end()) {
    g.canards = canards->second;
    design_.assumed.push_back(fmt::format("Fins \"{}\": used as the canards.", canards->first));
    fins_.erase(canards);
  }
  for (const auto& [name, set] : fins_) {
    design_.not_used.push_back(fmt::format("Fins \"{}\": their forces; their mass is used.", name));
    design_.left_out.push_back({.what = fmt::format("fins \"{}\": their forces", name), .is_force = true});
  }
}

}  // namespace fantail::airframe::openrocket
