// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
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

Columns columns_of(std::span<const Array> arrays) {
  Columns all;
  for (const Array& array : arrays) {
    if (auto column = column_of(array); column && column->values.size() > 1) {
      all.push_back(std::move(*column));
    }
  }
  return all;
}

class MatReader {
 public:
  MatReader(std::string_view file, const std::string& name) : name_{name} {
    try {
      arrays_ = mat::read_arrays(file);
    } catch (const mat::Damage& damage) {
      refuse(damage.what());
    }
  }

  [[nodiscard]] Columns read() const {
    Columns columns = chosen();
    require_one_length(columns);
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
      return columns_of(flight->elements);
    }
    Columns result = columns_of(arrays_);
    std::string places = result.empty() ? "" : "variables";
    std::size_t count = result.empty() ? 0 : 1;
    for (const Array& array : arrays_) {
      if (array.content != Content::structure || array.name == "words") {
        continue;
      }
      if (Columns of_struct = columns_of(array.elements); !of_struct.empty()) {
        places += fmt::format("{}the struct {}", ++count > 1 ? ", " : "", array.name);
        result = std::move(of_struct);
      }
    }
    if (count > 1) {
      refuse(fmt::format("has columns in more than one place: {}; keep one, or call the struct of the flight flight",
                         places));
    }
    return result;
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
  std::vector<Array> arrays_;
};

}  // namespace

Columns read_mat(std::string_view file, const std::string& name) { return MatReader{file, name}.read(); }

}  // namespace fantail::table_file
