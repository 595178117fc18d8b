// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cctype>
#include <iterator>
#include <map>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/core.h>

#include "page/page.hpp"
#include "result/document.hpp"
#include "result/parts.hpp"

namespace fantail::result {
namespace {

std::string html(const std::string& paragraph) { return page::paragraph(paragraph); }
std::string html(const Sentences& sentences) { return sentences.all.empty() ? "" : page::list(sentences.all); }
std::string html(const Picture& picture) { return page::figure(picture.chart, picture.caption); }

/// Charts over one x that stand below each other: their frames line up.
using SharedX = std::map<std::pair<std::string, double>, double>;
std::pair<std::string, double> shared_x(const page::Chart& chart) { return {chart.x_label, chart.width}; }

SharedX room_beside_frames(const std::vector<Section>& sections) {
  SharedX room;
  for (const Section& section : sections) {
    for (const Block& block : section.blocks) {
      if (const auto* picture = std::get_if<Picture>(&block)) {
        double& widest = room[shared_x(picture->chart)];
        widest = std::max(widest, page::left_of_frame(picture->chart));
      }
    }
  }
  return room;
}

Picture lined_up(Picture picture, const SharedX& room) {
  picture.chart.least_left = room.at(shared_x(picture.chart));
  return picture;
}
std::string html(const Live& live) { return page::live_figure(*live.charts, live.caption); }
std::string html(const Drawing& drawing) { return page::figure(drawing.wide, drawing.narrow, drawing.caption); }
std::string html(const Links& links) { return links.all.empty() ? "" : page::list(links.all); }
std::string html(const Data&) { return {}; }

page::Figure figure(const Figure& one) {
  const auto [number, more] = parts(one);
  const bool is_same = more == number + " to " + number;
  const std::string ends =
      std::holds_alternative<Spread>(one.value) ? "5 to 95 %: " + (is_same ? "the same" : more) : more;
  return {one.label, number, std::string{one.unit.symbol},
          one.remark + (one.remark.empty() || ends.empty() ? "" : "; ") + ends};
}

std::string html(const Figures& figures) {
  std::vector<page::Figure> list;
  for (const Figure& one : known(figures.all)) {
    list.push_back(figure(one));
  }
  return list.empty() ? "" : page::figure_row(list);
}

page::Cell in_page(const Column& column, const Cell& cell) {
  if (const auto* estimate = std::get_if<Estimate>(&cell)) {  // in one line the table is wider than the page
    return {.text = shown(column, estimate->value), .below = "± " + shown(column, estimate->reach)};
  }
  if (const auto* digits = std::get_if<Digits>(&cell)) {
    return {.text = digits->text, .tone = tone(digits->answer), .below = digits->below};
  }
  if (const auto* judged = std::get_if<Judged>(&cell)) {
    return {.text = judged->words, .tone = tone(judged->answer), .below = judged->below};
  }
  if (const auto* named = std::get_if<Named>(&cell)) {
    return {.text = named->words, .below = named->name};
  }
  return {.text = shown(column, cell)};
}

/// A longer table is folded.
constexpr std::size_t most_open_rows = 4;

/// "loop margins" of a table with that key, else what its section is called.
std::string name_of(const Table& table, const std::string& heading) {
  std::string name = table.key.value_or("");
  name = name.empty() ? heading : name;
  std::ranges::replace(name, '_', ' ');
  return name;
}

std::string html(const Table& table, const std::string& heading_of_section = {}) {
  const std::vector<std::size_t> shown_columns = known_columns(table);
  std::vector<page::Column> columns;
  for (const std::size_t i : shown_columns) {
    columns.push_back({heading(table.columns[i]), !is_words(table, i)});
  }
  std::vector<std::vector<page::Cell>> rows;
  for (std::size_t at = 0; at < table.rows.size(); at += table.read_every) {
    std::vector<page::Cell>& row = rows.emplace_back();
    for (const std::size_t i : shown_columns) {
      row.push_back(in_page(table.columns[i], table.rows[at][i]));
    }
  }
  if (rows.empty()) {
    return {};
  }
  const std::string all = page::table(columns, rows);
  return rows.size() <= most_open_rows
             ? all
             : page::on_demand(fmt::format("Table: {} ({} rows)", name_of(table, heading_of_section), rows.size()),
                               all);
}

bool is_half_page(const Block& block) {
  const auto* picture = std::get_if<Picture>(&block);
  return picture != nullptr && picture->chart.width <= page::half_page;
}

std::string body(const Section& section, const SharedX& room) {
  const std::vector<Block>& blocks = section.blocks;
  std::string all;
  const auto one = [&](const Block& block) {
    if (const auto* table = std::get_if<Table>(&block)) {
      return html(*table, section.heading);
    }
    const auto* picture = std::get_if<Picture>(&block);
    return picture != nullptr ? html(lined_up(*picture, room))
                              : std::visit([](const auto& it) { return html(it); }, block);
  };
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    if (is_half_page(blocks[i])) {
      std::vector<std::string> pair{one(blocks[i])};
      if (i + 1 < blocks.size() && is_half_page(blocks[i + 1])) {
        pair.push_back(one(blocks[++i]));
      }
      all += page::side_by_side(pair);
    } else {
      all += one(blocks[i]);
    }
  }
  return all;
}

bool has_picture(const Section& section) {
  return section.readers != Readers::programs && section.folded.empty() &&
         std::ranges::any_of(section.blocks, [](const Block& block) {
           return std::holds_alternative<Picture>(block) || std::holds_alternative<Live>(block) ||
                  std::holds_alternative<Drawing>(block);
         });
}

/// As a page has them: behind the verdict the section with the picture that answers.
std::vector<const Section*> picture_first(const std::vector<Section>& sections) {
  std::vector<const Section*> all;
  all.reserve(sections.size());
  for (const Section& section : sections) {
    all.push_back(&section);
  }
  const auto found = std::ranges::find_if(all, [](const Section* section) { return has_picture(*section); });
  if (found != all.end()) {
    std::rotate(all.begin(), found, std::next(found));
  }
  return all;
}

/// Below the heading it begins as a sentence does, whatever was before it.
std::string below_heading(const Verdict& verdict) {
  std::string text = behind_heading(verdict);
  if (!text.empty() && text != verdict.sentence) {
    text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
  }
  return text;
}

}  // namespace

std::string html(const Document& document) {
  const Verdict& verdict = document.verdict;
  page::Page page{.kind = "Fantail " + document.kind,
                  .title = document.title,
                  .subtitle = document.subtitle,
                  .tone = tone(verdict),
                  .verdict_heading = document.verdict.heading,
                  .verdict = below_heading(verdict),
                  .footer = document.footer};
  for (auto& [label, value] : read_facts(document)) {
    page.facts.push_back({std::move(label), std::move(value)});
  }
  if (document.made.command != page::made_by_command()) {
    page.command = document.made.command;
  }
  for (const std::string& sentence : verdict.beside) {
    page.findings.push_back({.about = sentence});
  }
  for (const std::string& sentence : document.verdict.not_in_it) {
    page.findings.push_back({.what = verdict.not_in_it_heading, .about = sentence});
  }
  const SharedX room = room_beside_frames(document.sections);
  for (const Section* section : picture_first(document.sections)) {
    const std::string inside = body(*section, room);
    for (const Block& block : section->blocks) {
      if (const auto* live = std::get_if<Live>(&block)) {
        page.live = live->charts;
      }
    }
    if (section->readers != Readers::programs && !inside.empty()) {
      page.body_html +=
          page::section(section->heading, section->folded.empty() ? inside : page::on_demand(section->folded, inside));
    }
  }
  return page::html(page);
}

}  // namespace fantail::result
