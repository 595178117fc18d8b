// SPDX-License-Identifier: MIT
// Any bytes as somebody's log: words that say which column is what, a CSV file that is flown through the law.
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

namespace fantail::fuzz {
namespace {

constexpr double longest_flown_s = 4.0;

// Time and axial force, between other cells.
std::string csv(const std::string& header, const std::string& before, const std::string& after) {
  std::string text = header;
  for (int i = 0; i < 120; ++i) {
    text += before + std::to_string(0.02 * i) + (i < 40 ? ",9.8" : ",55.5") + after;
  }
  return text;
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

files::Sources parse(const std::string& text) {
  return files::parse_columns(text, "--columns", listen::heard_quantities);
}

void read_csv(std::string bytes_of_file) {
  const files::Loaded file = files::parse(std::move(bytes_of_file), "x.csv");
  const files::Logger* const logger = files::logger_of(file.table.columns());
  const files::Sources sources =
      logger != nullptr ? files::sources_of(*logger, listen::heard_quantities) : parse("time=t:s,axial=a:m/s2");
  listen::ImuLog log = listen::imu_log(file, sources);
  for (const auto* signal : {&log.axial, &log.lateral_y, &log.roll_rate, &log.pitch_rate, &log.height, &log.speed}) {
    check(*signal);
  }
  if (log.end_s() - log.begin_s() < longest_flown_s) {
    check(listen::fly_log(std::move(log), {.plan_name = "default", .plan = core::default_plan(), .pad_s = 2.5}));
  }
}

// The first byte chooses what the rest is.
void read(std::uint8_t choice, std::string input) {
  if (choice % 2 != 0) {
    read_csv(std::move(input));
    return;
  }
  for (const files::Source& source : parse(input)) {
    require(std::isfinite(source.factor) && source.factor != 0.0);
  }
}

}  // namespace

std::vector<std::string> seeds() {
  return {std::string{'\0'} + "time=ts:s,axial=-Ay:m/s2,roll_rate=Gy:deg/s,height=0.3048*alt:m",
          std::string{'\0'}.append(files::loggers().front().columns), std::string{'\1'} + csv("t,a,alt\n", "", ",12\n"),
          std::string{'\1'} + csv("#version,serial,flight,time,acceleration\n", "8,1234,1,", "\n")};
}

}  // namespace fantail::fuzz

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer calls it so
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return fantail::fuzz::read_chosen(data, size, fantail::fuzz::read);
}
