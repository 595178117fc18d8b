// SPDX-License-Identifier: MIT
#include "page/svg_plot.hpp"

#include "page/page.hpp"

namespace fantail::page {
namespace {

constexpr std::string_view narrow = "iljftrI.,:;'|!()[] /";
constexpr std::string_view wide = "mwMW@%<>&+=~";

bool begins_letter(char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }  // UTF-8

double letter_width(char c) {
  if (narrow.find(c) != std::string_view::npos) {
    return 4.5;
  }
  if (wide.find(c) != std::string_view::npos) {
    return 12.0;
  }
  // The first byte of a letter of more than two: kana, Han and Hangul are square, and emoji wider still.
  const auto first = static_cast<unsigned char>(c);
  if (first >= 0xe3) {
    return first >= 0xf0 ? 17.0 : 12.5;
  }
  return c >= 'A' && c <= 'Z' ? 8.8 : 7.6;
}

bool overlap(Box a, Box b) { return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom; }

bool holds(Box box, Pixel p) { return p.x >= box.left && p.x <= box.right && p.y >= box.top && p.y <= box.bottom; }

}  // namespace

double text_width(std::string_view text) {
  double width = 0.0;
  for (const char c : text) {
    width += begins_letter(c) ? letter_width(c) : 0.0;
  }
  return width;
}

std::string shortened(std::string_view text, double width) {
  if (text_width(text) <= width) {
    return std::string{text};
  }
  constexpr double ellipsis = 11.0;
  double used = ellipsis;
  std::size_t end = 0;
  while (end < text.size()) {
    used += letter_width(text[end]);
    if (used > width) {
      break;
    }
    do {
      ++end;
    } while (end < text.size() && !begins_letter(text[end]));
  }
  return std::string{text.substr(0, end)} + "\u2026";
}

std::optional<Box> LabelPlacer::take(std::span<const Box> candidates) {
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

void SvgPlot::begin(std::string_view kind, std::string_view label, double width, double height, std::string_view more) {
  add("<svg class=\"{0}\" xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {1} {2}\" style=\"--w:{1}\" role=\"img\" "
      "aria-label=\"{3}\"{4}>",
      kind, width, height, printed(label), more);
}

void SvgPlot::outline(std::string_view kind) {
  add("<rect class=\"{}\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\"/>", kind, frame_.left,
      frame_.top, frame_.width(), frame_.height());
}

void SvgPlot::x_axis(const std::vector<Tick>& ticks, std::string_view label) {
  add("<path class=\"base\" d=\"M{:.1f} {:.1f}H{:.1f}\"/>", frame_.left, frame_.bottom, frame_.right);
  double taken = -1e9;
  for (const Tick& tick : ticks) {
    const double at = x(tick.value);
    add("<path class=\"tick\" d=\"M{:.1f} {:.1f}v4\"/>", at, frame_.bottom);
    if (x_scale_ == Scale::logarithmic) {
      add("<path class=\"grid\" d=\"M{:.1f} {:.1f}V{:.1f}\"/>", at, frame_.top, frame_.bottom);
    }
    const double half = 0.5 * text_width(tick.text);
    if (at - half >= taken) {
      add("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{}</text>", at, frame_.bottom + tick_row, tick.text);
      taken = at + half + 5.0;
    }
  }
  if (!label.empty()) {
    add("<text class=\"axis\" x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{}</text>",
        0.5 * (frame_.left + frame_.right), frame_.bottom + tick_row + label_row,
        printed(shortened(label, frame_.width())));
  }
}

void SvgPlot::y_axis(const std::vector<Tick>& ticks, bool grid) {
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

void SvgPlot::remark(std::string_view text) {
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

}  // namespace fantail::page
