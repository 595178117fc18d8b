// SPDX-License-Identifier: MIT
#include "fantail/log_options.hpp"

#include <span>

#include <fmt/core.h>

#include "logs/column_map.hpp"
#include "logs/flight_file.hpp"
#include "text/output_folder.hpp"

namespace fantail::tool {

std::string objection_to_column(const std::string& text) {
  const std::size_t equals = text.find('=');
  const bool both = equals != std::string::npos && equals > 0 && equals + 1 < text.size();
  return both ? "" : '"' + text + "\" is not OURS=THEIRS, as in roll_angle_deg=phi";
}

void add_column_option(const Verb& verb, std::vector<std::string>& columns) {
  verb.option("--column", columns, "A column that has another name in the file, as roll_rate_deg_s=gyro_x; repeatable")
      .check(objection_to_column)
      .value_name("OURS=THEIRS")
      .one_word_each_time();
}

void add_column_map_option(const Verb& verb, const std::string& name, std::string& map) {
  verb.option(name, map, "Another logger's columns and units, as time=t:ms,roll_rate=p:rad/s,canard=u:deg")
      .value_name("QUANTITY=COLUMN:UNIT,...");
}

void add_save_columns_option(const Verb& verb, bool& save_map) {
  verb.flag("--save-columns", save_map, "Keep that in LOG.columns.toml, which is read from then on");
}

void add_log_options(const Verb& verb, LogOptions& options) {
  add_column_option(verb, options.columns);
  add_column_map_option(verb, "--columns", options.map);
  add_save_columns_option(verb, options.save_map);
  verb.option("--units", options.units, "Unit of every angle and rate in the file")
      .one_of({"deg", "rad"})
      .value_name("deg|rad")
      .show_default();
  verb.flag("--truth", options.truth, "Read the true_ columns of a simulated run instead of the measured ones");
}

flight::ColumnNames column_names(const std::vector<std::string>& columns) {
  flight::ColumnNames names;
  for (const std::string& text : columns) {
    const std::size_t equals = text.find('=');
    names[text.substr(0, equals)] = text.substr(equals + 1);
  }
  return names;
}

flight::Reading reading(const LogOptions& options) {
  if (options.save_map && options.map.empty()) {
    throw UsageError{"--save-columns: there is nothing to keep without --columns"};
  }
  flight::Reading reading{.columns = column_names(options.columns),
                          .angles = options.units == "rad" ? flight::AngleUnit::radians : flight::AngleUnit::degrees,
                          .truth = options.truth};
  apply_typed_map(options.map, "--columns", reading);
  return reading;
}

void apply_typed_map(const std::string& map, const std::string& option, flight::Reading& reading) {
  if (map.empty()) {
    return;
  }
  const logs::ColumnMap columns = logs::parse_column_map(map, option);
  for (const logs::MappedColumn& column : columns) {
    if (reading.columns.contains(column.ours)) {
      throw UsageError{
          fmt::format("{}: {} is named by {}, too", option, column.ours, option.substr(0, option.size() - 1))};
    }
  }
  logs::apply_map(columns, reading);
}

void save_column_map(const std::string& map, const std::filesystem::path& log, const std::string& option) {
  std::error_code ignored;
  if (std::filesystem::is_directory(log, ignored) || logs::is_flight_log(log)) {
    throw UsageError{"--save-columns: " + log.string() + " has Fantail's own columns"};
  }
  const std::filesystem::path file = logs::column_map_file(log);
  logs::ColumnMap columns = logs::parse_column_map(map, option);
  if (std::filesystem::is_regular_file(file, ignored)) {
    columns = logs::merged(columns, logs::read_column_map(file));
  }
  const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
  const text::NamedFile kept{file.filename().string(), logs::column_map_toml(columns, log.filename().string())};
  text::OutputFolder{folder}.write(std::span{&kept, 1});
}

}  // namespace fantail::tool
