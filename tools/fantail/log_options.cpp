// SPDX-License-Identifier: MIT
#include "fantail/log_options.hpp"

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

void add_log_options(const Verb& verb, LogOptions& options) {
  add_column_option(verb, options.columns);
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
  return {.columns = column_names(options.columns),
          .angles = options.units == "rad" ? flight::AngleUnit::radians : flight::AngleUnit::degrees,
          .truth = options.truth};
}

}  // namespace fantail::tool
