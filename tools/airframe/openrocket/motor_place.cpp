// SPDX-License-Identifier: MIT
// Where the motors of a design are, and which of them a file of thrust is about.
#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/core.h>

#include "airframe/openrocket/reader.hpp"

namespace fantail::airframe::openrocket {
namespace {

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }
bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }
char upper(char c) { return static_cast<char>(std::toupper(static_cast<unsigned char>(c))); }

/// "I150" of "1115-i150WH-14A": a letter that no letter precedes, and its digits. All of it where there is none.
std::string class_and_thrust(std::string_view name) {
  for (std::size_t i = 0; i + 1 < name.size(); ++i) {
    if (is_letter(name[i]) && is_digit(name[i + 1]) && (i == 0 || !is_letter(name[i - 1]))) {
      const auto* const end = std::find_if_not(name.begin() + static_cast<std::ptrdiff_t>(i) + 1, name.end(), is_digit);
      return upper(name[i]) + std::string{name.begin() + i + 1, end};
    }
  }
  std::string all{name};
  std::ranges::transform(all, all.begin(), upper);
  return all;
}

/// How many, and the mean square of their distances from the middle, in distances between neighbours.
struct Arrangement {
  std::string_view name;
  int count;
  double mean_square;
};
constexpr double ring_of_five = 0.72360680;  // 1 / (2 sin 36 deg) squared
constexpr double of_the_nine = 1.4 * 1.4;
constexpr std::array arrangements{
    Arrangement{"single", 1, 0.0},
    Arrangement{"double", 2, 0.25},
    Arrangement{"3-row", 3, 2.0 / 3.0},
    Arrangement{"4-row", 4, 1.25},
    Arrangement{"3-ring", 3, 1.0 / 3.0},
    Arrangement{"4-ring", 4, 0.5},
    Arrangement{"5-ring", 5, ring_of_five},
    Arrangement{"6-ring", 6, 1.0},
    Arrangement{"3-star", 4, 3.0 / 4.0},  // around one in the middle
    Arrangement{"4-star", 5, 4.0 / 5.0},
    Arrangement{"5-star", 6, 5.0 / 6.0},
    Arrangement{"6-star", 7, 6.0 / 7.0},
    Arrangement{"9-grid", 9, 12.0 / 9.0 * of_the_nine},
    Arrangement{"9-star", 9, 8.0 / 9.0 * of_the_nine},
};

}  // namespace

Cluster cluster_of(const Component& c, double outer_m) {
  const std::string name = c.text("clusterconfiguration");
  if (name.empty()) {
    return {};
  }
  const auto* const found = std::ranges::find(arrangements, name, &Arrangement::name);
  if (found == arrangements.end()) {
    c.refuse(fmt::format("its cluster is \"{}\", which no version of OpenRocket up to 24.12 has", name));
  }
  const double apart_m = 2.0 * outer_m * c.number_or("clusterscale", 0.0, 100.0, 1.0);
  return {.count = found->count, .ring_m = apart_m * std::sqrt(found->mean_square)};
}

void Reader::note_motor(const Component& c, const Place& place, const Cluster& cluster) {
  const pugi::xml_node mount = c.xml().child("motormount");
  if (!mount) {
    return;
  }
  if (design_.motor) {
    design_.not_used.push_back(fmt::format("Motor mount \"{}\": a second one.", c.name()));
    leave_out(c, "a second motor mount", true);
    return;
  }
  const Component mounted{file_, mount};
  MotorPlace motor{.end_m = place.begin_m + place.length_m + mounted.number_or("overhang", -5.0, 5.0, 0.0),
                   .count = cluster.count,
                   .ring_m = cluster.ring_m};
  for (const pugi::xml_node node : mount.children("motor")) {
    const Component one{file_, node};
    motor.motors.push_back({.configuration = node.attribute("configid").as_string(),
                            .designation = one.text("designation"),
                            .length_m = one.number_or("length", 0.0, 10.0, 0.0),
                            .diameter_m = one.number_or("diameter", 0.0, 1.0, 0.0)});
  }
  if (!motor.motors.empty()) {
    design_.motor = motor;
  }
}

std::vector<NamedMotor> MotorPlace::called(const std::string& name) const {
  std::vector<NamedMotor> found;
  std::ranges::copy_if(motors, std::back_inserter(found), [&](const NamedMotor& motor) {
    return class_and_thrust(motor.designation) == class_and_thrust(name);
  });
  return found;
}

}  // namespace fantail::airframe::openrocket
