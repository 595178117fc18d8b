// SPDX-License-Identifier: MIT
#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/core.h>

#include "fantail/command_line.hpp"
#include "fantail/deliver.hpp"
#include "fantail/flown_vehicle.hpp"
#include "fantail/offers.hpp"
#include "fantail/progress.hpp"
#include "fantail/tunnel_options.hpp"
#include "input/document.hpp"
#include "input/shipped.hpp"
#include "input/vehicle_file.hpp"
#include "logs/flight_file.hpp"
#include "text/error.hpp"
#include "text/number.hpp"
#include "tunnel/stability.hpp"
#include "tunnel/statistics.hpp"
#include "tunnel/swing.hpp"
#include "tunnel/tunnel_log.hpp"

namespace fantail::tool {
namespace {

constexpr const char* stability_folder = "out/tunnel/stability";

struct StabilityOptions {
  std::vector<std::string> logs;
  std::optional<std::string> vehicle;
  std::optional<double> inertia_kg_m2;
  std::optional<double> slope_per_rad;
  std::optional<double> density_kg_m3;
  std::string speeds;
  std::string swings;
  TunnelOutput output;
};

/// Empty: not a list of numbers above zero.
std::optional<std::vector<double>> parse_speeds(std::string_view text) {
  std::vector<double> speeds;
  while (!text.empty()) {
    const std::string_view cell = text.substr(0, text.find(','));
    double speed = 0.0;
    const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), speed);
    if (error != std::errc{} || end != cell.data() + cell.size() || !(speed > 0.0) || speed > 1000.0) {
      return std::nullopt;
    }
    speeds.push_back(speed);
    text.remove_prefix(std::min(text.size(), cell.size() + 1));
  }
  return speeds.empty() ? std::nullopt : std::optional{speeds};
}

void take_airframe(const StabilityOptions& options, tunnel::StabilityHeading& heading) {
  const FlownVehicle flown = flown_vehicle(options.logs.front(), options.vehicle);
  if (!flown.document) {
    if (!std::filesystem::exists(options.logs.front())) {
      throw text::Error{text::ErrorKind::no_such_input, options.logs.front() + ": no such file"};
    }
    throw UsageError{flown.why_unknown};
  }
  const sim::Vehicle vehicle = input::read_vehicle(*flown.document);
  if (!vehicle.airframe) {
    throw text::Error{text::ErrorKind::bad_configuration,
                      fmt::format("vehicle {} has no section [airframe], which gives inertia and normal force",
                                  flown.document->file())};
  }
  const sim::Airframe& a = *vehicle.airframe;
  heading.airframe_source = vehicle.name;
  heading.airframe = {.transverse_inertia_kg_m2 = options.inertia_kg_m2.value_or(a.at_liftoff.transverse_inertia_kg_m2),
                      .normal_force_slope_per_rad = options.slope_per_rad.value_or(a.normal_force_slope_per_rad),
                      .cross_section_m2 = a.cross_section_m2(),
                      .diameter_m = a.diameter_m,
                      .mass_kg = vehicle.mass_kg,
                      .body_lift_area_m2 = a.body_lift_area_m2,
                      .body_lift_arm_m = a.at_liftoff.centre_of_gravity_m - a.body_lift_position_m};
}

/// Until the fan gets a new set point, or the air another speed than it had in the first seconds.
tunnel::SwingStretch while_steady(const tunnel::TunnelLog& wind, tunnel::SwingStretch stretch) {
  constexpr double first_s = 4.0;
  constexpr double tolerance = 0.03;
  std::optional<std::size_t> begin;
  double sum = 0.0;
  double count = 0.0;
  for (std::size_t i = 0; i < wind.time_s.size() && wind.time_s[i] <= stretch.end_s; ++i) {
    if (wind.time_s[i] < stretch.begin_s) {
      continue;
    }
    begin = begin.value_or(i);
    const bool other_fan = !wind.fan_rpm.empty() && wind.fan_rpm[i] != wind.fan_rpm[*begin];
    const double speed_m_s = wind.wind_speed_m_s[i];
    const bool is_first = wind.time_s[i] < stretch.begin_s + first_s || count == 0.0;
    if (other_fan || (!is_first && std::abs(speed_m_s - sum / count) > tolerance * sum / count)) {
      stretch.end_s = wind.time_s[i > *begin ? i - 1 : i];
      return stretch;
    }
    if (is_first) {
      sum += speed_m_s;
      count += 1.0;
    }
  }
  return stretch;
}

double mean_speed(const tunnel::TunnelLog& wind, const tunnel::SwingStretch& stretch) {
  std::vector<double> inside;
  for (std::size_t i = 0; i < wind.time_s.size(); ++i) {
    if (wind.time_s[i] >= stretch.begin_s && wind.time_s[i] <= stretch.end_s) {
      inside.push_back(wind.wind_speed_m_s[i]);
    }
  }
  constexpr double nearest_s = 5.0;  // a stretch between two readings
  for (std::size_t i = 0; inside.empty() && i < wind.time_s.size(); ++i) {
    if (std::abs(wind.time_s[i] - stretch.begin_s) < nearest_s) {
      inside.push_back(wind.wind_speed_m_s[i]);
    }
  }
  if (inside.empty()) {
    throw text::Error{text::ErrorKind::bad_data,
                      fmt::format("{}: no reading between {:.1f} and {:.1f} s, when the rocket swung: give --speeds",
                                  wind.name, stretch.begin_s, stretch.end_s)};
  }
  return tunnel::mean(inside);
}

std::vector<tunnel::SwingStretch> named_swings(const std::string& swings) {
  std::vector<tunnel::SwingStretch> all;
  const std::vector<tunnel::NamedStretch> named = tunnel::parse_stretches(swings).value();
  for (const tunnel::NamedStretch& stretch : named) {
    if (!stretch.end_s) {
      throw UsageError{"--swings needs begin and end of each swing, as in 4:20,49:60"};
    }
    all.push_back({.begin_s = stretch.begin_s, .end_s = *stretch.end_s});
  }
  return all;
}

std::vector<tunnel::StabilitySwing> swings_of(const StabilityOptions& options, tunnel::StabilityHeading& heading,
                                              std::vector<std::string>& remarks) {
  constexpr double bin_s = 0.01;
  constexpr double shortest_steady_s = 5.0;  // five readings is what it takes
  std::vector<tunnel::StabilitySwing> swings;
  Chapters chapters{"tunnel stability", options.logs.size(), "fitting the swings of " + options.logs.front()};
  for (const std::string& path : options.logs) {
    if (!heading.logs.empty()) {
      chapters.next("fitting the swings of " + path);
    }
    const tunnel::SwingLog log = tunnel::averaged(tunnel::read_swing_log(path), bin_s);
    heading.logs.push_back(log.name);
    heading.signal = log.is_rate ? "pitch rate" : "pitch angle";
    remarks.insert(remarks.end(), log.remarks.begin(), log.remarks.end());
    const auto beside = options.speeds.empty() ? tunnel::tunnel_log_beside(path) : std::nullopt;
    if (options.speeds.empty() && !beside) {
      throw UsageError{path + ": no tunnel.csv beside it gives the wind speed: give --speeds"};
    }
    const auto wind = beside ? std::optional{tunnel::read_tunnel_log(*beside, {})} : std::nullopt;
    const tunnel::SteadySegments steady =
        wind ? tunnel::find_steady(*wind, {.shortest_s = shortest_steady_s}) : tunnel::SteadySegments{};
    for (tunnel::SwingStretch stretch :
         options.swings.empty() ? tunnel::find_swings(log) : named_swings(options.swings)) {
      stretch = wind ? while_steady(*wind, stretch) : stretch;
      const double speed_m_s = wind ? mean_speed(*wind, stretch) : 0.0;
      swings.push_back(
          {.speed_m_s = speed_m_s,
           .result = tunnel::fit_swing(log, stretch),
           .air = wind ? tunnel::unsteadiness(*wind, steady, stretch.begin_s, stretch.end_s) : std::nullopt});
    }
  }
  if (!options.speeds.empty()) {
    const std::vector<double> speeds = parse_speeds(options.speeds).value();
    if (speeds.size() != swings.size()) {
      std::string found;
      for (const tunnel::StabilitySwing& swing : swings) {
        found += fmt::format(" {:.1f}:{:.1f}", swing.result.stretch.begin_s, swing.result.stretch.end_s);
      }
      throw UsageError{fmt::format(
          "--speeds has {}, and {} found (in seconds:{}): give one for each swing, "
          "or name the swings with --swings",
          text::counted(speeds.size(), "number"), text::counted(swings.size(), "swing was", "swings were"), found)};
    }
    for (std::size_t i = 0; i < swings.size(); ++i) {
      swings[i].speed_m_s = speeds[i];
    }
  }
  return swings;
}

void stability(const StabilityOptions& options) {
  if (options.logs.size() > 1 && !options.swings.empty()) {
    throw UsageError{"--swings uses the clock of one log: give the logs one at a time, or leave it out"};
  }
  tunnel::StabilityHeading heading{.density_kg_m3 = options.density_kg_m3.value_or(1.2)};
  take_airframe(options, heading);
  std::vector<std::string> remarks;
  std::vector<tunnel::StabilitySwing> swings = swings_of(options, heading, remarks);
  tunnel::Stability found = tunnel::examine_stability(std::move(swings), heading.airframe, heading.density_kg_m3);
  found.remarks.insert(found.remarks.begin(), remarks.begin(), remarks.end());
  const std::vector<std::filesystem::path> made_from{options.logs.begin(), options.logs.end()};
  Delivery to = delivery(options.output, stability_folder, "stability", made_from, {"page", "swings"});
  to.yes_is_required = true;
  deliver(tunnel::stability_answer(heading, found, made_with(made_from)), to);
}

}  // namespace

void add_tunnel_stability(const Verb& tunnel) {
  auto verb = tunnel.verb("stability", "Static margin and stability of a rocket that swings on pins");
  auto options = std::make_shared<StabilityOptions>();
  verb.option("LOG", options->logs,
              "Flight logs (.ftl) or folders with one, with the swings in the gyro data; or CSV files with time_s "
              "and pitch_rate_deg_s or pitch_deg")
      .offers(files)
      .required();
  verb.option("--speeds", options->speeds, "Air speed of each swing, in their order [the tunnel.csv beside the log]")
      .check([](const std::string& text) {
        return parse_speeds(text) ? std::string{} : '"' + text + "\" is not a list of speeds in m/s, as in 15,20,30";
      })
      .value_name("M/S,...");
  verb.option("--swings", options->swings, "Times of free swings, instead of finding them: begin:end,...")
      .check([](const std::string& text) {
        return tunnel::parse_stretches(text)
                   ? std::string{}
                   : '"' + text + "\" is not a list of increasing times in seconds, as in 4:20,49:60";
      })
      .value_name("T:T,...");
  verb.option(
          "--vehicle", options->vehicle,
          "Vehicle with mass and [airframe]: a shipped name or a path [the shipped one in the flight's summary.json]")
      .offers(shipped(input::Shipped::vehicle))
      .value_name("NAME|FILE");
  verb.option("--inertia", options->inertia_kg_m2, "Transverse moment of inertia, instead of the vehicle's")
      .check(within(1e-6, 1e6))
      .value_name("KG_M2");
  verb.option("--slope", options->slope_per_rad, "Slope of the normal force per radian, instead of the vehicle's")
      .check(within(0.01, 1e4))
      .value_name("SLOPE");
  verb.option("--density", options->density_kg_m3, "Air density [1.2]").check(within(0.01, 5.0)).value_name("KG/M3");
  add_tunnel_output(verb, options->output, stability_folder);
  verb.examples(
      "Examples:\n"
      "  fantail tunnel stability out/tunnel_stability                      the session of fantail fly "
      "tunnel_stability\n"
      "  fantail tunnel stability swings.csv --speeds 15,20,30 --vehicle my_rocket.toml\n"
      "                                                                     another logger's file\n"
      "  fantail tunnel stability out/tunnel_stability --json               for a script; exit code 1 unless stable");
  verb.action([options] { stability(*options); });
}

}  // namespace fantail::tool
