// SPDX-License-Identifier: MIT
#include "airframe/report.hpp"

#include <array>
#include <cmath>

#include <fmt/format.h>

#include "json/value.hpp"
#include "page/page.hpp"
#include "text/degrees.hpp"
#include "text/layout.hpp"
#include "text/number.hpp"

namespace fantail::airframe {
namespace {

using ::fantail::text::brief;
using ::fantail::text::fixed;

std::string size(const sim::Vehicle& vehicle) {
  return fmt::format("{} m long, {} mm in diameter, {} kg", brief(vehicle.geometry->length_m, 3),
                     brief(vehicle.geometry->diameter_m * 1000.0, 1), brief(vehicle.mass_kg, 3));
}

std::string range(const Line& line) {
  return line.computed && line.computed->low < line.computed->high ? range_text(*line.computed, line.decimals) : "";
}

std::string computed(const Line& line) { return line.computed ? fixed(line.computed->value, line.decimals) : ""; }

std::string in_file(const Line& line) { return line.in_file ? brief(*line.in_file, 5) : ""; }

std::string name(Stability stability) {
  switch (stability) {
    case Stability::stable: return "stable";
    case Stability::marginal: return "marginal";
    case Stability::unstable: return "unstable";
    case Stability::doubtful: return "doubtful";
    case Stability::unknown: break;
  }
  return "not_judged";
}

const char* heading(const Summary& summary) {
  const bool is_compared = summary.agrees_with_design.value_or(true);
  switch (summary.stability) {
    case Stability::stable: return is_compared ? "Stable" : "Stable, not compared";
    case Stability::marginal: return is_compared ? "Marginal" : "Marginal, not compared";
    case Stability::unstable: return "Unstable";
    case Stability::doubtful: return "Doubtful";
    case Stability::unknown: break;
  }
  return "Not judged";
}

constexpr const char* method =
    "Ranges are the method's error: normal force 10 %, centre of pressure 3 % of its distance from the nose, roll a "
    "factor "
    "of two; errors of the measurements come on top. Air of small angles, well below the speed of sound.";

}  // namespace

std::string text(const sim::Vehicle& vehicle, const Summary& summary, std::size_t columns) {
  std::string out = fmt::format("{}: {}\n{}\n\n", vehicle.name, size(vehicle), summary.sentence);
  ::fantail::text::Table table{{{""}, {"from shape"}, {"range"}, {"file", 1}, {"unit"}}};
  const auto row = [&table](const std::string& what, const std::string& computed, const std::string& range,
                            const std::string& in_file, const std::string& unit) {
    table.row({fmt::format("  {:<42}", what), fmt::format(" {:>10}", computed), fmt::format(" {:>19}", range),
               fmt::format(" {:>10}", in_file), fmt::format("  {}", unit)});
  };
  row("", "from shape", "range", "file", "unit");
  for (const Line& line : summary.lines) {
    const bool stands_alone = line.what.size() > 42 && columns != ::fantail::text::any_width;
    if (stands_alone) {
      table.row({fmt::format("  {}", line.what)});
    }
    row(stands_alone ? "" : line.what, computed(line), range(line), in_file(line), line.unit);
  }
  out += table.text(columns);
  out += fmt::format("\n{}\n", method);
  for (const std::string& remark : summary.remarks) {
    out += remark + "\n";
  }
  for (const std::string& assumed : vehicle.geometry_assumed) {
    out += "Assumed: " + assumed + "\n";
  }
  return out;
}

result::Answer answer(const Summary& summary) {
  return summary.stability == Stability::stable && summary.agrees_with_design.value_or(true) ? result::Answer::yes
         : summary.stability == Stability::unstable                                          ? result::Answer::no
                                                    : result::Answer::undecided;
}

std::string json(const sim::Vehicle& vehicle, const Summary& summary, const result::Made& made) {
  using Json = ::fantail::json::Value;
  const auto rounded = [](double value) {
    return std::isfinite(value) ? Json{::fantail::json::rounded(value, 8)} : Json{};
  };
  Json lines = Json::array();
  for (const Line& line : summary.lines) {
    Json one{{"what", line.what}, {"unit", line.unit}};
    if (line.computed) {
      one["computed"] = rounded(line.computed->value);
      one["low"] = rounded(line.computed->low);
      one["high"] = rounded(line.computed->high);
    }
    if (line.in_file) {
      one["file"] = rounded(*line.in_file);
    }
    lines.push_back(one);
  }
  Json parts = Json::array();
  for (const model::Part& part : summary.build_up.parts) {
    parts.push_back({{"name", part.name},
                     {"slope_per_rad", rounded(part.slope_per_rad)},
                     {"position_m", rounded(part.position_m)}});
  }
  Json document{{"vehicle", vehicle.name},
                {"length_m", rounded(vehicle.geometry->length_m)},
                {"diameter_m", rounded(vehicle.geometry->diameter_m)},
                {"stability", name(summary.stability)},
                {"sentence", summary.sentence},
                {"agrees_with_design", summary.agrees_with_design ? Json{*summary.agrees_with_design} : Json{}},
                {"doubts", summary.doubts},
                {"numbers", lines},
                {"parts", parts},
                {"remarks", summary.remarks},
                {"assumed", vehicle.geometry_assumed}};
  result::put_answer(document, answer(summary), summary.sentence, made);
  return document.pretty();
}

std::string html(const sim::Vehicle& vehicle, const Summary& summary) {
  const std::array columns{page::Column{"", false}, page::Column{"from shape", true}, page::Column{"range", true},
                           page::Column{"file", true}, page::Column{"unit", false}};
  std::vector<std::vector<page::Cell>> rows;
  rows.reserve(summary.lines.size());
  for (const Line& line : summary.lines) {
    rows.push_back({{.text = line.what},
                    {.text = computed(line)},
                    {.text = range(line)},
                    {.text = in_file(line)},
                    {.text = line.unit}});
  }
  const std::array part_columns{page::Column{"part", false}, page::Column{"slope / 1/rad", true},
                                page::Column{"acts at / m", true}};
  std::vector<std::vector<page::Cell>> part_rows;
  part_rows.reserve(summary.build_up.parts.size());
  for (const model::Part& part : summary.build_up.parts) {
    part_rows.push_back(
        {{.text = part.name}, {.text = fixed(part.slope_per_rad, 2)}, {.text = fixed(part.position_m, 3)}});
  }
  std::string body =
      page::section("From the side", page::figure(side_view(*vehicle.geometry, summary, page::full_page),
                                                  side_view(*vehicle.geometry, summary, page::half_page),
                                                  "To scale. The bar at the centre of pressure is its range."));
  body += page::section("Numbers", page::table(columns, rows) + page::note(method));
  body += page::section("Normal force", page::table(part_columns, part_rows) +
                                            page::note("Of small angles, on the cross-section of the body."));
  if (!summary.remarks.empty()) {
    body += page::section("Remarks", page::list(summary.remarks));
  }
  if (!vehicle.geometry_assumed.empty()) {
    body += page::section("Assumed", page::list(vehicle.geometry_assumed));
  }
  const char* verdict = heading(summary);
  return page::html({.kind = "Fantail airframe",
                     .title = vehicle.name,
                     .subtitle = size(vehicle),
                     .tone = result::tone(answer(summary)),
                     .verdict_heading = verdict,
                     .verdict = summary.sentence,
                     .body_html = body});
}

}  // namespace fantail::airframe
