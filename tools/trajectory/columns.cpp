// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cctype>
#include <string_view>
#include <utility>

#include <fmt/core.h>

#include "text/error.hpp"
#include "text/number.hpp"
#include "trajectory/series.hpp"

namespace fantail::trajectory {
namespace {

using files::Dimension;

/// What a rocket can have, in SI: beyond it a column is not what its name says.
std::pair<double, double> range_of(Dimension dimension) {
  switch (dimension) {
    case Dimension::time: return {-1e5, 1e5};
    case Dimension::length: return {-1e4, 1e6};
    case Dimension::speed: return {-2e4, 2e4};
    case Dimension::acceleration: return {-1e5, 1e5};
    case Dimension::angle:
    case Dimension::angular_rate: return {-7.0, 7.0};
    case Dimension::density: return {1e-4, 5.0};
    case Dimension::temperature: return {100.0, 400.0};
    case Dimension::pressure: break;
  }
  return {1.0, 3e5};
}

struct Header {
  std::string_view name;
  std::string_view unit;  ///< empty: none
};

Header split(std::string_view column) {
  const std::size_t open = column.rfind('(');
  if (!column.ends_with(')') || open == std::string_view::npos || open == 0) {
    return {column, {}};
  }
  return {text::trimmed(column.substr(0, open)), text::trimmed(column.substr(open + 1, column.size() - open - 2))};
}

bool same_but_for_capitals(std::string_view a, std::string_view b) {
  const auto lower = [](unsigned char c) { return std::tolower(c); };
  return std::ranges::equal(a, b, {}, lower, lower);
}

}  // namespace

Columns::Columns(const flight::Table& table) {
  for (const files::ExportedColumn& known : files::exported_columns()) {
    const Dimension dimension = *files::known(known.quantity).dimension;
    for (std::size_t i = 0; i < table.columns().size() && find(known.quantity) == nullptr; ++i) {
      const std::string_view column = text::trimmed(table.columns()[i]);
      const Header header = split(column);
      // A name of OpenRocket has parentheses of its own.
      const bool no_unit = same_but_for_capitals(column, known.name);
      if (!no_unit && !same_but_for_capitals(header.name, known.name)) {
        continue;
      }
      const files::Unit* const unit = no_unit ? nullptr : files::find_unit(files::plainly_spelt(header.unit));
      if (unit == nullptr || unit->dimension != dimension) {
        throw text::Error{text::ErrorKind::bad_data,
                          fmt::format("{}:{}: the column {} {}; allowed, in parentheses behind the name: {}",
                                      table.name(), table.header_line(), flight::in_quotes(table.columns()[i]),
                                      no_unit || header.unit.empty() ? "has no unit" : "has a unit that is not known",
                                      files::unit_names(dimension))};
      }
      const auto [least, most] = range_of(dimension);
      found_.push_back({known.quantity,
                        std::string{known.name},
                        {.column = i, .factor = unit->si, .offset = unit->offset, .least = least, .most = most}});
    }
  }
}

const FoundColumn* Columns::find(Quantity quantity) const {
  const auto found = std::ranges::find(found_, quantity, &FoundColumn::quantity);
  return found == found_.end() ? nullptr : &*found;
}

std::string names_of(Quantity quantity) {
  std::string names;
  for (const files::ExportedColumn& known : files::exported_columns()) {
    if (known.quantity == quantity && known.languages.empty()) {
      names += fmt::format("{}\"{}\" ({})", names.empty() ? "" : " or ", known.name, known.writer);
    }
  }
  return names;
}

}  // namespace fantail::trajectory
