// SPDX-License-Identifier: MIT
#include <cctype>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "airframe/summary.hpp"
#include "text/number.hpp"

namespace fantail::airframe {
namespace {

using text::fixed;

constexpr double part_mass_tolerance = 0.02;

/// A number that the file has in one section, and that follows from another.
struct SaidTwice {
  const char* what;
  const char* unit;
  double in_file;
  const char* section;  ///< where the file has it
  double other;
  const char* source;  ///< of the other
  double tolerance;
};

void add_sizes(std::vector<SaidTwice>& all, const sim::Geometry& shape, const sim::Airframe& airframe) {
  constexpr double a_millimetre_m = 0.001;
  const char* const by_shape = "in [shape]";
  all.push_back({"the length", " m", airframe.length_m, "[airframe]", shape.length_m, by_shape, a_millimetre_m});
  all.push_back({"the diameter", " m", airframe.diameter_m, "[airframe]", shape.diameter_m, by_shape, a_millimetre_m});
}

/// Tubes that hold much small mass count as one: an inertia is right within half of it.
SaidTwice inertia(const char* what, double in_file_kg_m2, const char* section, double of_parts_kg_m2) {
  constexpr double tolerance = 0.5;
  return {
      what, " kg m2", in_file_kg_m2, section, of_parts_kg_m2, "by the parts in [masses]", tolerance * of_parts_kg_m2};
}

void add_balance(std::vector<SaidTwice>& all, const model::MassSum& parts, const sim::Airframe::MassProperties& file,
                 double calibre_m, bool is_at_liftoff) {
  constexpr double gravity_tolerance_calibres = 0.2;  // as for a design
  all.push_back({is_at_liftoff ? "the centre of gravity at lift-off" : "the centre of gravity after burn-out", " m",
                 file.centre_of_gravity_m, "[airframe]", parts.centre_of_gravity_m, "by the parts in [masses]",
                 gravity_tolerance_calibres * calibre_m});
  all.push_back(inertia(is_at_liftoff ? "the transverse inertia at lift-off" : "the transverse inertia after burn-out",
                        file.transverse_inertia_kg_m2, "[airframe]", parts.transverse_inertia_kg_m2));
}

std::vector<SaidTwice> said_twice(const model::BuildUp& b, const sim::Vehicle& vehicle, bool parts_weigh_the_same) {
  const sim::Geometry& shape = *vehicle.geometry;
  const double calibre_m = model::largest_diameter_m(shape);
  const auto& airframe = vehicle.airframe;
  std::vector<SaidTwice> all;
  if (airframe) {
    add_sizes(all, shape, *airframe);
  }
  if (!parts_weigh_the_same) {  // balance and inertia follow from the mass
    return all;
  }
  if (airframe && b.at_liftoff) {
    add_balance(all, *b.at_liftoff, airframe->at_liftoff, calibre_m, true);
  }
  if (airframe && b.after_burnout) {
    add_balance(all, *b.after_burnout, airframe->after_burnout, calibre_m, false);
  }
  if (b.at_liftoff) {
    all.push_back(inertia("the roll inertia at lift-off", vehicle.roll_plant.inertia_kg_m2, "[body]",
                          b.at_liftoff->roll_inertia_kg_m2));
  }
  if (airframe && airframe->roll_inertia_after_burnout_kg_m2 && b.after_burnout) {
    all.push_back(inertia("the roll inertia after burn-out", *airframe->roll_inertia_after_burnout_kg_m2, "[airframe]",
                          b.after_burnout->roll_inertia_kg_m2));
  }
  return all;
}

}  // namespace

/// Two reasons stand behind one word.
void doubt(Summary& summary, const std::string& why) {
  const std::size_t behind_word = summary.sentence.find(": ") + 2;
  if (summary.sentence.substr(0, behind_word).find("oubtful: ") != std::string::npos) {
    char& next = summary.sentence[behind_word];
    next = static_cast<char>(std::toupper(static_cast<unsigned char>(next)));
    summary.sentence.insert(behind_word, why + " ");
    return;
  }
  const bool is_unstable = summary.stability == Stability::unstable;
  summary.sentence = fmt::format("{}: {} Weigh and balance the rocket, or correct the file. As it stands: {}",
                                 is_unstable ? "Unstable, and doubtful" : "Doubtful", why, summary.sentence);
  if (!is_unstable) {
    summary.stability = Stability::doubtful;
  }
}

std::string parts_off_mass(const model::BuildUp& computed, const sim::Vehicle& vehicle) {
  const double empty_kg = vehicle.mass_kg - vehicle.motor.propellant_kg();
  if (!computed.after_burnout ||
      std::abs(computed.after_burnout->mass_kg - empty_kg) <= part_mass_tolerance * empty_kg) {
    return {};
  }
  const double parts_kg = computed.after_burnout->mass_kg;
  return fmt::format(
      "the parts in [masses] weigh {} kg, but body.mass_kg less the motor's propellant is {} kg, {} % {}",
      fixed(parts_kg, 3), fixed(empty_kg, 3), fixed(100.0 * std::abs(empty_kg - parts_kg) / parts_kg, 0),
      empty_kg > parts_kg ? "more" : "less");
}

void doubt_own_numbers(Summary& summary, const sim::Vehicle& vehicle) {
  std::vector<std::string> doubts;
  const std::string off = parts_off_mass(summary.build_up, vehicle);
  if (!off.empty()) {
    doubts.push_back(off);
  }
  for (const SaidTwice& number : said_twice(summary.build_up, vehicle, off.empty())) {
    if (std::abs(number.in_file - number.other) > number.tolerance) {
      doubts.push_back(fmt::format("{} is {:.4g}{} in {} but {:.4g}{} {}", number.what, number.in_file, number.unit,
                                   number.section, number.other, number.unit, number.source));
    }
  }
  if (!summary.centre_of_gravity_m && summary.stability != Stability::unknown) {
    doubts.emplace_back("the centre of gravity at lift-off, where the margin is usually least, is unknown");
  }
  for (const std::string& why : doubts) {
    summary.doubts.push_back(why);
    doubt(summary, why + ".");
  }
}

}  // namespace fantail::airframe
