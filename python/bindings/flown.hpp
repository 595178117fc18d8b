// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "flight/flight.hpp"
#include "report/results.hpp"

namespace fantail::python {

/// A flight with its results, which are made where nobody waits for the interpreter.
struct Flown {
  /// One column of flight.csv: numbers, or a byte a row.
  struct Column {
    enum class Kind : std::uint8_t { numbers, flags, phases };
    Kind kind = Kind::numbers;
    std::vector<double> numbers{};
    std::vector<std::uint8_t> bytes{};
  };

  flight::Flight flight;
  report::Results results;
  std::vector<std::pair<std::string, Column>> kept{};  ///< of a flight without its rows
  bool is_whole = true;

  explicit Flown(flight::Flight&& flown)
      : flight{std::move(flown)},
        results{report::results(flight, {.version = FANTAIL_VERSION, .seed = flight.seed, .changes = flight.changes})} {
  }

  /// In the order of flight.csv.
  [[nodiscard]] std::vector<std::string> column_names() const;
  /// Throws text::Error (bad_configuration) for a name that is none of these.
  [[nodiscard]] Column column(const std::string& name) const;

  /// Lets go of every other row, table and record: of some 10 MB a flight, what is asked for is left.
  void keep_only(const std::vector<std::string>& names);

  /// The files of `fantail fly`. Throws text::Error (usage) for a flight that is not whole.
  void write(const std::string& folder) const;
};

}  // namespace fantail::python
