// SPDX-License-Identifier: MIT
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "airframe/summary.hpp"
#include "fantail/deliver.hpp"
#include "fantail/offers.hpp"
#include "fantail/run.hpp"
#include "fantail/scenario_options.hpp"
#include "fantail/standard_streams.hpp"
#include "input/document.hpp"
#include "input/shipped.hpp"
#include "input/vehicle_file.hpp"
#include "text/error.hpp"

namespace fantail::tool {
namespace {

struct AirframeOptions {
  std::string vehicle;
  std::vector<std::string> changes;
  std::string out;
  bool json = false;
};

void show_airframe(const AirframeOptions& options) {
  const std::string file = input::find_input(input::Shipped::vehicle, options.vehicle);
  input::Document document = input::Document::load(file);
  for (const std::string& change : options.changes) {
    document.apply(input::parse_override(change));
  }
  const sim::Vehicle vehicle = input::read_vehicle(document);
  if (!vehicle.geometry) {
    throw text::Error{text::ErrorKind::bad_configuration,
                      file +
                          ": has no section [shape], which describes the rocket's shape (its keys: man "
                          "fantail.toml, or docs/your_rocket.md in the sources)"};
  }
  deliver(airframe::answer(vehicle, airframe::summarize(vehicle), made_with({file}, {}, options.changes)),
          {.folder = options.out.empty() ? std::filesystem::path{"out/airframe"} /
                                               variant_name(input::name_of_file(file), options.changes)
                                         : std::filesystem::path{options.out},
           .name = "airframe",
           .inputs = {file},
           .json = options.json,
           .when_written = [&] {
             for (const std::string& warning : vehicle.warnings) {
               say("fantail: warning: " + warning + "\n");
             }
           }});
}

void fill(const Verb& verb) {
  auto options = std::make_shared<AirframeOptions>();
  verb.option("VEHICLE", options->vehicle, "A vehicle with the section [shape]: a shipped name or a path")
      .offers(shipped(input::Shipped::vehicle))
      .required();
  verb.option("--set", options->changes, "section.key=value: change one value of the vehicle")
      .offers(changes_of_vehicle)
      .one_word_each_time();
  verb.option("--out", options->out,
              "Folder for airframe.html and airframe.json [out/airframe/VEHICLE, with the changes in the name]")
      .offers(folders);
  verb.flag("--json", options->json, "Print airframe.json instead of the text");
  verb.examples(
      "Examples:\n"
      "  fantail airframe tasha3_launch2                           stability, damping and canard torque from its "
      "shape\n"
      "  fantail airframe my_rocket.toml --set fins.span_m=0.07    the same with larger fins\n"
      "  fantail airframe my_rocket.toml --json | jq .stability    for a script");
  verb.action([options] { show_airframe(*options); });
}

const VerbCode code{"airframe", fill};

}  // namespace
}  // namespace fantail::tool
