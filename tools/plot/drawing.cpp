// SPDX-License-Identifier: MIT
#include "plot/drawing.hpp"

#include "plot/lettering.hpp"

namespace fantail::plot {

void Drawing::begin(std::string_view kind, std::string_view label, double width, double height) {
  add("<svg class=\"{0}\" xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {1} {2}\" style=\"--w:{1}\" role=\"img\" "
      "aria-label=\"{3}\">",
      kind, width, height, printed(label));
}

void Drawing::x_axis(const std::vector<Tick>& ticks, std::string_view label, bool grid) {
  double taken = -1e9;
  if (!grid) {
    add("<path class=\"base\" d=\"M{:.1f} {:.1f}H{:.1f}\"/>", frame_.left, frame_.bottom, frame_.right);
  }
  for (const Tick& tick : ticks) {
    const double at = x(tick.value);
    if (grid) {
      add("<path class=\"grid\" d=\"M{:.1f} {:.1f}V{:.1f}\"/>", at, frame_.top, frame_.bottom);
    } else {
      add("<path class=\"tick\" d=\"M{:.1f} {:.1f}v4\"/>", at, frame_.bottom);
    }
    const double half = 0.5 * text_width(tick.text);
    if (at - half >= taken) {
      add("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{}</text>", at, frame_.bottom + tick_row, tick.text);
      taken = at + half + 5.0;
    }
  }
  if (!label.empty()) {
    add("<text class=\"axis\" x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{}</text>",
        0.5 * (frame_.left + frame_.right), frame_.bottom + tick_row + label_row, printed(label));
  }
}

void Drawing::y_axis(const std::vector<Tick>& ticks, bool grid) {
  for (const Tick& tick : ticks) {
    const double at = y(tick.value);
    if (grid) {
      add("<path class=\"{}\" d=\"M{:.1f} {:.1f}H{:.1f}\"/>", tick.text == "0" ? "grid zero" : "grid", frame_.left, at,
          frame_.right);
    } else {
      add("<path class=\"tick\" d=\"M{:.1f} {:.1f}h-4\"/>", frame_.left, at);
    }
    add("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"end\">{}</text>", frame_.left - 8.0, at + 4.2, tick.text);
  }
}

void Drawing::remark(std::string_view text) {
  add("<text class=\"remark\" x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{}</text>",
      0.5 * (frame_.left + frame_.right), 0.5 * (frame_.top + frame_.bottom) + 4.0, printed(text));
}

double tick_column(const std::vector<Tick>& ticks) {
  double widest = 14.0;
  for (const Tick& tick : ticks) {
    widest = std::max(widest, text_width(tick.text));
  }
  return widest + 12.0;
}

double end_margin(const std::vector<Tick>& ticks) {
  return ticks.empty() ? 4.0 : std::max(4.0, 0.5 * text_width(ticks.back().text));
}

}  // namespace fantail::plot
