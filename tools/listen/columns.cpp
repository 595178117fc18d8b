// SPDX-License-Identifier: MIT
#include "listen/columns.hpp"

#include <algorithm>
#include <array>

#include <fmt/core.h>

#include "flight/named_source.hpp"
#include "flight/table.hpp"
#include "flight/units.hpp"
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
  for (const Named& one : known_quantities) {
    names.emplace_back(one.name);
  }
  flight::refuse_unknown_quantity(where, word, names);
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

Source source_of(const flight::NamedSource& said) {
  const Named& quantity = named(said.where, said.quantity);
  const auto [column, unit] = flight::column_in_unit(said.where, quantity.name, said.source, quantity.dimension);
  Source source{.quantity = quantity.quantity,
                .column = column,
                .unit = std::string{unit->name},
                .from_rest = quantity.from_rest,
                .words = said.source};
  source.factor = sign_and_scale(said.where, source.column) * unit->si;
  return source;
}

}  // namespace

std::string_view name(Quantity quantity) {
  return std::ranges::find(known_quantities, quantity, &Named::quantity)->name;
}

Sources parse_columns(std::string_view text, const std::string& option) {
  Sources sources;
  for (const flight::NamedSource& said : flight::named_sources(text, option, "time=ts:s,axial=-Ay:m/s2")) {
    Source source = source_of(said);
    if (find(sources, source.quantity) != nullptr) {
      refuse_word(said.where, fmt::format("the quantity {} appears twice", name(source.quantity)));
    }
    sources.push_back(std::move(source));
  }
  return sources;
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
