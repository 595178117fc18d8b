// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "page/live.hpp"

namespace fantail::page {

enum class Tone : std::uint8_t { plain, good, bad, unsure };

/// A whole page that loads nothing and prints well. Text is escaped, parts named _html are not.
struct Page {
  struct Fact {
    std::string label{};
    std::string value{};
  };
  struct Finding {
    std::string what{};  ///< in bold; may be empty
    std::string about{};
    std::string target{};  ///< id of what explains it further down; empty: nothing does
  };
  std::string kind{};  ///< "Fantail identification report", small above the title
  std::string title{};
  std::string subtitle{};
  std::vector<Fact> facts{};  ///< one without a value is left out
  Tone tone = Tone::plain;
  std::string verdict_heading{};  ///< empty: no verdict
  std::string verdict{};
  std::vector<Finding> findings{};  ///< below the verdict
  bool stamped = false;             ///< a sheet to be signed: it runs no script, and its verdict stands in a box
  std::string body_html{};
  std::string footer{};
  std::string
      command{};  ///< that makes this page again, as it is typed; empty: that of set_made_by(), with its version
  std::shared_ptr<const LiveCharts> live{};  ///< of a live_figure() in the body; null: there is none
};

[[nodiscard]] std::string html(const Page& page);
/// Its header, verdict and body, for a page that is there already.
[[nodiscard]] std::string inner_html(const Page& page);

/// What the last line of the pages of this program says: the command that makes them, and its version. To be called
/// before the first page is made, by who knows what was typed; without it there is no such line.
void set_made_by(std::string command, std::string version);
/// That command; empty when nobody has said it.
[[nodiscard]] const std::string& made_by_command();

/// Text for HTML or SVG, between tags or inside a quoted attribute. What no page may have (bytes that are no UTF-8,
/// control characters) becomes U+FFFD, and html() then says below the page what that is.
[[nodiscard]] std::string escape_html(std::string_view text);
/// The same, with real minus signs.
[[nodiscard]] std::string printed(std::string_view text);
/// JSON for the inside of a <script> element: no "<" survives, so no text can close the element.
[[nodiscard]] std::string escape_script_json(std::string_view json);

/// <section> with a heading.
[[nodiscard]] std::string section(std::string_view heading, std::string_view body_html);
/// <p>, escaped, hyphens before numbers as minus signs.
[[nodiscard]] std::string paragraph(std::string_view text);
/// Small print below a table or figures, likewise.
[[nodiscard]] std::string note(std::string_view text);
/// With an id, for a finding to point to.
[[nodiscard]] std::string note(std::string_view text, std::string_view id);
/// <figure> around an svg, the caption escaped.
[[nodiscard]] std::string figure(std::string_view svg, std::string_view caption);
/// The same drawn twice: on a screen as wide as a telephone's, and on any other. Never both are shown.
[[nodiscard]] std::string figure(std::string_view wide_svg, std::string_view narrow_svg, std::string_view caption);
/// A chart wider than half a page is drawn narrow, too.
[[nodiscard]] std::string figure(const Chart& chart, std::string_view caption = {});
/// Folded away until a reader opens it.
[[nodiscard]] std::string on_demand(std::string_view what, std::string_view body_html);
/// Figures or sections, two beside each other where there is room.
[[nodiscard]] std::string side_by_side(std::span<const std::string> parts_html);

struct Column {
  std::string heading;
  bool number = false;  ///< aligned right
};
struct Cell {
  std::string text{};
  Tone tone = Tone::plain;
  std::string below{};  ///< a second, smaller line
  Tone tone_below = Tone::plain;
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
/// <ul>, escaped. Sentences that are good or bad get a tick or a cross.
[[nodiscard]] std::string list(std::span<const std::string> sentences);
[[nodiscard]] std::string list(std::span<const Cell> sentences);

struct Link {
  std::string href{};  ///< empty: the text alone
  std::string text{};
  std::string about{};  ///< follows it
};
/// <ul>, escaped.
[[nodiscard]] std::string list(std::span<const Link> links);

}  // namespace fantail::page
