// SPDX-License-Identifier: MIT
// Any bytes as a CSV file: they are a log that keeps its promises, or refused with a sentence. Nothing else may happen.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "flight/table.hpp"
#include "identify/choices.hpp"
#include "logs/roll_log.hpp"
#include "text/error.hpp"

namespace {

using namespace fantail;

void require(bool promise) {
  if (!promise) {
    std::abort();
  }
}

bool is_sentence(const std::string& text) {
  for (const char c : text) {
    if (static_cast<unsigned char>(c) < 0x20) {
      return false;
    }
  }
  return !text.empty() && text.size() < 4000;
}

void check_table(const flight::Table& table) {
  for (std::size_t row = 0; row < table.rows(); ++row) {
    for (std::size_t column = 0; column < table.columns().size(); ++column) {
      const std::string_view cell = table.cell(row, column);
      require(cell.find('\n') == std::string_view::npos);
      const auto number = table.number(row, column);
      require(!number || std::isfinite(*number));
    }
  }
}

void check_log(const logs::RollLog& log) {
  const std::size_t rows = log.time_s.size();
  require(rows >= 2 && log.roll_angle_rad.size() == rows && log.roll_rate_rad_s.size() == rows);
  for (const auto* list : {&log.canard_rad, &log.speed_m_s, &log.height_m, &log.command_rad, &log.reference_rad,
                           &log.excitation_rad, &log.specific_force_m_s2}) {
    require(list->empty() || list->size() == rows);
  }
  require(log.phase.empty() || log.phase.size() == rows);
  for (std::size_t i = 1; i < rows; ++i) {
    require(log.time_s[i] > log.time_s[i - 1]);
  }
  for (const std::string& warning : log.warnings) {
    require(is_sentence(warning));
  }
}

void check_record(const identify::model::Record& record) {
  const std::size_t rows = record.size();
  require(rows >= 3 && record.time_s[0] == 0.0 && record.segment_begin.at(0) == 0);
  for (const auto* list : {&record.roll_angle_rad, &record.roll_rate_rad_s, &record.canard_rad, &record.speed_m_s,
                           &record.density_kg_m3}) {
    require(list->size() == rows);
    for (const double value : *list) {
      require(!std::isnan(value));
    }
  }
}

// The first byte chooses how the rest is read.
void read(std::uint8_t choice, std::string text) {
  const files::Source phi = files::parse_column("roll_angle_deg=phi", "--column", files::of_flight_csv);
  const logs::Reading reading{.columns = (choice & 1U) != 0 ? files::Sources{phi} : files::Sources{},
                              .angles = (choice & 2U) != 0 ? logs::AngleUnit::radians : logs::AngleUnit::degrees,
                              .truth = (choice & 4U) != 0};
  const logs::Needs needs{.canard = (choice & 8U) != 0, .speed = (choice & 16U) != 0};
  const identify::RecordOptions options{.lag_s = (choice & 32U) != 0 ? 0.02 : 0.0};
  const flight::Table table = flight::Table::parse(std::move(text), "log.csv");
  check_table(table);
  const logs::RollLog log = logs::roll_log(logs::read_flight_csv(table, reading, needs), table.name(), reading);
  check_log(log);
  const bool control = (choice & 64U) != 0;
  check_record(
      identify::make_record(log, control ? identify::find_window(log, "control") : identify::Window{}, options));
}

}  // namespace

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer calls it so
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) {
    return 0;
  }
  try {
    read(data[0], std::string(reinterpret_cast<const char*>(data) + 1, size - 1));
  } catch (const text::Error& error) {
    require(is_sentence(error.what()));
  }
  return 0;
}
