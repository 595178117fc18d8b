// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "files/mat_writer.hpp"
#include "log_export/about.hpp"
#include "log_export/fields.hpp"
#include "log_export/formats.hpp"

namespace fantail::log_export {
namespace {

namespace matlab = files::mat;
using Json = json::Value;

bool are_all(const Json& list, bool (Json::*is)() const) {
  return std::all_of(list.begin(), list.end(), [is](const Json& element) { return (element.*is)(); });
}

std::string array(const Json& value, std::string_view name = {});

std::string structs(const std::vector<const Json*>& objects, std::string_view name) {
  std::vector<matlab::Member> members;
  for (const json::Member& first : objects.front()->members()) {
    members.push_back({.name = first.key, .elements = {}});
    for (const Json* const object : objects) {
      members.back().elements.push_back(array((*object)[first.key]));
    }
  }
  return matlab::structs(objects.size(), members, name);
}

// What is known of a flight, in MATLAB's terms: null is empty, a flag 0 or 1, a list of numbers a column, one of
// objects an array of structs (all have the same members), any other a cell.
std::string array(const Json& value, std::string_view name) {
  if (value.is_object()) {
    return structs({&value}, name);
  }
  if (value.is_array()) {
    if (!value.empty() && are_all(value, &Json::is_object)) {
      std::vector<const Json*> objects;
      std::ranges::transform(value, std::back_inserter(objects), [](const Json& object) { return &object; });
      return structs(objects, name);
    }
    if (are_all(value, &Json::is_number)) {
      std::vector<double> numbers;
      std::ranges::transform(value, std::back_inserter(numbers), &Json::number);
      return matlab::column(numbers, name);
    }
    std::vector<std::string> elements;
    std::ranges::transform(value, std::back_inserter(elements), [](const Json& element) { return array(element); });
    return matlab::cell(elements, name);
  }
  if (value.is_text()) {
    return matlab::text(value.text(), name);
  }
  if (value.is_null()) {
    return matlab::column({}, name);
  }
  const double number = value.is_number() ? value.number() : static_cast<double>(value.boolean());
  return matlab::column({&number, 1}, name);
}

std::string texts(const std::vector<std::string>& list) {
  std::vector<std::string> elements;
  std::ranges::transform(list, std::back_inserter(elements),
                         [](const std::string& text) { return matlab::text(text); });
  return matlab::cell(elements);
}

}  // namespace

std::string mat(const ReplayedFlight& source, const Selection& selection) {
  std::vector<matlab::Member> flight;
  std::vector<matlab::Member> words;
  for (files::Column& column : tick_columns(source, selection)) {
    if (column.kind == files::Kind::word) {
      words.push_back({column.name, {texts(column.words)}});
      std::ranges::transform(column.values, column.values.begin(), [](double place) { return place + 1.0; });
    }
    flight.push_back({column.name, {matlab::column(column.values)}});
  }
  std::vector<matlab::Member> units;
  std::vector<matlab::Member> descriptions;
  for (const std::size_t i : selection) {
    units.push_back({fields()[i].name, {matlab::text(fields()[i].unit)}});
    descriptions.push_back({fields()[i].name, {matlab::text(fields()[i].description)}});
  }
  const Json all = about(source, selection);
  Json rest;  // all of it but what stands in units and descriptions
  for (const json::Member& member : all.members()) {
    if (member.key != "columns") {
      rest[member.key] = member.value;
    }
  }
  return matlab::file(std::vector{matlab::structs(1, flight, "flight"), matlab::structs(1, units, "units"),
                                  matlab::structs(1, descriptions, "descriptions"), matlab::structs(1, words, "words"),
                                  array(rest, "about")});
}

}  // namespace fantail::log_export
