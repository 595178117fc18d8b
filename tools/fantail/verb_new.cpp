// SPDX-License-Identifier: MIT
#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

#include <fmt/format.h>

#include "airframe/new_rocket.hpp"
#include "airframe/openrocket/read.hpp"
#include "airframe/summary.hpp"
#include "campaign/flown_run.hpp"
#include "fantail/new_from_design.hpp"
#include "fantail/new_from_vehicle.hpp"
#include "fantail/offers.hpp"
#include "fantail/run.hpp"
#include "fantail/terminal.hpp"
#include "input/document.hpp"
#include "input/rasp_file.hpp"
#include "input/scenario_file.hpp"
#include "input/shipped.hpp"
#include "input/vehicle_file.hpp"
#include "report/verdict.hpp"
#include "text/input_file.hpp"
#include "text/number.hpp"
#include "text/output_folder.hpp"
#include "text/quoting.hpp"

namespace fantail::tool {
namespace {

struct NewOptions {
  std::string name;
  std::string from;
  std::optional<std::string> motor;
  std::string canards;
};

/// A motor as the new vehicle can name it: a shipped name stays one, another file is copied beside the vehicle.
struct NamedMotor {
  std::string name;
  std::filesystem::path file;
  std::optional<std::string> designation{};  ///< one of several in the file
  bool is_shipped = false;

  /// As a file in another folder may name it.
  [[nodiscard]] std::string absolute() const {
    return std::filesystem::absolute(file).string() + (designation ? '#' + *designation : "");
  }

  [[nodiscard]] std::optional<text::NamedFile> copy() const {
    if (is_shipped) {
      return std::nullopt;
    }
    return text::NamedFile{.name = file.filename().string(),
                           .content = text::read_input(file, text::InputKind::document)};
  }
};

NamedMotor motor_called(const std::string& named, const std::filesystem::path& file) {
  const std::size_t mark = named.rfind('#');
  const std::vector<std::string> shipped = input::shipped_names(input::Shipped::motor);
  const bool is_shipped = std::ranges::find(shipped, named) != shipped.end();
  const std::string designation = mark == std::string::npos ? "" : named.substr(mark);
  return {.name = is_shipped ? named : file.filename().string() + designation,
          .file = file,
          .designation = designation.empty() ? std::nullopt : std::optional{designation.substr(1)},
          .is_shipped = is_shipped};
}

std::string file_part(const std::string& named) { return named.substr(0, named.rfind('#')); }

NamedMotor asked_motor(const NewOptions& options) {
  return motor_called(*options.motor, input::find_input(input::Shipped::motor, file_part(*options.motor)));
}

NamedMotor motor_of(const NewOptions& options, const input::Document& document) {
  if (options.motor) {
    return asked_motor(options);
  }
  input::Section motor{document, "motor"};
  const std::string named = motor.text("file");
  return motor_called(named, input::find_named_input(input::Shipped::motor, document, motor, "file", file_part(named)));
}

airframe::NewRocket from_vehicle(const NewOptions& options, const std::string& file) {
  input::Document document = input::Document::load(file);
  const bool same_motor = !options.motor || !document.root()["motor"]["file"];
  add_computed_keys(document, options.motor ? std::optional{asked_motor(options).absolute()} : std::nullopt);
  airframe::NewRocket rocket{.name = {},
                             .vehicle = input::read_vehicle(document),
                             .motor_file = {},
                             .source = std::filesystem::path{file}.filename().string(),
                             .assumed = {}};
  if (!rocket.vehicle.geometry) {
    throw text::Error{text::ErrorKind::bad_configuration,
                      file +
                          ": has no section [shape], which describes the rocket's shape (its keys: man "
                          "fantail.toml, or docs/your_rocket.md in the sources)"};
  }
  const NamedMotor motor = motor_of(options, document);
  const double own_propellant_kg = rocket.vehicle.motor.propellant_kg();
  rocket.motor_file = motor.name;
  rocket.motor = motor.copy();
  keep_equipment(document, same_motor, rocket);
  if (!same_motor) {
    rocket.vehicle.motor =
        input::motors(input::load_rasp(motor.file, motor.designation).curve, rocket.vehicle.motor_count, 1.0);
    rocket.vehicle.mass_kg += rocket.vehicle.motor.propellant_kg() - own_propellant_kg;
    if (auto& design = rocket.vehicle.geometry->design) {
      design = sim::Geometry::Design{.file = design->file, .left_out = design->left_out};
    }
    rocket.assumed.push_back(
        fmt::format("Mass, balance and drag area: those of {}, with this motor's propellant instead of its own. A "
                    "different mass of the motor case is not counted.",
                    rocket.source));
  } else {
    rocket.assumed.push_back(
        fmt::format("Mass{} and drag area: those of {}.", options.motor ? "" : ", motor", rocket.source));
  }
  return rocket;
}

airframe::NewRocket from_design(const NewOptions& options) {
  const airframe::openrocket::Design design = airframe::openrocket::read_design(options.from, options.canards);
  if (!options.motor) {
    std::string motors;
    for (const auto& motor : design.motor ? design.motor->motors : std::vector<airframe::openrocket::NamedMotor>{}) {
      motors += (motors.empty() ? "" : ", ") + motor.designation;
    }
    throw UsageError{
        fmt::format("a design has no thrust curve (motors named in {}: {}): give --motor FILE.eng, for example from "
                    "thrustcurve.org",
                    options.from, motors.empty() ? "none" : motors)};
  }
  const NamedMotor motor = asked_motor(options);
  airframe::NewRocket rocket = rocket_of_design(design, std::filesystem::path{options.from}.filename().string(),
                                                input::load_rasp(motor.file, motor.designation));
  rocket.motor_file = motor.name;
  rocket.motor = motor.copy();
  for (const std::string& left_out : design.not_used) {
    show("Not used: {}\n", left_out);
  }
  return rocket;
}

[[noreturn]] void refuse_taken(const std::string& name) {
  throw UsageError{name + " already exists, and nothing is replaced: use another name"};
}

/// Of several that make the same name at once, one gets the folder.
void take(const std::filesystem::path& folder) {
  std::error_code failed;
  if (folder.has_parent_path()) {
    std::filesystem::create_directories(folder.parent_path(), failed);
  }
  if (!failed && !std::filesystem::create_directory(folder, failed) && !failed) {
    refuse_taken(folder.string());
  }
  if (failed) {
    throw text::OutputError{fmt::format("{}: {}", folder.string(), failed.message())};
  }
}

/// A folder that is only there if all of it can be flown. What the vehicle is refused for lies in what it was made
/// from: parts that do not weigh what the rocket does come first, because the balance follows from them.
sim::Scenario write(const std::filesystem::path& folder, const std::vector<text::NamedFile>& files,
                    const airframe::NewRocket& rocket, const std::string& source) {
  take(folder);
  try {
    text::OutputFolder{folder}.write(files);
    return input::load_scenario((folder / "scenario.toml").string(), {});
  } catch (const text::OutputError&) {
    std::filesystem::remove_all(folder);
    throw;
  } catch (const text::Error& error) {
    std::filesystem::remove_all(folder);
    std::string complaint = error.what();
    if (complaint.starts_with((folder / "vehicle.toml").string())) {
      complaint.erase(0, std::min(complaint.find(": "), complaint.size() - 2) + 2);
    }
    const std::string off = airframe::parts_off_mass(airframe::model::build_up(rocket.vehicle), rocket.vehicle);
    throw text::Error{error.kind(), fmt::format("{}: cannot be made into a vehicle: {}{}{}", source, off,
                                                off.empty() ? "" : ", and so ", complaint)};
  }
}

/// The verdict on a first flight of the new rocket.
std::string first_flight(const sim::Scenario& scenario) {
  const campaign::JudgedFlight flown = campaign::fly_and_judge(scenario);
  const bool is_too_fast = flight::is_beyond(flight::ModelEnd::mach, flown.flight.extremes);
  const std::string word = fmt::format("{}: ", report::display_name(flown.verdict.outcome));
  return fmt::format("First flight: {}{}{}\n", flown.verdict.text.starts_with(word) ? "" : word, flown.verdict.text,
                     is_too_fast ? " A weaker motor or more mass keeps it slower." : "");
}

/// "mine", "../rockets/mine", and with a slash behind it, as shells complete it.
std::filesystem::path new_folder(const std::string& name) {
  const std::filesystem::path named{name};
  std::filesystem::path folder = named.has_filename() ? named : named.parent_path();
  if (!folder.has_filename()) {
    throw UsageError{fmt::format("\"{}\" names no new folder", name)};
  }
  if (std::filesystem::exists(folder)) {
    refuse_taken(name);
  }
  return folder;
}

void make(const NewOptions& options) {
  const std::filesystem::path folder = new_folder(options.name);
  const bool is_design = is_openrocket(options.from);
  if (!is_design && !options.canards.empty()) {
    throw UsageError{"--canards chooses among the fins of an OpenRocket file; a vehicle says it by [canard_fins]"};
  }
  const std::string source =
      is_design ? options.from : input::find_input(input::Shipped::vehicle, options.from).string();
  airframe::NewRocket rocket = is_design ? from_design(options) : from_vehicle(options, source);
  rocket.name = folder.filename().string();
  const airframe::NewFiles files = airframe::files_of(rocket);
  const sim::Scenario scenario = write(folder, files.files, rocket, options.from);
  const sim::Vehicle& made = scenario.vehicle;
  const airframe::Summary summary = airframe::summarize(made);
  show("{}\n", summary.sentence);
  for (const std::string& remark : summary.remarks) {
    show("{}\n", remark);
  }
  if (!made.geometry->canards) {
    show(
        "It has no canards: nothing controls its roll until the vehicle has a section [canard_fins] and is made "
        "again.\n");
  }
  for (const std::string& sentence : files.decides) {
    show("{}\n", sentence);
  }
  show("{}{}", files.gains, files.gains.empty() ? "" : "\n");
  show("{}", first_flight(scenario));
  const auto changed = is_design ? std::vector<std::string>{}
                                 : changes(input::Document::load(source), rocket.vehicle,
                                           input::Document::load((folder / "vehicle.toml").string()), made);
  for (const std::string& change : changed) {
    show("{}\n", change);
  }
  for (const std::string& assumed : made.assumed) {
    show("Assumed: {}\n", assumed);
  }
  show("\n");
  for (const text::NamedFile& file : files.files) {
    show("  made  {}\n", (folder / file.name).string());
  }
  const std::string scenario_file = text::shell_word((folder / "scenario.toml").string());
  show("\nNext: fantail airframe {}\n      fantail fly {}\n", text::shell_word((folder / "vehicle.toml").string()),
       scenario_file);
  show("      fantail campaign {}\n", scenario_file);
  show("      fantail rules irec {} (most ranges ask for [dormancy] and run.abort_input in plan.toml)\n",
       scenario_file);
}

void fill(const Verb& verb) {
  auto options = std::make_shared<NewOptions>();
  verb.option("NAME", options->name,
              "New folder for the files, such as my_rocket or ../my_rocket; its last part is the rocket's name")
      .required();
  verb.option("--from", options->from,
              "Source of its shape: a vehicle with the section [shape], or an OpenRocket file (.ork)")
      .offers(shipped(input::Shipped::vehicle))
      .required()
      .value_name("NAME|FILE");
  verb.option("--motor", options->motor,
              "Its motor, a RASP file [that of the vehicle; required for an OpenRocket file]")
      .offers(shipped(input::Shipped::motor))
      .value_name("NAME|FILE");
  verb.option(
          "--canards", options->canards,
          "The fins of an OpenRocket file that are the canards, by their name [four ahead of the fins, and smaller]")
      .value_name("NAME");
  verb.examples(
      "Examples:\n"
      "  fantail new my_rocket --from tasha3_launch2          vehicle, plan and scenario in my_rocket/, to be edited\n"
      "  fantail new my_rocket --from my.ork --motor my.eng   from a design of OpenRocket\n"
      "  fantail new my_rocket --from shape.toml              from a vehicle file of your own, which needs no "
      "[aerodynamics]");
  verb.action([options] { make(*options); });
}

const VerbCode code{"new", fill};

}  // namespace
}  // namespace fantail::tool
