// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "json/value.hpp"
#include "page/chart.hpp"
#include "page/page.hpp"
#include "result/field.hpp"
#include "text/layout.hpp"
#include "text/output_folder.hpp"

namespace fantail::result {

/// The result of a verb, once for all outputs: text(), json(), html() and csv() below print the same document.
///
/// A block with a key is in JSON under it ("stability.worst": an object in an object, "runs.0": the first of a list,
/// "": among the document's own members); one without is for people alone.
struct Figures {
  std::optional<std::string> key{};
  std::vector<Figure> all{};

  /// Throws when there is no such figure.
  [[nodiscard]] Figure& operator[](std::string_view figure_key);
};
struct Table {
  std::optional<std::string> key{};
  std::vector<Column> columns{};
  std::vector<std::vector<Cell>> rows{};
  std::size_t read_every = 1;  ///< 4: a page shows each fourth row

  [[nodiscard]] std::size_t column(std::string_view column_key) const;
};
struct Sentences {
  std::optional<std::string> key{};
  std::vector<std::string> all{};
};
/// For people; files have the table that it was drawn from. Two of half a page stand beside each other.
struct Picture {
  page::Chart chart{};
  std::string caption{};

  [[nodiscard]] Picture wide() &&;
};
/// Over one clock, with a cursor and a zoom where scripts run; without them the first chart. One in a document.
struct Live {
  std::shared_ptr<const page::LiveCharts> charts{};  ///< shared, because a long run has a hundred megabytes of them
  std::string caption{};
};
/// What no chart can draw, as an SVG for a whole page and one for half of it.
struct Drawing {
  std::string wide{};
  std::string narrow{};
  std::string caption{};
};
/// For people, "run 39: held": what is behind it is a file beside the page, or nothing.
struct Links {
  std::vector<page::Link> all{};
};
/// For programs alone, where a value has a form of its own.
struct Data {
  std::string key{};
  json::Value value{};
};
using Block = std::variant<std::string, Sentences, Figures, Table, Picture, Live, Drawing, Links, Data>;

/// For whom a section is: everybody; pages and JSON, as a long table; JSON alone.
enum class Readers : std::uint8_t { all, files, programs };

/// Where it has nothing to show, its heading is left out, too.
struct Section {
  std::string heading{};
  std::vector<Block> blocks{};
  Readers readers = Readers::all;
  std::string folded{};  ///< "Show each step": a page shows it when these words are clicked; empty: at once
};

/// One thing that the result was made from. Without a label it is for programs alone, without a key for people.
struct Fact {
  std::string key;
  std::string label;
  json::Value value;
};

struct Document {
  std::string kind{};  ///< "launch prediction"
  std::string title{};
  std::string subtitle{};
  Verdict verdict;
  std::vector<Fact> facts{};
  std::vector<Section> sections{};
  std::vector<Table> spreadsheets{};  ///< a CSV file each, named by the key
  Made made{};
  int json_decimals = 6;  ///< of numbers; -8: eight digits, wherever the point is
  std::string footer{};   ///< of its page
};

/// Colours words, or does not.
using Paint = std::string (*)(page::Tone tone, std::string_view words);
/// A table that is wider than `columns` has its rows as sentences.
[[nodiscard]] std::string text(const Document& document, Paint paint = nullptr, std::size_t columns = text::any_width);
/// Throws std::logic_error when two blocks have one key.
[[nodiscard]] std::string json(const Document& document);
[[nodiscard]] std::string html(const Document& document);
/// With a row for its keys; numbers with their unit in the key, as in JSON.
[[nodiscard]] std::string csv(const Table& table);
/// The page, the JSON and the spreadsheets. `name`: of the first two, without an ending; `page`: of the page, where it
/// has another.
[[nodiscard]] std::vector<text::NamedFile> files(const Document& document, const std::string& name,
                                                 const std::string& page = {});
/// A cell as JSON has it, for Data.
[[nodiscard]] json::Value json_of(const Unit& unit, const Cell& cell, int decimals = 6);

/// A row as an object, for Data.
template <typename Row>
[[nodiscard]] json::Value json_of(const Row& row, const Fields<Row> auto& fields) {
  json::Value all;
  for (const Field<Row>& field : fields) {
    all[std::string{field.key} + std::string{field.unit.suffix}] = json_of(field.unit, field.get(row));
  }
  return all;
}

/// "Way turned: the largest angle between ... ."
[[nodiscard]] std::string sentence_of(const Column& column);

/// A row for each, a column for each field.
template <typename Row>
[[nodiscard]] Table table(std::optional<std::string> key, const std::vector<Row>& rows,
                          const Fields<Row> auto& fields) {
  Table table{.key = std::move(key)};
  for (const Field<Row>& field : fields) {
    table.columns.push_back(column(field));
  }
  for (const Row& row : rows) {
    std::vector<Cell>& cells = table.rows.emplace_back();
    for (const Field<Row>& field : fields) {
      cells.push_back(field.get(row));
    }
  }
  return table;
}

/// With the number of each row, from 0 on, in front of it.
[[nodiscard]] Table numbered(Table table, std::string key);

/// The columns of these keys, in their order; the figures, for people alone.
[[nodiscard]] Table only(const Table& table, const std::vector<std::string_view>& keys);
[[nodiscard]] Figures only(const Figures& figures, const std::vector<std::string_view>& keys);

/// The figures of several things in a column each, a row for each that is known of any of them.
[[nodiscard]] Table beside(const std::vector<std::pair<std::string, Figures>>& things);

enum class Wanted : std::uint8_t { all, that_can_be_worse };
/// One row, its fields below each other.
template <typename Row>
[[nodiscard]] Figures figures(std::string key, const Row& row, const Fields<Row> auto& fields,
                              Wanted wanted = Wanted::all) {
  Figures figures{.key = std::move(key)};
  for (const Field<Row>& field : fields) {
    if (wanted == Wanted::all || field.worse != Worse::neither) {
      figures.all.push_back({column(field), field.get(row)});
    }
  }
  return figures;
}

/// Of each field that can be worse the worst value, wherever it stands; of the others the value of the first row.
template <typename Row>
[[nodiscard]] Row worst(const std::vector<Row>& rows, const Fields<Row> auto& fields) {
  Row worst = rows.empty() ? Row{} : rows.front();
  for (const Row& row : rows) {
    for (const Field<Row>& field : fields) {
      if (is_worse(field.get(row), field.get(worst), field.worse)) {
        field.get.copy(row, worst);
      }
    }
  }
  return worst;
}

/// "Way turned: the largest angle between ... ." for each field that can be worse and that the row knows.
template <typename Row>
[[nodiscard]] std::vector<std::string> meanings(const Row& row, const Fields<Row> auto& fields) {
  std::vector<std::string> all;
  for (const Field<Row>& field : fields) {
    if (field.worse != Worse::neither && !std::holds_alternative<std::monostate>(field.get(row))) {
      all.push_back(sentence_of(column(field)));
    }
  }
  return all;
}

/// Columns of a table over another, a curve for each value of `curves` where that is a column, too. Of several rows at
/// one x the worst is drawn; a spread is drawn as a band. Half a page wide.
struct Over {
  std::string_view x;
  std::string_view curves = {};
};
[[nodiscard]] Picture plot(const Table& table, std::string_view y, const Over& over);

}  // namespace fantail::result
