// SPDX-License-Identifier: MIT
#include "plot/heat_spots.hpp"

#include <cmath>
#include <numbers>

#include "plot/lettering.hpp"

namespace fantail::plot {
namespace {

constexpr double ring = 6.0;
constexpr double letters = 18.0;  // height of a label's box
constexpr double gap = 4.0;

// To the right, to the left, above, below; then all around, farther and farther away.
std::vector<Box> candidates(Pixel at, double width) {
  std::vector<Box> result;
  const auto centred = [&](double x, double y) {
    result.push_back({x - 0.5 * width, y - 0.5 * letters, x + 0.5 * width, y + 0.5 * letters});
  };
  const double beside = ring + gap + 0.5 * width;
  const double over = ring + gap + 0.5 * letters;
  centred(at.x + beside, at.y);
  centred(at.x - beside, at.y);
  centred(at.x, at.y - over);
  centred(at.x, at.y + over);
  for (double away = 1.0; away <= 9.0; away += 1.0) {
    for (int i = 0; i < 12; ++i) {
      const double angle = std::numbers::pi / 6.0 * static_cast<double>(i);
      centred(at.x + (beside + 14.0 * away) * std::cos(angle), at.y - (over + 14.0 * away) * std::sin(angle));
    }
  }
  return result;
}

}  // namespace

void draw_spots(Drawing& drawing, const std::vector<HeatMap::Spot>& spots) {
  LabelPlaces places{drawing.frame()};
  struct Shown {
    Pixel at;
    std::string text;
  };
  std::vector<Shown> shown;
  for (const HeatMap::Spot& spot : spots) {
    if (spot.x >= drawing.x_range().low && spot.x <= drawing.x_range().high && spot.y >= drawing.y_range().low &&
        spot.y <= drawing.y_range().high) {
      const Pixel at{drawing.x(spot.x), drawing.y(spot.y)};
      shown.push_back({at, shortened(spot.label, 0.7 * drawing.frame().width())});
      places.keep_free({at.x - ring, at.y - ring, at.x + ring, at.y + ring});
    }
  }
  for (const Shown& spot : shown) {
    const double width = text_width(spot.text) + 10.0;
    const auto box = spot.text.empty() ? std::nullopt : places.take(candidates(spot.at, width));
    if (box) {
      const double x = std::clamp(spot.at.x, box->left, box->right);
      const double y = std::clamp(spot.at.y, box->top, box->bottom);
      if (std::hypot(x - spot.at.x, y - spot.at.y) > ring + gap + 1.0) {
        for (const std::string_view part : {"halo", "leader"}) {
          drawing.add("<path class=\"{}\" d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\"/>", part, spot.at.x, spot.at.y, x, y);
        }
      }
      drawing.add(
          "<rect class=\"tag\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" rx=\"3\"/>"
          "<text class=\"tag\" x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{}</text>",
          box->left, box->top, box->width(), box->height(), 0.5 * (box->left + box->right), box->bottom - 5.0,
          printed(spot.text));
    }
  }
  for (const Shown& spot : shown) {
    drawing.add(
        "<circle class=\"halo\" cx=\"{0:.1f}\" cy=\"{1:.1f}\" r=\"{2}\"/>"
        "<circle class=\"spot\" cx=\"{0:.1f}\" cy=\"{1:.1f}\" r=\"{2}\"/>",
        spot.at.x, spot.at.y, ring - 1.0);
  }
}

}  // namespace fantail::plot
