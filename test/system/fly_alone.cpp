// SPDX-License-Identifier: MIT
// Usage: fly_alone SCENARIO FOLDER [section.key=value]...
// What `fantail fly` does and nothing else of the program, so that other compilers need not build the rest of it.
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "fly/fly_scenario.hpp"
#include "input/document.hpp"
#include "input/scenario_file.hpp"
#include "report/results.hpp"

int main(int argc, char** argv) {
  const std::vector<std::string> words{argv + 1, argv + argc};
  if (words.size() < 2) {
    return 64;
  }
  try {
    std::vector<fantail::input::Override> changes;
    for (std::size_t i = 2; i < words.size(); ++i) {
      changes.push_back(fantail::input::parse_override(words[i]));
    }
    const fantail::sim::Scenario scenario = fantail::input::load_scenario(words[0], changes);
    const fantail::flight::Flight flight = fantail::fly::fly_scenario(scenario, {}, {}, fantail::fly::Log::kept);
    fantail::report::write_results(flight, fantail::report::results(flight), words[1]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "fly_alone: %s\n", error.what());
    return 70;
  }
  return 0;
}
