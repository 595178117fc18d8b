// SPDX-License-Identifier: MIT
// Which of a design's fins are the fins, and which the canards.
#include <algorithm>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "airframe/openrocket/reader.hpp"
#include "text/error.hpp"

namespace fantail::airframe::openrocket {
namespace {

using sim::Geometry;

double area_m2(const Geometry::FinSet& set) { return set.count * set.span_m * (set.root_chord_m + set.tip_chord_m); }

bool is_ahead(const Geometry::FinSet& a, const Geometry::FinSet& b) {
  return a.position_m + a.root_chord_m <= b.position_m + a_millimetre_m;
}

/// Angles of a set that is evenly around, from any of its fins on.
bool is_even(std::vector<double> angles_rad) {
  for (double& angle_rad : angles_rad) {
    angle_rad = std::remainder(angle_rad, 2.0 * std::numbers::pi);
  }
  std::ranges::sort(angles_rad);
  const double apart_rad = 2.0 * std::numbers::pi / static_cast<double>(angles_rad.size());
  for (std::size_t i = 1; i < angles_rad.size(); ++i) {
    if (std::abs(angles_rad[i] - angles_rad[i - 1] - apart_rad) > 0.02) {
      return false;
    }
  }
  return true;
}

}  // namespace

/// A person may have drawn a set as single fins, each turned to its own side.
void Reader::join_single_fins() {
  const auto alike = [](const Geometry::FinSet& a, const Geometry::FinSet& b) {
    return a.count == 1 && b.count == 1 && std::abs(a.position_m - b.position_m) < a_millimetre_m &&
           a.root_chord_m == b.root_chord_m && a.tip_chord_m == b.tip_chord_m && a.span_m == b.span_m &&
           a.sweep_m == b.sweep_m && a.cant_rad == b.cant_rad;
  };
  std::vector<Geometry::MoreFins> joined;
  while (!fins_.empty()) {
    Geometry::MoreFins first = fins_.front();
    std::vector<double> angles_rad;
    for (const Geometry::MoreFins& one : fins_) {
      if (alike(one.set, first.set)) {
        angles_rad.push_back(one.first_angle_rad);
      }
    }
    if (angles_rad.size() > 1 && angles_rad.size() <= 8 && is_even(angles_rad)) {
      std::erase_if(fins_, [&](const Geometry::MoreFins& one) { return alike(one.set, first.set); });
      first.set.count = static_cast<int>(angles_rad.size());
    } else {
      fins_.erase(fins_.begin());
    }
    joined.push_back(std::move(first));
  }
  fins_ = std::move(joined);
}

void Reader::choose_canards() {
  Geometry& g = design_.geometry;
  std::vector<std::string> names;
  std::vector<std::size_t> like_canards;
  for (std::size_t i = 0; i < fins_.size(); ++i) {
    const Geometry::FinSet& set = fins_[i].set;
    names.push_back(fmt::format("\"{}\" ({})", fins_[i].name, set.count));
    const bool fits = set.count == 4 && set.position_m >= g.nose_length_m - a_millimetre_m;
    const bool is_in_front = set.position_m < 0.5 * g.length_m;
    if (canards_.empty() ? fits && g.fins && is_ahead(set, *g.fins) && (is_in_front || area_m2(set) < area_m2(*g.fins))
                         : fins_[i].name == canards_) {
      like_canards.push_back(i);
    }
  }
  if (like_canards.empty() && canards_.empty()) {
    return;
  }
  const auto refuse = [&](const std::string& why) {
    throw text::Error{text::ErrorKind::bad_data,
                      fmt::format("{}: {}. Its fins beside the rearmost: {}", file_.string(), why,
                                  names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", ")))};
  };
  if (like_canards.empty()) {
    refuse(fmt::format("has no fins \"{}\" for the canards", canards_));
  }
  if (like_canards.size() > 1) {
    refuse("more than one set may be the canards: choose one by --canards NAME");
  }
  const Geometry::MoreFins& chosen = fins_[like_canards.front()];
  if (chosen.set.count != 4) {
    refuse(fmt::format("the fins \"{}\" are {}; allowed for canards: 4", chosen.name, chosen.set.count));
  }
  g.canards = chosen.set;
  if (canards_.empty()) {
    design_.assumed.push_back(fmt::format("Fins \"{}\": used as the canards.", chosen.name));
  }
  fins_.erase(fins_.begin() + static_cast<std::ptrdiff_t>(like_canards.front()));
}

void Reader::choose_fins() {
  join_single_fins();
  std::ranges::stable_sort(fins_, {}, [](const auto& one) { return one.set.position_m; });
  Geometry& g = design_.geometry;
  const auto hold = std::ranges::find_if(fins_.rbegin(), fins_.rend(), [&](const Geometry::MoreFins& one) {
    return one.set.count >= 3 && one.name != canards_ && one.set.position_m >= g.nose_length_m - a_millimetre_m;
  });
  if (hold != fins_.rend()) {
    g.fins = hold->set;
    fins_.erase(std::next(hold).base());
  }
  choose_canards();
  g.more_fins = std::move(fins_);
  for (const Geometry::MoreFins& more : g.more_fins) {
    if (more.set.count == 1) {
      design_.assumed.push_back(
          fmt::format("Fin \"{}\": a single one; that it pushes to one side is not counted.", more.name));
    }
  }
}

}  // namespace fantail::airframe::openrocket
