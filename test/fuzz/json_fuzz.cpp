// SPDX-License-Identifier: MIT
// Any bytes as JSON, as the summary of a flight, as a roll model or as whose campaign a folder is: read, or refused
// with a sentence.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "chosen_input.hpp"
#include "flight/flight.hpp"
#include "identify/result/agreement.hpp"
#include "input_file.hpp"
#include "json/value.hpp"
#include "report/results.hpp"
#include "runs/folder.hpp"

namespace fantail::fuzz {
namespace {

std::filesystem::path file(const std::string& bytes) { return input_file(bytes, "x.json"); }

void parse(const std::string& bytes) {
  try {
    const json::Value value = json::parse(bytes);
    const std::string text = value.dump();
    require(json::parse(text) == json::parse(value.pretty()) && json::parse(text).dump() == text);
  } catch (const json::Error& error) {
    require_sentence(error.what());
  }
}

void summary(const std::string& bytes) {
  flight::Flight flight;
  report::add_summary(flight, file(bytes));
  require(std::ranges::all_of(flight.notes, [](const std::string& note) { return note.empty() || is_sentence(note); }));
  require(!flight.airframe || (flight.airframe->roll_inertia_kg_m2 > 0.0 && flight.airframe->reference_area_m2 > 0.0));
  (void)report::summary_of_control(file(bytes));
}

// The first byte chooses what the rest is.
void read(std::uint8_t choice, const std::string& bytes) {
  switch (choice % 4) {
    case 0: parse(bytes); return;
    case 1: summary(bytes); return;
    case 2: (void)identify::result::read_model(file(bytes)); return;
    default: try { (void)runs::parse_identity(bytes);
      } catch (const json::Error& error) {
        require_sentence(error.what());
      }
  }
}

}  // namespace

std::vector<std::string> seeds() {
  return {
      std::string(1, '\0') + R"({"a":[1,-2.5e3,true,null,"\u00e9\ud83d\ude80"],"b":{"c":18446744073709551615}})",
      std::string{"\1"} +
          R"({"scenario":"x","vehicle":"y","seed":3,"events":{"liftoff_s":0.1,"apogee_s":9.5},"roll_inertia_kg_m2":0.01,)"
          R"("reference_area_m2":0.02,"phase_changes":[{"phase":"controlling","time_s":1.5,"reason":"guide_clear"}],)"
          R"("canard_verdicts":[{"verdict":"stalled","canard":2,"time_s":3}],"unmeasured":{"spin_from_s":1},)"
          R"("outages":[{"from_s":1,"to_s":2,"cause":"watchdog","resumed":true}],"wind":{"speed_m_s":4,"from_deg":10},)"
          R"("loop_margins":[{"speed_m_s":90,"phase_margin_deg":50,"gain_margin":3}],"changes":["a"],"notes":["b"]})",
      std::string{"\2"} +
          R"({"alpha_m2":2e-4,"beta_m":0.05,"reference_area_m2":0.02,"alpha_sd_m2":1e-6,"beta_sd_m":1e-3,)"
          R"("alpha_beta_correlation":0.5,"degrees_of_freedom":100})",
      std::string{"\3"} + R"({"scenario":"a","plan":"b","vehicle":"c","motor":"","runs":"10","seed":"1"})"};
}

}  // namespace fantail::fuzz

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer calls it so
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return fantail::fuzz::read_chosen(data, size, fantail::fuzz::read);
}
