// SPDX-License-Identifier: MIT
#include "fantail/log_options.hpp"

#include <algorithm>
#include <utility>

#include <fmt/core.h>

#include "logs/flight_file.hpp"
#include "text/output_folder.hpp"

namespace fantail::tool {
namespace {

std::string objection_to_column(const std::string& text) {
  const std::size_t equals = text.find('=');
  const bool both = equals != std::string::npos && equals > 0 && equals + 1 < text.size();
  return both ? "" : '"' + text + "\" is not OURS=THEIRS, as in roll_angle_deg=phi";
}

/// What --columns says without a quantity is the unit of every angle and rate for which no other is stated. Gives back
/// the rest.
std::string without_angle_unit(std::string_view said, std::string& unit) {
  std::string rest;
  while (!said.empty()) {
    const std::size_t comma = std::min(said.find(','), said.size());
    const std::string_view part = said.substr(0, comma);
    if (part == "deg" || part == "rad") {
      unit = part;
    } else {
      rest += (rest.empty() ? "" : ",") + std::string{part};
    }
    const bool ends_with_comma = comma + 1 == said.size();
    said.remove_prefix(std::min(comma + 1, said.size()));
    rest += ends_with_comma ? "," : "";
  }
  return rest;
}

void add_older_option(const Verb& verb, const std::string& dashes, ColumnOptions& columns) {
  verb.option(dashes + "column", columns.names, "")
      .check(objection_to_column)
      .value_name("OURS=THEIRS")
      .one_word_each_time()
      .hidden();
}

}  // namespace

void add_columns_option(const Verb& verb, const std::string& dashes, ColumnOptions& columns) {
  verb.option(dashes + "columns", columns.said,
              "Columns and units of another logger, for example time=t:ms,roll_rate=p:rad/s,canard=-u:deg; rad alone "
              "applies "
              "to every angle and rate without a unit")
      .value_name("QUANTITY=COLUMN:UNIT,...");
  add_older_option(verb, dashes, columns);
  verb.option(dashes + "units", columns.units, "").one_of({"deg", "rad"}).value_name("deg|rad").hidden();
}

void add_tunnel_columns_option(const Verb& verb, ColumnOptions& columns) {
  verb.option("--columns", columns.said,
              "Columns and units of another logger, for example time=t:ms,wind_speed=v:km/h,fan=n")
      .value_name("QUANTITY=COLUMN:UNIT,...");
  add_older_option(verb, "--", columns);
}

void add_save_columns_option(const Verb& verb, bool& save) {
  verb.flag("--save-columns", save, "Save them in LOG.columns.toml, which is read from then on");
}

files::Sources sources(const ColumnOptions& columns, const std::string& dashes,
                       std::span<const files::Quantity> asked) {
  files::Sources all;
  for (const std::string& text : columns.names) {
    const files::Source source = files::parse_column(text, dashes + "column", asked);
    std::erase_if(all, [&](const files::Source& before) { return before.quantity == source.quantity; });
    all.push_back(source);
  }
  if (columns.said.empty()) {
    return all;
  }
  const files::Sources stated = files::parse_columns(columns.said, dashes + "columns", asked);
  for (const files::Source& source : stated) {
    if (files::find(all, source.quantity) != nullptr) {
      throw UsageError{
          fmt::format("{0}columns: {1} is named by {0}column, too", dashes, files::known(source.quantity).column)};
    }
  }
  return files::merged(all, stated);
}

logs::Reading reading(const ColumnOptions& columns, const std::string& dashes, bool truth) {
  std::string unit = columns.units;
  const ColumnOptions rest{.said = without_angle_unit(columns.said, unit), .names = columns.names};
  return {.columns = sources(rest, dashes, files::of_flight_csv),
          .angles = unit == "rad" ? logs::AngleUnit::radians : logs::AngleUnit::degrees,
          .truth = truth,
          .options = dashes};
}

void save_columns(const ColumnOptions& columns, const std::filesystem::path& log, const std::string& dashes) {
  std::error_code ignored;
  if (std::filesystem::is_directory(log, ignored) || logs::is_flight_log(log)) {
    throw UsageError{"--save-columns: " + log.string() + " has Fantail's own columns"};
  }
  const std::filesystem::path file = files::kept_sources_file(log);
  std::string unit;
  files::Sources kept =
      sources({.said = without_angle_unit(columns.said, unit), .names = {}}, dashes, files::of_flight_csv);
  if (std::filesystem::is_regular_file(file, ignored)) {
    kept = files::merged(kept, files::read_sources(file, files::of_flight_csv));
  }
  const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
  const text::NamedFile named{file.filename().string(), files::sources_toml(kept, log.filename().string())};
  text::OutputFolder{folder}.write(std::span{&named, 1});
}

void add_log_options(const Verb& verb, LogOptions& options) {
  add_columns_option(verb, "--", options.columns);
  add_save_columns_option(verb, options.save_columns);
  verb.flag("--truth", options.truth, "Read the true_ columns of a simulated run instead of the measured ones");
}

logs::Reading reading(const LogOptions& options) {
  if (options.save_columns && options.columns.said.empty()) {
    throw UsageError{"--save-columns: there is nothing to save without --columns"};
  }
  return reading(options.columns, "--", options.truth);
}

void save_columns(const LogOptions& options, const std::filesystem::path& log) {
  if (options.save_columns) {
    save_columns(options.columns, log, "--");
  }
}

}  // namespace fantail::tool
