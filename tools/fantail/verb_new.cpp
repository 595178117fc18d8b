// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cctype>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <fmt/core.h>

#include "airframe/new_rocket.hpp"
#include "airframe/report.hpp"
#include "fantail/run.hpp"
#include "input/document.hpp"
#include "input/shipped.hpp"
#include "input/vehicle_file.hpp"
#include "text/output_folder.hpp"

namespace fantail::tool {
namespace {

struct NewOptions {
  std::string name;
  std::string from;
};

/// As the new vehicle can name it: a shipped name stays one, of a path the whole.
std::string motor_of(const input::Document& document) {
  input::Section motor{document, "motor"};
  const std::string named = motor.text("file");
  const std::size_t mark = named.rfind('#');
  const std::filesystem::path file =
      input::find_named_input(input::Shipped::motor, document, motor, "file", named.substr(0, mark));
  const std::vector<std::string> shipped = input::shipped_names(input::Shipped::motor);
  return std::ranges::find(shipped, named) != shipped.end()
             ? named
             : std::filesystem::absolute(file).string() + (mark == std::string::npos ? "" : named.substr(mark));
}

airframe::NewRocket rocket_of(const NewOptions& options) {
  const std::string file = input::find_input(input::Shipped::vehicle, options.from);
  const input::Document document = input::Document::load(file);
  airframe::NewRocket rocket{.name = std::filesystem::path{options.name}.filename().string(),
                             .vehicle = input::read_vehicle(document),
                             .motor_file = motor_of(document),
                             .source = std::filesystem::path{file}.filename().string(),
                             .assumed = {}};
  if (!rocket.vehicle.geometry) {
    throw text::Error{text::ErrorKind::bad_configuration,
                      file + ": has no section [shape], which says what the rocket looks like (docs/your_rocket.md)"};
  }
  rocket.assumed.push_back(fmt::format("Mass, drag area and motor: those of {}.", rocket.source));
  return rocket;
}

void make(const NewOptions& options) {
  const std::filesystem::path folder{options.name};
  if (std::filesystem::exists(folder)) {
    throw UsageError{fmt::format("{} is there already: nothing of it is replaced; use another name", options.name)};
  }
  const airframe::NewRocket rocket = rocket_of(options);
  const std::vector<text::NamedFile> files = airframe::files_of(rocket);
  text::OutputFolder{folder}.write(files);
  const sim::Vehicle made = input::read_vehicle(input::Document::load((folder / "vehicle.toml").string()));
  fmt::print("{}\n", airframe::summarize(made).sentence);
  for (const std::string& assumed : made.assumed) {
    fmt::print("Assumed: {}\n", assumed);
  }
  fmt::print("\n");
  for (const text::NamedFile& file : files) {
    fmt::print("  made  {}\n", (folder / file.name).string());
  }
  fmt::print("\nNext: fantail airframe {0}/vehicle.toml, fantail fly {0}/scenario.toml\n", folder.string());
}

void fill(const Verb& verb) {
  auto options = std::make_shared<NewOptions>();
  verb.option("NAME", options->name, "Name of the rocket, and of the folder that is made").required();
  verb.option("--from", options->from, "What its shape is read from: a vehicle with the section [shape]")
      .required()
      .value_name("NAME|FILE");
  verb.examples(
      "Examples:\n"
      "  fantail new my_rocket --from tasha3_launch2    vehicle, plan and scenario in my_rocket/, to be edited\n"
      "  fantail new my_rocket --from shape.toml        from a vehicle file of your own\n"
      "  fantail fly my_rocket/scenario.toml            its first flight");
  verb.action([options] { make(*options); });
}

}  // namespace
}  // namespace fantail::tool

int main(int argc, char** argv) { return fantail::tool::run("new", fantail::tool::fill, argc, argv); }
