// SPDX-License-Identifier: MIT
#include <algorithm>
#include <sstream>

#include "flight/columns.hpp"
#include "flight_log/schema.hpp"
#include "json/value.hpp"
#include "log_export/formats.hpp"

namespace fantail::log_export {
namespace {

using Json = json::Value;

// By the names in its header, so that no column can be forgotten.
template <typename TextOf>
std::string listed(const std::string& table, const TextOf& text_of) {
  Json columns = Json::array();
  std::istringstream header{table.substr(0, table.find('\n'))};
  for (std::string name; std::getline(header, name, ',');) {
    const flight::ColumnText text = text_of(name);
    columns.push_back({{"column", name}, {"unit", text.unit}, {"description", text.description}});
  }
  return columns.pretty();
}

flight::ColumnText known_text(const std::string& name) {
  return flight::column_text(name).value_or(flight::ColumnText{});
}

}  // namespace

std::string columns_json(const std::string& table) { return listed(table, known_text); }

std::string foreign_columns_json(const flight_log::Flight& flight, const std::string& table) {
  const auto schema = flight_log::parse_schema(flight.schema);
  const flight_log::SchemaRecord* tick = flight_log::find_record(schema, "tick");
  return listed(table, [tick](const std::string& name) {
    if (tick != nullptr) {
      for (const flight_log::SchemaField& field : tick->fields) {
        if (name == (field.unit.empty() ? field.name : field.name + "_" + field.unit)) {
          return flight::ColumnText{.unit = field.unit.empty() ? "-" : std::string_view{field.unit},
                                    .description = "name given by the version of Fantail that wrote the log"};
        }
      }
    }
    if (name == "time_s") {
      return flight::ColumnText{.unit = "s", .description = "time since the first tick of the log"};
    }
    return known_text(name);
  });
}

}  // namespace fantail::log_export
