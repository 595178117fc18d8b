// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/core.h>

#include "table_file/mat_array.hpp"
#include "table_file/read.hpp"
#include "text/error.hpp"

namespace fantail::table_file {
namespace {

using mat::Array;
using Content = Array::Content;

const Array* find(std::span<const Array> arrays, std::string_view name) {
  const auto found = std::ranges::find(arrays, name, &Array::name);
  return found == arrays.end() ? nullptr : &*found;
}

// Of words their places, in the order in which they appear first.
Column words_column(const std::string& name, const std::vector<std::string>& lines) {
  Column column{.name = name, .kind = Kind::word};
  for (const std::string& line : lines) {
    const auto known = std::ranges::find(column.words, line);
    column.values.push_back(static_cast<double>(known - column.words.begin()));
    if (known == column.words.end()) {
      column.words.push_back(line);
    }
  }
  return column;
}

std::optional<std::vector<std::string>> texts_of(const Array& cell) {
  std::vector<std::string> texts;
  for (const Array& element : cell.elements) {
    const bool is_empty = element.rows * element.columns == 0;
    if (!is_empty && (element.content != Content::text || element.lines.size() != 1)) {
      return {};
    }
    texts.push_back(is_empty ? "" : element.lines.front());
  }
  return texts;
}

bool is_vector(const Array& array) { return array.rows == 1 || array.columns == 1; }

// Empty for what is no column.
std::optional<Column> column_of(const Array& array) {
  if (array.content == Content::numbers && is_vector(array)) {
    return Column{.name = array.name, .values = array.numbers};
  }
  if (array.content == Content::text) {
    return words_column(array.name, array.lines);
  }
  if (array.content == Content::cell && is_vector(array)) {
    if (const auto texts = texts_of(array)) {
      return words_column(array.name, *texts);
    }
  }
  return {};
}

// Those with at least so many rows.
Columns columns_of(std::span<const Array> arrays, std::size_t rows) {
  Columns all;
  for (const Array& array : arrays) {
    if (auto column = column_of(array); column && column->values.size() >= rows) {
      all.push_back(std::move(*column));
    }
  }
  return all;
}

bool is_empty(const Array& array) { return array.rows == 0 || array.columns == 0; }

bool is_single(const Array& array) { return array.rows == 1 && (array.columns == 1 || array.content == Content::text); }

// Of an array that is no column.
std::string kind_of(const Array& array) {
  if (!array.kind.empty()) {
    return std::string{array.kind};
  }
  if (array.content == Content::structure) {
    return "a struct";
  }
  if (is_single(array)) {
    return "a single value";
  }
  const std::string size = fmt::format("{} x {}", array.rows, array.columns);
  if (array.content == Content::cell) {
    return is_vector(array) ? "a cell with something else than texts" : "a cell of " + size;
  }
  return "a matrix of " + size;
}

class MatReader {
 public:
  MatReader(std::string_view file, const std::string& name, const KnownUnit& known) : name_{name}, known_{known} {
    try {
      arrays_ = mat::read_arrays(file);
    } catch (const mat::Damage& damage) {
      refuse(damage.what());
    }
    std::set<std::string_view> names;
    for (const Array& array : arrays_) {
      if (!names.insert(array.name).second) {
        refuse(fmt::format("has two variables with the name {}", array.name));
      }
    }
  }

  [[nodiscard]] Columns read() const {
    Columns columns = chosen();
    require_one_length(columns);
    require_known_units(columns);
    const Array* const words = find(arrays_, "words");
    if (words != nullptr && words->content == Content::structure) {
      for (Column& column : columns) {
        if (const Array* const list = find(words->elements, column.name); list != nullptr) {
          put_words(column, *list);
        }
      }
    }
    return columns;
  }

 private:
  [[noreturn]] void refuse(const std::string& complaint) const {
    throw text::Error{text::ErrorKind::bad_data, fmt::format("{}: {}", name_, complaint)};
  }

  [[nodiscard]] Columns chosen() const {
    if (const Array* const flight = find(arrays_, "flight");
        flight != nullptr && flight->content == Content::structure) {
      return all_columns(flight->elements, true);
    }
    const std::vector<Array>* place = &arrays_;
    std::size_t count = columns_of(arrays_, 2).empty() ? 0 : 1;
    std::string places = count == 0 ? "" : "variables";
    for (const Array& array : arrays_) {
      if (array.content != Content::structure || array.name == "words") {
        continue;
      }
      if (!columns_of(array.elements, 2).empty()) {
        places += fmt::format("{}the struct {}", ++count > 1 ? ", " : "", array.name);
        place = &array.elements;
      }
    }
    if (count > 1) {
      refuse(fmt::format("has columns in more than one place: {}; keep one, or call the struct of the flight flight",
                         places));
    }
    return all_columns(*place, false);
  }

  // What is wanted and is no column must not be missed silently: a log without its roll angle is another log.
  [[nodiscard]] Columns all_columns(const std::vector<Array>& arrays, bool is_flight) const {
    Columns columns = columns_of(arrays, 2);
    if (columns.empty() && is_flight) {
      columns = columns_of(arrays, 1);
    }
    for (const Array& array : arrays) {
      if (known_(array.name) && !is_empty(array) &&
          std::ranges::find(columns, array.name, &Column::name) == columns.end()) {
        refuse(
            fmt::format("{} is {}; a column is a vector of numbers, a cell of texts or a matrix of characters, as long "
                        "as the others",
                        array.name, kind_of(array)));
      }
    }
    return columns;
  }

  void require_known_units(const Columns& columns) const {
    const Array* const units = find(arrays_, "units");
    if (units == nullptr || units->content != Content::structure) {
      return;
    }
    for (const Column& column : columns) {
      const Array* const said = find(units->elements, column.name);
      const auto known = known_(column.name);
      if (said != nullptr && said->content == Content::text && said->lines.size() == 1 && known && *known != "-" &&
          said->lines.front() != *known) {
        refuse(
            fmt::format("units.{} is {}, and {} is read in {}", column.name, said->lines.front(), column.name, *known));
      }
    }
  }

  void require_one_length(const Columns& columns) const {
    if (columns.empty()) {
      refuse("has no columns: neither vectors nor a struct of vectors");
    }
    const auto longest = std::ranges::max_element(columns, {}, [](const Column& c) { return c.values.size(); });
    for (const Column& column : columns) {
      if (column.values.size() != longest->values.size()) {
        refuse(
            fmt::format("{} has {} values and {} has {}; save only columns of one length, or put them into a struct "
                        "flight",
                        longest->name, longest->values.size(), column.name, column.values.size()));
      }
    }
  }

  void put_words(Column& column, const Array& list) const {
    const auto texts = list.content == Content::cell ? texts_of(list) : std::nullopt;
    if (!texts || column.kind != Kind::number) {
      refuse(fmt::format("words.{} is no list of texts for the numbers of {}", column.name, column.name));
    }
    for (double& value : column.values) {
      const bool is_place = value >= 1.0 && value <= static_cast<double>(texts->size()) && value == std::floor(value);
      if (!std::isnan(value) && !is_place) {
        refuse(fmt::format("{} has the value {}, and words.{} has {} texts", column.name, value, column.name,
                           texts->size()));
      }
      value -= 1.0;
    }
    column.kind = Kind::word;
    column.words = *texts;
  }

  std::string name_;
  const KnownUnit& known_;
  std::vector<Array> arrays_;
};

}  // namespace

Columns read_mat(std::string_view file, const std::string& name, const KnownUnit& known) {
  return MatReader{file, name, known}.read();
}

}  // namespace fantail::table_file
