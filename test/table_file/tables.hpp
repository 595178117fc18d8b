// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "table_file/column.hpp"
#include "table_file/mat_writer.hpp"

namespace fantail::table_file {

inline constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// Four rows of every kind of column, with values that are not known.
inline Columns small_table() {
  return {{.name = "time_s", .values = {0.0, 0.001, 0.002, 0.003}},
          {.name = "roll_rate_deg_s", .values = {1e-300, unknown, -0.1, 1.0 / 3.0}},
          {.name = "sequence", .kind = Kind::integer, .values = {0, 4294967295.0, unknown, -7}},
          {.name = "saturated", .kind = Kind::flag, .values = {1, 0, unknown, 1}},
          {.name = "phase", .kind = Kind::word, .values = {0, 1, unknown, 1}, .words = {"armed", "launched"}}};
}

/// Equal, where two unknown values are.
inline bool same(const std::vector<double>& a, const std::vector<double>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](double x, double y) { return x == y || (std::isnan(x) && std::isnan(y)); });
}
inline bool same(const Columns& a, const Columns& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Column& x, const Column& y) {
    return x.name == y.name && x.kind == y.kind && same(x.values, y.values) && x.words == y.words;
  });
}

/// A reader that asks for the roll angle.
inline std::optional<std::string> known(std::string_view name) {
  return name == "roll_angle_deg" ? std::optional<std::string>{"deg"} : std::nullopt;
}

/// A MAT-file whose struct `flight` has these columns and whose struct `words` has their words.
inline std::string mat_file(const Columns& columns) {
  std::vector<mat::Member> flight;
  std::vector<mat::Member> words;
  for (const Column& column : columns) {
    std::vector<double> values = column.values;
    if (column.kind == Kind::word) {
      std::vector<std::string> texts;
      for (const std::string& word : column.words) {
        texts.push_back(mat::text(word));
      }
      words.push_back({column.name, {mat::cell(texts)}});
      for (double& value : values) {
        value += 1.0;
      }
    }
    flight.push_back({column.name, {mat::column(values)}});
  }
  return mat::file(std::vector{mat::structs(1, flight, "flight"), mat::structs(1, words, "words")});
}

}  // namespace fantail::table_file
