// SPDX-License-Identifier: MIT
#include "fantail/log_options.hpp"

namespace fantail::tool {

std::string objection_to_column(const std::string& text) {
  const std::size_t equals = text.find('=');
  const bool both = equals != std::string::npos && equals > 0 && equals + 1 < text.size();
  return both ? "" : '"' + text + "\" is not OURS=THEIRS, as in roll_angle_deg=phi";
}

void add_column_option(CLI::App& verb, std::vector<std::string>& columns) {
  verb.add_option("--column", columns, "A column that the file calls otherwise, as roll_rate_deg_s=gyro_x; repeatable")
      ->check(objection_to_column)
      ->type_name("OURS=THEIRS")
      ->allow_extra_args(false);
}

void add_log_options(CLI::App& verb, LogOptions& options) {
  add_column_option(verb, options.columns);
  verb.add_option("--units", options.units, "Of every angle and rate in the file")
      ->check(CLI::IsMember({"deg", "rad"}))
      ->type_name("deg|rad")
      ->capture_default_str();
  verb.add_flag("--truth", options.truth, "Read the true_ columns of a simulated run instead of the measured ones");
}

logs::ColumnNames column_names(const std::vector<std::string>& columns) {
  logs::ColumnNames names;
  for (const std::string& text : columns) {
    const std::size_t equals = text.find('=');
    names[text.substr(0, equals)] = text.substr(equals + 1);
  }
  return names;
}

logs::Reading reading(const LogOptions& options) {
  return {.columns = column_names(options.columns),
          .angles = options.units == "rad" ? logs::AngleUnit::radians : logs::AngleUnit::degrees,
          .truth = options.truth};
}

}  // namespace fantail::tool
