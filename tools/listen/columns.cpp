// SPDX-License-Identifier: MIT
#include "listen/columns.hpp"

#include <algorithm>
#include <array>

#include <fmt/core.h>

#include "flight/table.hpp"
#include "flight/units.hpp"
#include "input/messages.hpp"
#include "text/error.hpp"
#include "text/number.hpp"

namespace fantail::listen {
namespace {

using flight::Dimension;

struct Named {
  std::string_view name;
  Quantity quantity;
  Dimension dimension;
  bool from_rest = false;
};

constexpr std::array known_quantities{
    Named{"time", Quantity::time, Dimension::time},
    Named{"axial", Quantity::axial, Dimension::acceleration},
    Named{"axial_from_rest", Quantity::axial, Dimension::acceleration, true},
    Named{"second_axial", Quantity::second_axial, Dimension::acceleration},
    Named{"second_axial_from_rest", Quantity::second_axial, Dimension::acceleration, true},
    Named{"lateral_y", Quantity::lateral_y, Dimension::acceleration},
    Named{"lateral_z", Quantity::lateral_z, Dimension::acceleration},
    Named{"roll_rate", Quantity::roll_rate, Dimension::angular_rate},
    Named{"pitch_rate", Quantity::pitch_rate, Dimension::angular_rate},
    Named{"yaw_rate", Quantity::yaw_rate, Dimension::angular_rate},
    Named{"height", Quantity::height, Dimension::length},
    Named{"speed", Quantity::speed, Dimension::speed},
};

[[noreturn]] void refuse_word(const std::string& where, const std::string& complaint) {
  throw text::Error{text::ErrorKind::bad_configuration, where + ": " + complaint};
}

const Named& named(const std::string& where, const std::string& word) {
  const auto found = std::ranges::find(known_quantities, word, &Named::name);
  if (found != known_quantities.end()) {
    return *found;
  }
  std::vector<std::string> names;
  std::string allowed;
  for (const Named& one : known_quantities) {
    names.emplace_back(one.name);
    allowed += fmt::format(" {}", one.name);
  }
  std::string message = fmt::format("unknown quantity {}", flight::in_quotes(word));
  if (const auto meant = input::suggestion(word, names)) {
    message += fmt::format("; did you mean {}?", *meant);
  }
  refuse_word(where, fmt::format("{} Allowed:{}", message, allowed));
}

const flight::Unit& unit_of(const std::string& where, const Named& quantity, const std::string& source,
                            std::string& column) {
  const std::string allowed = flight::unit_names(quantity.dimension);
  const std::size_t colon = source.rfind(':');
  if (colon == std::string::npos || colon == 0) {
    refuse_word(where, fmt::format("{}: its unit is missing, as in {}:{}; allowed: {}", flight::in_quotes(source),
                                   source, allowed.substr(0, allowed.find(',')), allowed));
  }
  const std::string word = source.substr(colon + 1);
  const flight::Unit* const unit = flight::find_unit(word);
  if (unit == nullptr || unit->dimension != quantity.dimension) {
    refuse_word(where,
                fmt::format("{} is no unit of {}; allowed: {}", flight::in_quotes(word), quantity.name, allowed));
  }
  column = source.substr(0, colon);
  return *unit;
}

// Takes "-" and "SCALE*" off the front of a column's name.
double sign_and_scale(const std::string& where, std::string& column) {
  double factor = 1.0;
  if (column.starts_with('-')) {
    factor = -1.0;
    column.erase(0, 1);
  }
  if (const std::size_t star = column.find('*'); star != std::string::npos) {
    const auto scale = text::number(column.substr(0, star));
    if (!scale || *scale == 0.0) {
      refuse_word(where, fmt::format("{} is no scale; a number other than 0 is expected before the *, as in 0.5*{}",
                                     flight::in_quotes(column.substr(0, star)), column.substr(star + 1)));
    }
    factor *= *scale;
    column.erase(0, star + 1);
  }
  if (column.empty()) {
    refuse_word(where, "the name of the column is missing");
  }
  return factor;
}

Source source_of(const std::string& where, const std::string& word, const std::string& text) {
  const Named& quantity = named(where, word);
  Source source{.quantity = quantity.quantity, .from_rest = quantity.from_rest, .words = text};
  const flight::Unit& unit = unit_of(where, quantity, text, source.column);
  source.unit = unit.name;
  source.factor = sign_and_scale(where, source.column) * unit.si;
  return source;
}

}  // namespace

std::string_view name(Quantity quantity) {
  return std::ranges::find(known_quantities, quantity, &Named::quantity)->name;
}

Sources parse_columns(std::string_view text, const std::string& option) {
  Sources sources;
  while (true) {
    const std::size_t comma = std::min(text.find(','), text.size());
    const std::string part{text.substr(0, comma)};
    const std::size_t equals = part.find('=');
    const std::string where = fmt::format("{} {}", option, part);
    if (equals == std::string::npos || equals == 0 || equals + 1 == part.size()) {
      refuse_word(where, "expected QUANTITY=COLUMN:UNIT, several with commas between, as in time=ts:s,axial=-Ay:m/s2");
    }
    sources.push_back(source_of(where, part.substr(0, equals), part.substr(equals + 1)));
    const auto same = [&](const Source& other) { return other.quantity == sources.back().quantity; };
    if (std::ranges::count_if(sources, same) > 1) {
      refuse_word(where, fmt::format("the quantity {} appears twice", name(sources.back().quantity)));
    }
    if (comma == text.size()) {
      return sources;
    }
    text.remove_prefix(comma + 1);
  }
}

Sources merged(const Sources& first, const Sources& second) {
  Sources both = first;
  std::ranges::copy_if(second, std::back_inserter(both),
                       [&](const Source& source) { return find(first, source.quantity) == nullptr; });
  return both;
}

const Source* find(const Sources& sources, Quantity quantity) {
  const auto found = std::ranges::find(sources, quantity, &Source::quantity);
  return found == sources.end() ? nullptr : &*found;
}

}  // namespace fantail::listen
