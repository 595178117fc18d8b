// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cctype>
#include <iterator>
#include <string_view>
#include <vector>

#include <fmt/core.h>

#include "bench/sheet.hpp"
#include "bench/sheet_parts.hpp"
#include "bench/watch.hpp"
#include "core/tick_record.hpp"
#include "page/page.hpp"
#include "text/number.hpp"

namespace fantail::bench {
namespace {

using page::Tone;

page::Page heading(const Sheet& sheet) {
  const Heading& h = sheet.heading;
  return {.kind = fmt::format("Fantail bench \u00b7 Canard {}", name(sheet.kind)),
          .title = title(h),
          .facts = {{"Plan", h.plan},
                    {"Plan CRC-32C", h.plan_crc},
                    {"Gate", h.gate},
                    {"Date", h.date},
                    {"Avionics", h.avionics},
                    {"Board", h.board ? board_text(*h.board) : ""}},
          .footer = "Fantail " + h.version};
}

page::Page::Finding as_finding(const std::string& sentence) {
  const std::size_t colon = sentence.find(": ");
  return sentence.starts_with("Canard ") && colon != std::string::npos  // what was found, then its numbers
             ? page::Page::Finding{.what = sentence.substr(0, colon + 1), .about = sentence.substr(colon + 2)}
             : page::Page::Finding{.about = sentence};
}

// What standard error says after "fantail: ".
std::string as_sentence(std::string why) {
  if (!why.empty()) {
    why.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(why.front())));
  }
  return why + ".";
}

void judge(page::Page& page, const Sheet& sheet) {
  page.tone = result::tone(answer(sheet.judgement()));
  page.verdict_heading = headline(sheet);
  page.stamped = true;
  std::ranges::transform(conclusions(sheet), std::back_inserter(page.findings), as_finding);
}

std::string shown(const std::string& text, bool passed) {
  return (passed ? "" : "\u2717\u00a0") + (text == "none" ? "\u2013" : text == "-" ? "\u2212" : text::with_minus(text));
}

std::string figures(const Sheet& sheet, bool judged) {
  std::vector<page::Column> columns{{""}, {"Allowed", true}};
  std::vector<std::vector<page::Cell>> rows{{{"Finding"}, {}}};
  std::vector<page::Cell> monitors{{"Avionics\u2019 own verdict"}, {"not judged"}};
  bool two_turns = false;
  bool monitored = false;
  for (const CanardResult& result : sheet.canards) {
    columns.push_back({fmt::format("Canard {}", result.canard + 1), true});
    two_turns = two_turns || (result.alone && result.together);
    std::string cause{finding(sheet, result, judged).name};
    std::ranges::replace(cause, '_', ' ');
    rows.front().push_back(judged ? page::Cell{cause, result.passed() ? Tone::good : Tone::bad} : page::Cell{cause});
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
  return page::section("Figures", page::table(columns, rows) +
                                      page::note(turns + "Times come from the avionics\u2019 own millisecond counter." +
                                                 (monitored ? " " + std::string{about_monitor} : "")) +
                                      page::list(checks));
}

std::string charts(const Sheet& sheet, const link::Recording& recording, const Exercise& exercise, bool judged) {
  std::string html;
  for (const CanardResult& result : sheet.canards) {
    html += page::section(fmt::format("Canard {} {}", result.canard + 1, finding(sheet, result, judged).text),
                          canard_charts(result, sheet, recording, exercise));
  }
  return html;
}

page::Page whole(const Sheet& sheet, const link::Recording& recording, const Exercise& exercise) {
  page::Page page = heading(sheet);
  judge(page, sheet);
  const bool judged = sheet.judgement() != Judgement::none;
  page.body_html = figures(sheet, judged) + charts(sheet, recording, exercise, judged);
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
                              std::size_t turns_to_come, const std::string& given_up_because) {
  page::Page page = heading(sheet);
  if (given_up_because.empty()) {
    page.verdict_heading = fmt::format("Not finished: {} to come", text::counted(turns_to_come, "more turn"));
  } else {
    page.verdict_heading = fmt::format("Ended early with {} left", text::counted(turns_to_come, "turn"));
    page.findings.push_back(as_finding(as_sentence(given_up_because)));
  }
  page.tone = given_up_because.empty() ? Tone::plain : Tone::unsure;
  for (const CanardResult& result : sheet.canards) {
    if (!result.passed()) {
      page.tone = Tone::bad;
      page.findings.push_back(as_finding(sentence(result.canard, result.diagnosis)));
    }
  }
  for (const std::string& doubt : sheet.doubts) {
    page.findings.push_back({.what = "So far there is no basis for a verdict:", .about = doubt + "."});
  }
  constexpr bool judged = true;  // what a turn has shown is not taken back before the whole sheet is
  page.body_html = figures(sheet, judged) + charts(sheet, recording, exercise, judged);
  return page::inner_html(page);
}

std::string no_sheet_html(const std::string& title, const std::string& why) {
  return page::inner_html({.kind = "Fantail bench",
                           .title = title,
                           .tone = Tone::unsure,
                           .verdict_heading = "No sheet",
                           .findings = {as_finding(as_sentence(why))}});
}

}  // namespace fantail::bench
