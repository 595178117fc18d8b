// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "campaign/next_row.hpp"
#include "input/number_field.hpp"

namespace fantail::campaign {

enum class Law : std::uint8_t { normal, uniform, triangular, rows, next_row };

/// What a drawn number does to the values that the files say.
enum class Effect : std::uint8_t {
  value,   ///< stands in their place
  offset,  ///< is added to each
  factor,  ///< multiplies each
};

/// What becomes of a draw that a field does not allow.
enum class Outside : std::uint8_t {
  refuse,    ///< an error, with what to do about it
  truncate,  ///< drawn again: the law under the condition that every field allows it
};

/// One quantity that is not known, or several that depend on each other.
struct Spread {
  std::vector<input::NumberField> fields{};
  Law law = Law::normal;
  Effect effect = Effect::value;
  Outside outside = Outside::refuse;
  std::vector<double> means{};                ///< normal: one a field, as the next
  bool means_are_the_file_s = false;          ///< normal: no others were said
  std::vector<double> standard_deviations{};  ///< zero or more
  /// normal: a lower triangle L, row by row without zeros, so that L times independent standard normal numbers has the
  /// correlations.
  std::vector<double> correlation_root{};
  double low = 0.0;   ///< uniform and triangular, of one field
  double mode = 0.0;  ///< triangular
  double high = 0.0;
  std::filesystem::path table{};            ///< of rows: the file
  std::vector<std::vector<double>> rows{};  ///< rows: one number a field; each row as likely as another
  std::optional<NextRow> next_row{};        ///< next_row: of `rows`
  std::string where{};                      ///< file and line, for messages

  /// Whether the values that the files say play no part in what is drawn.
  [[nodiscard]] bool ignores_the_file() const { return effect == Effect::value && !means_are_the_file_s; }
  /// How many coordinates of the unit cube a draw takes.
  [[nodiscard]] std::size_t dimensions() const {
    return law == Law::normal ? fields.size() : law == Law::next_row ? next_row->normals() : 1;
  }
};

/// All tables [[spread]] of a scenario's file; none where there are none. Throws text::Error (bad_configuration,
/// bad_data, no_such_input): an unknown field, one that two spreads draw, a law without what it needs, correlations
/// that no quantities can have, a table without a column.
[[nodiscard]] std::vector<Spread> read_spreads(const input::ScenarioFiles& files);

}  // namespace fantail::campaign
