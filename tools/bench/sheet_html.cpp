// SPDX-License-Identifier: MIT
#include <algorithm>
#include <string_view>
#include <vector>

#include <fmt/core.h>

#include "bench/sheet.hpp"
#include "bench/sheet_parts.hpp"
#include "core/tick_record.hpp"
#include "page/page.hpp"
#include "text/number.hpp"

namespace fantail::bench {
namespace {

using page::Tone;

Tone tone(Judgement judgement) {
  switch (judgement) {
    case Judgement::pass: return Tone::good;
    case Judgement::fail: return Tone::bad;
    case Judgement::none: break;
  }
  return Tone::unsure;
}

page::Page opening(const Sheet& sheet) {
  const Heading& h = sheet.heading;
  page::Page page{.kind = fmt::format("Fantail bench \u00b7 Canard {}", name(sheet.kind)),
                  .title = h.vehicle.empty() ? "Unnamed rocket" : h.vehicle,
                  .facts = {{"Plan", h.plan}, {"Plan CRC-32C", h.plan_crc}, {"Date", h.date}, {"Avionics", h.avionics}},
                  .tone = tone(sheet.judgement()),
                  .verdict_heading = std::string{display_name(sheet.judgement())},
                  .stamped = true,
                  .footer = "Fantail " + h.version};
  for (const std::string& text : conclusions(sheet)) {
    const std::size_t colon = text.find(": ");
    if (text.starts_with("Canard ") && colon != std::string::npos) {  // what was found, then its numbers
      page.findings.push_back({text.substr(0, colon + 1), text.substr(colon + 2)});
    } else {
      page.findings.push_back({"", text});
    }
  }
  return page;
}

std::string shown(const std::string& text, bool passed) {
  return (passed ? "" : "\u2717\u00a0") + (text == "none" ? "\u2013" : text == "-" ? "\u2212" : text::with_minus(text));
}

std::string figures(const Sheet& sheet) {
  std::vector<page::Column> columns{{""}, {"Allowed", true}};
  std::vector<std::vector<page::Cell>> rows{{{"Finding"}, {}}};
  std::vector<page::Cell> monitors{{"Avionics\u2019 own verdict"}, {"not judged"}};
  const bool judged = sheet.judgement() != Judgement::none;
  bool two_turns = false;
  bool monitored = false;
  for (const CanardResult& result : sheet.canards) {
    columns.push_back({fmt::format("Canard {}", result.canard + 1), true});
    two_turns = two_turns || (result.alone && result.together);
    std::string cause{name(result.diagnosis.cause)};
    std::ranges::replace(cause, '_', ' ');
    rows.front().push_back(judged ? page::Cell{cause, result.passed() ? Tone::good : Tone::bad}
                                  : page::Cell{"not judged"});
    const auto& verdict = sheet.heading.monitor[result.canard];
    monitored = monitored || verdict;
    monitors.push_back({verdict ? std::string{core::name(*verdict)} : ""});
  }
  const auto tone = [](bool passed) { return passed ? Tone::plain : Tone::bad; };
  for (const SheetRow& row : sheet_rows(sheet)) {
    std::vector<page::Cell> cells{{row.label + (row.unit.empty() ? "" : " / " + row.unit)}, {row.allowed}};
    for (const Cell& one : row.cells) {
      cells.push_back({shown(one.alone, one.alone_passed), tone(one.alone_passed),
                       one.together.empty() ? "" : shown(one.together, one.together_passed),
                       tone(one.together_passed)});
    }
    rows.push_back(std::move(cells));
  }
  if (monitored) {
    rows.push_back(std::move(monitors));
  }
  std::vector<page::Cell> checks;
  checks.reserve(sheet.general.size());
  for (const GeneralCheck& check : sheet.general) {
    checks.push_back({check.text, check.passed ? Tone::good : Tone::bad});
  }
  const std::string turns = two_turns ? "Upper figure: moving alone. Lower figure: all four together. " : "";
  return page::section("Figures",
                       page::table(columns, rows) +
                           page::note(turns + "Times come from the avionics\u2019 own millisecond counter.") +
                           page::list(checks));
}

}  // namespace

std::string sheet_html(const Sheet& sheet, const link::Recording& recording, const Exercise& exercise) {
  page::Page page = opening(sheet);
  page.body_html = figures(sheet);
  for (const CanardResult& result : sheet.canards) {
    const std::string_view found =
        sheet.judgement() == Judgement::none ? "is not judged" : cause_text(result.diagnosis.cause);
    page.body_html += page::section(fmt::format("Canard {} {}", result.canard + 1, found),
                                    canard_charts(result, sheet, recording, exercise));
  }
  if (!sheet.heading.notes.empty()) {
    page.body_html += page::section("Notes", page::list(sheet.heading.notes));
  }
  page.body_html += "<section class=\"sign\">\n<p>Name</p><p>Date</p><p>Signature</p>\n</section>\n";
  return page::html(page);
}

}  // namespace fantail::bench
