// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fantail::plot {

enum class Tone : std::uint8_t { plain, good, bad, unsure };

/// A whole page that loads nothing and prints well. Text is escaped, parts named _html are not.
struct Page {
  std::string kind{};  ///< "Fantail identification report", small above the title
  std::string title{};
  std::string subtitle{};
  Tone tone = Tone::plain;
  std::string verdict_heading{};  ///< empty: no verdict
  std::string verdict{};
  std::string body_html{};
};

[[nodiscard]] std::string html(const Page& page);

/// <section> with a heading.
[[nodiscard]] std::string section(std::string_view heading, std::string_view body_html);
/// <p>, escaped, hyphens before numbers as minus signs.
[[nodiscard]] std::string paragraph(std::string_view text);
/// <figure> around an svg, the caption escaped.
[[nodiscard]] std::string figure(std::string_view svg, std::string_view caption);
/// Figures side by side where there is room.
[[nodiscard]] std::string figures(std::span<const std::string> figures_html);

struct Column {
  std::string heading;
  bool number = false;  ///< aligned right
};
struct Cell {
  std::string text;
  Tone tone = Tone::plain;
};
[[nodiscard]] std::string table(std::span<const Column> columns, std::span<const std::vector<Cell>> rows);

/// Large numbers in a row: label, value with its unit, and a remark below (may be empty).
struct Figure {
  std::string label;
  std::string value;
  std::string unit;
  std::string remark;
};
[[nodiscard]] std::string figure_row(std::span<const Figure> list);
/// <ul>, escaped.
[[nodiscard]] std::string list(std::span<const std::string> sentences);

}  // namespace fantail::plot
