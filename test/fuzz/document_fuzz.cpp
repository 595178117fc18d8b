// SPDX-License-Identifier: MIT
// Any bytes as a plan, a vehicle, a scenario, a thrust curve or an OpenRocket design: read, or refused with a sentence.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include "airframe/openrocket/read.hpp"
#include "chosen_input.hpp"
#include "core/flight_plan_fields.hpp"
#include "input/document.hpp"
#include "input/plan_file.hpp"
#include "input/rasp_file.hpp"
#include "input/scenario_file.hpp"
#include "input/shipped.hpp"
#include "input/vehicle_file.hpp"
#include "input_file.hpp"

namespace fantail::fuzz {
namespace {

namespace fs = std::filesystem;

// The first byte chooses what the rest is.
void read(std::uint8_t choice, std::string_view bytes) {
  switch (choice % 5) {
    case 0:
      require(!core::validate(input::read_plan(input::Document::load(input_file(bytes, "x.toml").string()))));
      return;
    case 1:
      require(input::read_vehicle(input::Document::load(input_file(bytes, "x.toml").string())).mass_kg > 0.0);
      return;
    case 2: require(!core::validate(input::load_scenario(input_file(bytes, "x.toml").string(), {}).plan)); return;
    case 3: require(input::load_rasp(input_file(bytes, "x.eng")).curve.impulse_n_s() > 0.0); return;
    default: {
      const auto design = airframe::openrocket::read_design(input_file(bytes, "x.ork"));
      require(std::ranges::all_of(design.not_used, is_sentence) && std::ranges::all_of(design.assumed, is_sentence));
    }
  }
}

std::string with_kind(char kind, const fs::path& path) {
  std::ifstream stream{path, std::ios::binary};
  return kind + std::string{std::istreambuf_iterator<char>{stream}, {}};
}

}  // namespace

std::vector<std::string> seeds() {
  return {
      with_kind('\0', input::find_input(input::Shipped::plan, "tasha3_launch2")),
      with_kind('\1', input::find_input(input::Shipped::vehicle, "tasha3_launch2")),
      with_kind('\2', input::find_input(input::Shipped::scenario, "tasha3_launch2")),
      "\3; a motor\nI150 38 200 0 0.226 0.5 X\n0.05 160\n2.5 130\n3.2 0\n",
      std::string{"\4"} +
          "<openrocket version=\"1.9\"><rocket><name>x</name><subcomponents><stage><name>s</name><subcomponents>"
          "<nosecone><name>n</name><length>0.24</length><thickness>0.002</thickness><shape>ogive</shape>"
          "<aftradius>0.04</aftradius></nosecone><bodytube><name>b</name><length>1</length><thickness>0.002</thickness>"
          "<radius>0.04</radius></bodytube></subcomponents></stage></subcomponents></rocket></openrocket>"};
}

}  // namespace fantail::fuzz

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer calls it so
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return fantail::fuzz::read_chosen(data, size, fantail::fuzz::read);
}
