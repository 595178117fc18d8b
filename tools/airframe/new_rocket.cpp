// SPDX-License-Identifier: MIT
#include "airframe/new_rocket.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <numbers>
#include <span>
#include <string_view>

#include <fmt/format.h>

#include "airframe/model/build_up.hpp"
#include "core/flight_plan_fields.hpp"
#include "text/degrees.hpp"
#include "text/number.hpp"
#include "text/quoting.hpp"

namespace fantail::airframe {
namespace {

using sim::Geometry;

constexpr double stall_deg = 13.0;
constexpr std::array nose_names{"cone", "ogive", "ellipsoid", "parabola", "haack"};

std::string sentences(const char* key, const std::vector<std::string>& all) {
  std::string out = fmt::format("{} = [\n", key);
  for (const std::string& sentence : all) {
    out += "  " + text::toml_text(sentence) + ",\n";
  }
  return out + "]\n";
}

/// What was read; sums of lengths and turned units end in digits that nobody wrote.
std::string exact(double value) { return fmt::format("{:.12g}", value); }

std::string fin_set(const char* section, const Geometry::FinSet& set) {
  std::string out = fmt::format("\n[{}]\n", section);
  const auto add = [&](const char* key, double value) { out += fmt::format("{} = {}\n", key, exact(value)); };
  add("position_m", set.position_m);
  add("root_chord_m", set.root_chord_m);
  add("tip_chord_m", set.tip_chord_m);
  add("span_m", set.span_m);
  add("sweep_m", set.sweep_m);
  add("thickness_m", set.thickness_m);
  return out;
}

/// "key = [1, 2]", one entry each.
template <typename Thing, typename Text>
std::string row(const char* key, std::span<const Thing> things, const Text& text_of) {
  std::string line = fmt::format("{} = [", key);
  for (std::size_t i = 0; i < things.size(); ++i) {
    line += (i == 0 ? "" : ", ") + text_of(things[i]);
  }
  return line + "]\n";
}

std::string more_transitions(const Geometry& shape) {
  if (shape.transitions.size() < 2) {
    return "";
  }
  const auto more = std::span{shape.transitions}.subspan(1);
  using Transition = Geometry::Transition;
  return "\n[more_transitions]\n" + row("positions_m", more, [](const Transition& t) { return exact(t.position_m); }) +
         row("lengths_m", more, [](const Transition& t) { return exact(t.length_m); }) +
         row("diameters_m", more, [](const Transition& t) { return exact(t.aft_diameter_m); });
}

std::string more_fins(const Geometry& shape) {
  if (shape.more_fins.empty()) {
    return "";
  }
  const std::span<const Geometry::MoreFins> all = shape.more_fins;
  using Fins = Geometry::MoreFins;
  return "\n[more_fins]\n" + row("names", all, [](const Fins& f) { return text::toml_text(f.name); }) +
         row("counts", all, [](const Fins& f) { return fmt::format("{}", f.set.count); }) +
         row("first_angles_deg", all, [](const Fins& f) { return exact(text::degrees(f.first_angle_rad)); }) +
         row("positions_m", all, [](const Fins& f) { return exact(f.set.position_m); }) +
         row("root_chords_m", all, [](const Fins& f) { return exact(f.set.root_chord_m); }) +
         row("tip_chords_m", all, [](const Fins& f) { return exact(f.set.tip_chord_m); }) +
         row("spans_m", all, [](const Fins& f) { return exact(f.set.span_m); }) +
         row("sweeps_m", all, [](const Fins& f) { return exact(f.set.sweep_m); }) +
         row("cants_deg", all, [](const Fins& f) { return exact(text::degrees(f.set.cant_rad)); });
}

std::string masses(const Geometry& shape) {
  if (shape.masses.empty()) {
    return "";
  }
  const std::span<const Geometry::Mass> all = shape.masses;
  std::string out = "\n[masses]\n";
  out += row("names", all, [](const Geometry::Mass& m) { return text::toml_text(m.name); });
  out += row("masses_kg", all, [](const Geometry::Mass& m) { return exact(m.mass_kg); });
  out += row("positions_m", all, [](const Geometry::Mass& m) { return exact(m.position_m); });
  out += row("lengths_m", all, [](const Geometry::Mass& m) { return exact(m.length_m); });
  out += row("radii_of_gyration_m", all, [](const Geometry::Mass& m) { return exact(m.radius_of_gyration_m); });
  if (const auto& propellant = shape.propellant) {
    out += fmt::format("propellant_position_m = {}\npropellant_length_m = {}\npropellant_radius_of_gyration_m = {}\n",
                       exact(propellant->position_m), exact(propellant->length_m),
                       exact(propellant->radius_of_gyration_m));
  }
  return out;
}

std::string design_section(const Geometry::Design& design) {
  std::string out =
      "\n[design] # fantail airframe compares this with the vehicle; delete it when the rocket has been weighed\n";
  out += fmt::format("file = {}\n", text::toml_text(design.file));
  out += design.flight.empty() ? "" : fmt::format("flight = {}\n", text::toml_text(design.flight));
  const auto add = [&](const char* key, const std::optional<double>& value) {
    out += value ? fmt::format("{} = {}\n", key, rounded(*value)) : "";
  };
  add("mass_kg", design.mass_kg);
  add("centre_of_gravity_m", design.centre_of_gravity_m);
  add("centre_of_pressure_m", design.centre_of_pressure_m);
  if (design.centre_of_pressure_m) {
    add("angle_of_attack_deg", text::degrees(design.angle_of_attack_rad));
  }
  add("margin_calibres", design.margin_calibres);
  return out + (design.left_out.empty() ? "" : sentences("left_out", design.left_out));
}

std::string shape_sections(const sim::Vehicle& vehicle) {
  const Geometry& shape = *vehicle.geometry;
  std::string out = "\n[shape]\n";
  if (!vehicle.geometry_assumed.empty()) {
    out += sentences("assumed", vehicle.geometry_assumed);
  }
  out += fmt::format("diameter_m = {}\nlength_m = {}\nnose = \"{}\"\nnose_length_m = {}\n", exact(shape.diameter_m),
                     exact(shape.length_m), nose_names.at(static_cast<std::size_t>(shape.nose_shape)),
                     exact(shape.nose_length_m));
  if (!shape.transitions.empty()) {
    const Geometry::Transition& first = shape.transitions.front();
    out += fmt::format("transition_position_m = {}\ntransition_length_m = {}\ntransition_diameter_m = {}\n",
                       exact(first.position_m), exact(first.length_m), exact(first.aft_diameter_m));
  }
  out += more_transitions(shape);
  if (shape.canards) {
    out += fin_set("canard_fins", *shape.canards);
    out += shape.canard_hinge_m ? fmt::format("hinge_m = {}\n", exact(*shape.canard_hinge_m)) : "";
  }
  if (shape.fins) {
    out += fin_set("fins", *shape.fins);
    out += fmt::format("count = {}\n", shape.fins->count);
    out +=
        shape.fins->cant_rad != 0.0 ? fmt::format("cant_deg = {}\n", exact(text::degrees(shape.fins->cant_rad))) : "";
  }
  return out + more_fins(shape) + masses(shape) + (shape.design ? design_section(*shape.design) : "");
}

std::string airframe_section(const Geometry& shape, const model::BuildUp& b) {
  if (!b.at_liftoff || !b.after_burnout) {
    return "";
  }
  std::string out = "\n[airframe] # as fantail airframe computes it from the sections below\n";
  const auto add = [&](const char* key, double value) { out += fmt::format("{} = {}\n", key, rounded(value)); };
  out += fmt::format("diameter_m = {}\nlength_m = {}\n", exact(shape.diameter_m), exact(shape.length_m));
  add("normal_force_slope_per_rad", b.normal_force_slope_per_rad.value);
  add("centre_of_pressure_m", b.centre_of_pressure_m.value);
  add("parts_spread_m", b.parts_spread_m);
  add("body_lift_area_m2", b.body_lift_area_m2);
  add("body_lift_position_m", b.body_lift_position_m);
  add("centre_of_gravity_m", b.at_liftoff->centre_of_gravity_m);
  add("centre_of_gravity_after_burnout_m", b.after_burnout->centre_of_gravity_m);
  add("transverse_inertia_kg_m2", b.at_liftoff->transverse_inertia_kg_m2);
  add("transverse_inertia_after_burnout_kg_m2", b.after_burnout->transverse_inertia_kg_m2);
  add("roll_inertia_after_burnout_kg_m2", b.after_burnout->roll_inertia_kg_m2);
  return out;
}

const std::optional<model::MassSum>& parts_of(const model::BuildUp& b) {
  return b.at_liftoff ? b.at_liftoff : b.after_burnout;
}

/// What the vehicle's file will say of its roll and of what the gains depend on.
sim::Vehicle with_roll_of_shape(const sim::Vehicle& source, const model::BuildUp& b) {
  const auto& parts = parts_of(b);
  const double area_m2 = 0.25 * std::numbers::pi * source.geometry->diameter_m * source.geometry->diameter_m;
  sim::Vehicle vehicle;
  vehicle.mass_kg = source.mass_kg;
  vehicle.drag_area_m2 = source.drag_area_m2;
  vehicle.motor = source.motor;
  vehicle.drag_over_mach = source.drag_over_mach;
  vehicle.servo = source.servo;
  vehicle.imu = source.imu;
  vehicle.canard_air = {.wash = source.canard_air.wash, .wash_distance_m = source.canard_air.wash_distance_m};
  vehicle.compressibility = sim::Compressibility::prandtl_glauert;
  vehicle.roll_plant = {.inertia_kg_m2 = parts ? parts->roll_inertia_kg_m2 : source.roll_plant.inertia_kg_m2,
                        .reference_area_m2 = area_m2,
                        .damping_m2 = b.roll_damping_m4.value / area_m2,
                        .torque_m = b.roll_torque_m3 ? b.roll_torque_m3->value / area_m2 : 0.0};
  return vehicle;
}

std::string kept_in(std::string_view section, const NewRocket& rocket) {
  const auto found = std::ranges::find(rocket.kept, section, &NewRocket::Kept::section);
  return found == rocket.kept.end() ? "" : found->lines;
}

std::string kept_sections(const NewRocket& rocket) {
  constexpr std::array<std::string_view, 4> written{"body", "aerodynamics", "airframe", "motor"};
  std::string out;
  for (const auto& [section, lines] : rocket.kept) {
    if (std::ranges::find(written, section) == written.end()) {
      out += fmt::format("\n[{}]\n{}", section, lines);
    }
  }
  return out;
}

std::string vehicle_file(const NewRocket& rocket, const model::BuildUp& b) {
  const sim::Vehicle& v = rocket.vehicle;
  const auto& parts = parts_of(b);
  const sim::RollPlant roll = with_roll_of_shape(v, b).roll_plant;
  std::vector<std::string> assumed = rocket.assumed;
  assumed.emplace_back(
      "Roll damping and canard torque: computed from the shape, right within a factor of two at best.");
  if (b.canard_arm_m) {
    assumed.push_back(fmt::format("Canard stall at {} deg: usual for such plates.", stall_deg));
  }
  if (parts) {
    assumed.emplace_back("Roll inertia: the sum of the parts.");
  }
  if (const auto& design = v.geometry->design) {
    assumed.push_back(design->flight.empty()
                          ? fmt::format("Mass and centre of gravity: of {}, which stores no flight with this motor to "
                                        "compare them with.",
                                        design->file)
                          : fmt::format("Mass and centre of gravity: of {}.", design->file));
    for (const std::string& left_out : design->left_out) {
      assumed.push_back(fmt::format("Left out of {}, or uncertain: {}.", design->file, left_out));
    }
  }
  std::string out = "# SPDX-License-Identifier: MIT\n";
  out += fmt::format("# Made by fantail new from {}.\n\n", rocket.source);
  out += fmt::format("[body]\nname = {}\n{}mass_kg = {}\nroll_inertia_kg_m2 = {}\ndrag_area_m2 = {}\n",
                     text::toml_text(rocket.name), sentences("assumed", assumed), exact(v.mass_kg),
                     rounded(roll.inertia_kg_m2), rounded(v.drag_area_m2));
  out += kept_in("body", rocket);
  out += fmt::format(
      "\n[aerodynamics]\nreference_area_m2 = {} # the cross-section\ndamping_m2 = {} # alpha\n"
      "torque_m = {} # beta, without the canards' wash on the fins\n",
      rounded(roll.reference_area_m2), rounded(roll.damping_m2), rounded(roll.torque_m));
  out += "compressibility = \"prandtl_glauert\"\n";
  if (b.canard_arm_m) {
    out += fmt::format("canard_stall_deg = {}\ncanard_arm_m = {}\n", stall_deg, rounded(*b.canard_arm_m));
  }
  if (b.hinge_moment_m3) {
    out += fmt::format("canard_hinge_moment_m3 = {} # loads the servos once servo.torque_n_m is given\n",
                       rounded(b.hinge_moment_m3->value));
  }
  out += kept_in("aerodynamics", rocket);
  const std::string airframe = airframe_section(*v.geometry, b);
  out += airframe + (airframe.empty() ? "" : kept_in("airframe", rocket)) + shape_sections(v);
  out += fmt::format("\n[motor]\nfile = {}\n{}{}", text::toml_text(rocket.motor_file),
                     v.motor_count > 1 ? fmt::format("count = {}\n", v.motor_count) : "", kept_in("motor", rocket));
  return out + kept_sections(rocket);
}

}  // namespace

NewFiles files_of(const NewRocket& rocket) {
  const model::BuildUp b = model::build_up(rocket.vehicle);
  const bool whole = b.at_liftoff && b.after_burnout;
  const std::string first_line = fmt::format("# {}. Made by fantail new.\n", rocket.name);
  core::FlightPlan usual = core::default_plan();
  usual.guide.minimum_speed_m_s = 17.0F;  // as in plan_text
  const FinOffset offset = fin_offset(b);
  const auto first = first_gains(with_roll_of_shape(rocket.vehicle, b), b, usual, text::radians(offset.angle_deg));
  NewFiles made{.files = {{.name = "vehicle.toml", .content = vehicle_file(rocket, b)},
                          {.name = "plan.toml", .content = first_line + plan_file(first, usual)},
                          {.name = "scenario.toml",
                           .content = first_line + scenario_file(offset, whole, b.roll_torque_m3.has_value())}},
                .gains = first              ? sentence(*first)
                         : b.roll_torque_m3 ? why_none(usual)
                                            : "",
                .decides = what_decides(b, first, static_cast<double>(usual.controller.canard_limit.radians()))};
  if (rocket.motor) {
    made.files.push_back(*rocket.motor);
  }
  return made;
}

}  // namespace fantail::airframe
