// SPDX-License-Identifier: MIT
// Usage: file_pages toml|ftl FOLDER DATE
// Prints fantail.toml(5) or flight.ftl(5): passages of the pages in FOLDER, which tests hold against the loaders, and
// what the tables of plan, log and signals say.
#include <cstdio>
#include <exception>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>

#include <fmt/core.h>

#include "core/tick_record_fields.hpp"
#include "input/plan_file.hpp"
#include "manual/roff.hpp"
#include "protocol/log_schema.hpp"

namespace {

using namespace fantail::manual;

std::string passages(const std::string& file) {
  std::ifstream stream{file};
  const std::string page{std::istreambuf_iterator<char>{stream}, {}};
  if (page.empty()) {
    throw std::runtime_error{file + " cannot be read"};
  }
  return roff_of_markdown(passages_for_manual(page));
}

/// Each line is "[section]", or "key = value   # meaning (unit, range)".
std::string plan_fields() {
  std::istringstream lines{fantail::input::plan_table(fantail::core::default_plan())};
  std::string text;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with('[')) {
      text += subheading(line);
    } else if (!line.empty()) {
      const std::size_t mark = line.find('#');
      text += item(bold(line.substr(0, line.find_last_not_of(' ', mark - 1) + 1)), sentence(line.substr(mark + 2)));
    }
  }
  return text;
}

/// Each line is "record bytes", or "offset type name unit".
std::string records() {
  std::string text;
  std::string fields;
  std::istringstream lines{std::string{fantail::protocol::log_schema_of_two_gyros()} +
                           std::string{fantail::protocol::log_schema_of_barometer()}};
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words{line};
    std::string first;
    std::string second;
    std::string name;
    std::string unit;
    words >> first >> second >> name >> unit;
    if (name.empty()) {
      text += fields.empty() ? "" : verbatim(fields);
      text += subheading(fmt::format("{}, {} bytes", first, second));
      fields.clear();
    } else {
      fields += fmt::format("{:>2}  {:<10}{:<24}{}\n", first, second, name, unit);
    }
  }
  return text + verbatim(fields);
}

std::string signals() {
  std::string lines;
  const fantail::core::TickRecord record;
  fantail::core::visit_signals(record, [&](const auto& signal, const auto& /*value*/) {
    lines += fmt::format("{:<24}{}\n", signal.name, signal.unit);
  });
  return verbatim(lines);
}

std::string toml_page(const Title& title, const std::string& folder) {
  return beginning(title, "scenario, vehicle and flight plan of a rocket") + heading("DESCRIPTION") +
         passages(folder + "/your_rocket.md") + heading("CAMPAIGN") + passages(folder + "/predict.md") +
         heading("FLIGHT PLAN") + passages(folder + "/flight_plan.md") + plan_fields() +
         see_also({"fantail(1)", "fantail-fly(1)", "fantail-campaign(1)", "fantail-plan(1)", "fantail-new(1)"});
}

std::string log_page(const Title& title, const std::string& folder) {
  std::string page = beginning(title, "the record of a flight, as the avionics writes it") + heading("DESCRIPTION") +
                     passages(folder + "/flight_log.md");
  page += heading("VALUES OF A RECORD");
  page += paragraph(sentence(
      "Offset, type, name and unit of each. `second_gyro` stands in a log of two gyros only, behind each `tick`; "
      "`barometer` stands behind a tick with a new pressure."));
  page += records();
  page += heading("SIGNALS");
  page += paragraph(sentence("What a replay computes from a record, and `fantail log export` writes, with the unit."));
  return page + signals() + see_also({"fantail(1)", "fantail-log(1)", "fantail-replay(1)", "fantail-report(1)"});
}

}  // namespace

int main(int argc, char** argv) {
  try {
    if (argc != 4) {
      throw std::runtime_error{"usage: file_pages toml|ftl FOLDER DATE"};
    }
    const bool is_toml = std::string_view{argv[1]} == "toml";
    const Title title{
        .name = is_toml ? "fantail.toml" : "flight.ftl", .section = 5, .date = argv[3], .version = FANTAIL_VERSION};
    fmt::print("{}", tidied(is_toml ? toml_page(title, argv[2]) : log_page(title, argv[2])));
    return 0;
  } catch (const std::exception& error) {
    fmt::print(stderr, "file_pages: {}\n", error.what());
    return 1;
  }
}
