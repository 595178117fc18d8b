// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "flight/columns.hpp"
#include "flight/read_csv.hpp"
#include "flight/table.hpp"

namespace fantail::flight {

/// A column of a file and the column of a flight that it is.
struct FoundColumn {
  std::size_t index;
  const Column* column;
  bool needed;
  double si;  ///< one of the file's unit in SI and radians
};

/// Which columns of a table are those of a flight. Throws as read_flight_csv does.
class FoundColumns {
 public:
  FoundColumns(const Table& table, const Reading& reading, const Needs& needs);

  [[nodiscard]] const std::vector<FoundColumn>& found() const { return found_; }  ///< time_s first
  [[nodiscard]] bool has(std::string_view name) const;
  /// Where the words of the flight phase stand, if the file has them.
  [[nodiscard]] std::optional<std::size_t> phase() const;
  /// What a person may not expect: a sentence each.
  [[nodiscard]] std::vector<std::string> notes() const;

 private:
  void find(const Column& measured, bool needed);
  void add(const Column& column, std::string name, bool must_be_there, bool needed);
  [[nodiscard]] double si_of(const Column& column) const;
  [[noreturn]] void refuse_missing(const Column& column, const std::string& name) const;

  const Table& table_;
  const Reading& reading_;
  std::vector<FoundColumn> found_;
};

}  // namespace fantail::flight
