// SPDX-License-Identifier: MIT
#include <algorithm>
#include <iterator>
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

page::Page heading(const Sheet& sheet) {
  const Heading& h = sheet.heading;
  return {.kind = fmt::format("Fantail bench \u00b7 Canard {}", name(sheet.kind)),
          .title = h.vehicle.empty() ? "Unnamed rocket" : h.vehicle,
          .facts = {{"Plan", h.plan}, {"Plan CRC-32C", h.plan_crc}, {"Date", h.date}, {"Avionics", h.avionics}},
          .footer = "Fantail " + h.version};
}

page::Page::Finding finding(const std::string& sentence) {
  const std::size_t colon = sentence.find(": ");
  return sentence.starts_with("Canard ") && colon != std::string::npos  // what was found, then its numbers
             ? page::Page::Finding{.what = sentence.substr(0, colon + 1), .about = sentence.substr(colon + 2)}
             : page::Page::Finding{.about = sentence};
}

void judge(page::Page& page, const Sheet& sheet) {
  page.tone = tone(sheet.judgement());
  page.verdict_heading = display_name(sheet.judgement());
  page.stamped = true;
  std::ranges::transform(conclusions(sheet), std::back_inserter(page.findings), finding);
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

std::string charts(const Sheet& sheet, const link::Recording& recording, const Exercise& exercise) {
  std::string html;
  for (const CanardResult& result : sheet.canards) {
    const std::string_view found =
        sheet.judgement() == Judgement::none ? "is not judged" : cause_text(result.diagnosis.cause);
    html += page::section(fmt::format("Canard {} {}", result.canard + 1, found),
                          canard_charts(result, sheet, recording, exercise));
  }
  return html;
}

page::Page whole(const Sheet& sheet, const link::Recording& recording, const Exercise& exercise) {
  page::Page page = heading(sheet);
  judge(page, sheet);
  page.body_html = figures(sheet) + charts(sheet, recording, exercise);
  if (!sheet.heading.notes.empty()) {
    page.body_html += page::section("Notes", page::list(sheet.heading.notes));
  }
  page.body_html += "<section class=\"sign\">\n<p>Name</p><p>Date</p><p>Signature</p>\n</section>\n";
  return page;
}

}  // namespace

std::string sheet_html(const Sheet& sheet, const link::Recording& recording, const Exercise& exercise) {
  return page::html(whole(sheet, recording, exercise));
}

std::string sheet_inner_html(const Sheet& sheet, const link::Recording& recording, const Exercise& exercise) {
  return page::inner_html(whole(sheet, recording, exercise));
}

std::string sheet_so_far_html(const Sheet& sheet, const link::Recording& recording, const Exercise& exercise,
                              std::size_t turns_to_come) {
  page::Page page = heading(sheet);
  page.verdict_heading =
      fmt::format("Not finished: {} more turn{} to come", turns_to_come, turns_to_come == 1 ? "" : "s");
  for (const CanardResult& result : sheet.canards) {
    if (sheet.judgement() != Judgement::none && !result.passed()) {
      page.findings.push_back(finding(sentence(result.canard, result.diagnosis)));
    }
  }
  page.tone = page.findings.empty() ? Tone::plain : Tone::bad;
  page.body_html = figures(sheet) + charts(sheet, recording, exercise);
  return page::inner_html(page);
}

}  // namespace fantail::bench
