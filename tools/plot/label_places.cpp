// SPDX-License-Identifier: MIT
#include "plot/label_places.hpp"

#include <algorithm>

namespace fantail::plot {
namespace {

bool overlap(Box a, Box b) { return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom; }

bool holds(Box box, Pixel p) { return p.x >= box.left && p.x <= box.right && p.y >= box.top && p.y <= box.bottom; }

}  // namespace

std::optional<Box> LabelPlaces::take(std::span<const Box> candidates) {
  std::optional<Box> best;
  std::ptrdiff_t least = 0;
  for (const Box box : candidates) {
    const bool inside = box.left >= inside_.left && box.right <= inside_.right && box.top >= inside_.top &&
                        box.bottom <= inside_.bottom;
    if (!inside || std::ranges::any_of(taken_, [box](Box other) { return overlap(box, other); })) {
      continue;
    }
    const std::ptrdiff_t covered = std::ranges::count_if(drawn_, [box](Pixel p) { return holds(box, p); });
    if (!best || covered < least) {
      best = box;
      least = covered;
    }
  }
  if (best) {
    taken_.push_back(*best);
  }
  return best;
}

}  // namespace fantail::plot
