// SPDX-License-Identifier: MIT
// Any bytes as somebody's log: a ULog, words that say which column is what, a CSV file that is flown through the law.
// Each is read as its header promises, or refused with a sentence.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "chosen_input.hpp"
#include "core/flight_plan_members.hpp"
#include "listen/fly_log.hpp"
#include "listen/load.hpp"
#include "listen/maps.hpp"
#include "listen/ulog.hpp"

namespace fantail::fuzz {
namespace {

constexpr double longest_flown_s = 4.0;

template <typename T>
std::string bytes(T value) {
  return {reinterpret_cast<const char*>(&value), sizeof value};
}

std::string message(char type, const std::string& content) {
  return bytes(static_cast<std::uint16_t>(content.size())) + type + content;
}

std::string ulog() {
  std::string file = std::string{"ULog\x01\x12\x35\x01", 8} + bytes(std::uint64_t{1'000'000}) +
                     message('B', std::string(40, '\0')) +
                     message('F', "sensor_combined:uint64_t timestamp;float[3] gyro_rad;float[3] accelerometer_m_s2;") +
                     message('F', "vehicle_air_data:uint64_t timestamp;float baro_alt_meter;uint8_t[4] _padding0;") +
                     message('A', bytes<std::uint8_t>(0) + bytes<std::uint16_t>(7) + "sensor_combined") +
                     message('A', bytes<std::uint8_t>(0) + bytes<std::uint16_t>(9) + "vehicle_air_data");
  for (std::uint64_t i = 0; i < 8; ++i) {
    const std::uint64_t time_us = 1'000'000 + 4000 * i;
    file += message('D', bytes<std::uint16_t>(7) + bytes(time_us) + std::string(24, '\1'));
    file += message('D', bytes<std::uint16_t>(9) + bytes(time_us + 500) + bytes(100.0F));
    file += message('S', std::string{"\x2F\x73\x13\x20\x25\x0C\xBB\x12", 8});
  }
  return file;
}

// Time and axial force, between other cells.
std::string csv(const std::string& header, const std::string& before, const std::string& after) {
  std::string text = header;
  for (int i = 0; i < 120; ++i) {
    text += before + std::to_string(0.02 * i) + (i < 40 ? ",9.8" : ",55.5") + after;
  }
  return text;
}

void check(const table_file::Columns& columns) {
  require(!columns.empty() && columns.front().name == "timestamp");
  double last = -1.0;
  for (const double time : columns.front().values) {
    require(time >= last);
    last = time;
  }
  for (const table_file::Column& column : columns) {
    require(column.values.size() == columns.front().values.size());
  }
}

void check(const listen::Signal& signal) {
  require(signal.time_s.size() == signal.value.size());
  for (std::size_t i = 0; i < signal.time_s.size(); ++i) {
    require(std::isfinite(signal.time_s[i]) && std::isfinite(signal.value[i]));
    require(i == 0 || signal.time_s[i - 1] < signal.time_s[i]);
  }
}

void check(const listen::Heard& heard) {
  for (const std::string& note : heard.notes) {
    require_sentence(note);
  }
  for (const double value : {heard.apogee_m, heard.fastest.value, heard.hardest.value, heard.longest_rest_s}) {
    require(std::isfinite(value));
  }
  require(!heard.control || heard.detected_s || !heard.false_detections_s.empty());
}

void read_csv(std::string bytes_of_file) {
  std::vector<std::string> notes;
  const flight::Table table = flight::Table::parse(listen::tidy(std::move(bytes_of_file), notes), "x.csv");
  const listen::Map* const map = listen::map_of(table.columns());
  const listen::Sources sources =
      map != nullptr ? listen::sources_of(*map) : listen::parse_columns("time=t:s,axial=a:m/s2", "--columns");
  listen::ImuLog log = listen::imu_log(table, sources);
  for (const auto* signal : {&log.axial, &log.lateral_y, &log.roll_rate, &log.pitch_rate, &log.height, &log.speed}) {
    check(*signal);
  }
  if (log.end_s() - log.begin_s() < longest_flown_s) {
    check(listen::fly_log(std::move(log), {.plan_name = "default", .plan = core::default_plan(), .pad_s = 2.5}));
  }
}

// The first byte chooses what the rest is.
void read(std::uint8_t choice, std::string input) {
  switch (choice % 3) {
    case 0: check(listen::read_ulog(input, "x.ulg").columns); return;
    case 1:
      for (const listen::Source& source : listen::parse_columns(input, "--columns")) {
        require(std::isfinite(source.factor) && source.factor != 0.0);
      }
      return;
    default: read_csv(std::move(input));
  }
}

}  // namespace

std::vector<std::string> seeds() {
  return {std::string{'\0'} + ulog(),
          std::string{'\1'} + "time=ts:s,axial=-Ay:m/s2,roll_rate=Gy:deg/s,height=0.3048*alt:m",
          std::string{'\1'}.append(listen::maps().front().columns), std::string{'\2'} + csv("t,a,alt\n", "", ",12\n"),
          std::string{'\2'} + csv("#version,serial,flight,time,acceleration\n", "8,1234,1,", "\n")};
}

}  // namespace fantail::fuzz

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer calls it so
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return fantail::fuzz::read_chosen(data, size, fantail::fuzz::read);
}
