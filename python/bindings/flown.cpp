// SPDX-License-Identifier: MIT
#include "python/bindings/flown.hpp"

#include <algorithm>

#include "flight/columns.hpp"
#include "flight/table.hpp"
#include "text/error.hpp"

namespace fantail::python {
namespace {

template <typename Value, typename Of>
std::vector<Value> each_line(const flight::Flight& flight, const Of& of) {
  std::vector<Value> values;
  values.reserve(flight.rows.size() / flight.rows_per_line + 1);
  for (std::size_t i = 0; i < flight.rows.size(); i += flight.rows_per_line) {
    values.push_back(of(flight.rows[i]));
  }
  return values;
}

}  // namespace

std::vector<std::string> Flown::column_names() const {
  std::vector<std::string> names;
  if (!is_whole) {
    for (const auto& [name, values] : kept) {
      names.push_back(name);
    }
    return names;
  }
  for (const flight::Column& column : flight::columns_of(flight)) {
    names.emplace_back(column.name);
  }
  names.emplace(names.begin() + 1, flight::phase_column);
  if (!std::ranges::all_of(flight.rows, &flight::Row::replayed)) {
    names.emplace_back(flight::replayed_column);
  }
  return names;
}

Flown::Column Flown::column(const std::string& name) const {
  using Kind = Column::Kind;
  if (const auto found = std::ranges::find(kept, name, &std::pair<std::string, Column>::first); found != kept.end()) {
    return found->second;
  }
  if (const std::vector<std::string> names = column_names(); std::ranges::find(names, name) == names.end()) {
    throw text::Error{text::ErrorKind::bad_configuration, flight::missing_column(name, names)};
  }
  const auto bytes = [this](Kind kind, const auto& of) {
    return Column{.kind = kind, .bytes = each_line<std::uint8_t>(flight, of)};
  };
  if (name == flight::phase_column) {
    return bytes(Kind::phases, [](const flight::Row& row) { return static_cast<std::uint8_t>(row.phase); });
  }
  if (name == flight::replayed_column) {
    return bytes(Kind::flags, [](const flight::Row& row) { return row.replayed; });
  }
  const flight::Column& wanted = *flight::find_column(name);
  if (wanted.unit == flight::Column::Unit::flag) {
    return bytes(Kind::flags, [&wanted](const flight::Row& row) { return wanted.get(row) != 0.0; });
  }
  return {.numbers = each_line<double>(flight, [&wanted](const flight::Row& row) { return wanted.written(row); })};
}

void Flown::keep_only(const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    kept.emplace_back(name, column(name));
  }
  is_whole = false;
  const auto free = [](auto& list) { std::remove_reference_t<decltype(list)>{}.swap(list); };
  free(flight.rows);
  free(flight.path);
  free(flight.turning);
  free(flight.without_control);
  free(flight.tunnel_readings);
  free(flight.log);
}

void Flown::write(const std::string& folder) const {
  if (!is_whole) {
    throw text::Error{text::ErrorKind::usage, flight.scenario +
                                                  ": only some columns of this flight were kept, so its "
                                                  "files cannot be written; allowed: columns=None"};
  }
  report::write_results(flight, results, folder);
}

}  // namespace fantail::python
