// SPDX-License-Identifier: MIT
#include "trajectory/trajectory.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "files/load.hpp"
#include "sim/atmosphere.hpp"
#include "sim/units.hpp"
#include "text/error.hpp"
#include "text/input_file.hpp"
#include "text/number.hpp"
#include "trajectory/series.hpp"

namespace fantail::trajectory {
namespace {

/// After the last row whose felt force is more than this, the motor is out: a rocket that coasts feels its drag, which
/// pulls backwards. Behind apogee it falls, and only a push that has lasted since before it is a motor's.
constexpr double least_thrust_m_s2 = 2.0;

/// A rocket that climbs slower at the end of its trajectory is within 5 cm and 0.1 s of apogee.
constexpr double least_climb_m_s = 1.0;

/// Above where it stood.
std::vector<double> heights(const Series& series) {
  const auto* above_site_m = series.find(Quantity::height);
  std::vector<double> height_m = above_site_m != nullptr ? *above_site_m : *series.find(Quantity::height_above_the_sea);
  const double pad_m = height_m[series.liftoff];
  for (double& height : height_m) {
    height -= pad_m;
  }
  return height_m;
}

std::optional<double> burnout_s(const Series& series, const std::vector<sim::PathSample>& samples) {
  std::optional<std::size_t> out;
  for (std::size_t i = std::max<std::size_t>(series.liftoff, 1); i < samples.size(); ++i) {
    const sim::PathSample& before = samples[i - 1];
    const sim::PathSample& here = samples[i];
    const double dt_s = here.time_s - before.time_s;
    const double felt_m_s2 = here.axial_specific_force_m_s2.value_or(
        ((here.up_m_s - before.up_m_s) / dt_s + sim::gravity_m_s2) * std::cos(here.tilt_rad) +
        (here.across_m_s - before.across_m_s) / dt_s * std::sin(here.tilt_rad));
    if (felt_m_s2 > least_thrust_m_s2) {
      out = i + 1;
    } else if (i + 1 >= series.apogee) {
      break;
    }
  }
  // Pushed up to apogee or the last row: the file ends before, or its speeds do not tell thrust from weight.
  constexpr double clearly_s = 0.1;
  const bool is_told = out && *out < samples.size() &&
                       (*out < series.apogee || samples[*out].time_s > samples[series.apogee].time_s + clearly_s);
  return is_told ? std::optional{samples[*out].time_s} : std::nullopt;
}

constexpr double gas_constant_j_kg_k = 287.05287;  // of dry air, as the ISA has it
constexpr double coarse_share = 0.02;

/// What the last digit of a column is worth, by its longest number: some writers leave trailing zeros out. Empty for
/// numbers with an exponent.
std::optional<double> last_digit(const flight::Table& table, const FoundColumn& column) {
  std::size_t decimals = 0;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const std::string_view cell = table.cell(row, column.found.column);
    if (cell.find_first_of("eE") != std::string_view::npos) {
      return std::nullopt;
    }
    const std::size_t point = cell.find('.');
    decimals = std::max(decimals, point == std::string_view::npos ? 0 : cell.size() - point - 1);
  }
  return column.found.factor * std::pow(10.0, -static_cast<double>(decimals));
}

bool is_coarse(const flight::Table& table, const Columns& columns, const std::vector<double>& density_kg_m3) {
  const auto digit_kg_m3 = last_digit(table, *columns.find(Quantity::air_density));
  return digit_kg_m3 && *digit_kg_m3 > coarse_share * density_kg_m3.front();
}

/// Density at each row of a series, and where it is from.
struct Air {
  std::vector<double> density_kg_m3;
  std::vector<Quantity> read;        ///< from the file
  std::vector<std::string> derived;  ///< words for a person: "the density is that of the scenario"
};

Air air_of(const flight::Table& table, const Columns& columns, const Series& series,
           const std::vector<double>& height_m, const sim::Atmosphere& atmosphere) {
  Air air;
  std::string why;
  if (const auto* density_kg_m3 = series.find(Quantity::air_density)) {
    if (!is_coarse(table, columns, *density_kg_m3)) {
      air.density_kg_m3 = *density_kg_m3;
      air.read.push_back(Quantity::air_density);
      return air;
    }
    why = ", because that of the file is rounded to more than 2 % of itself";
  }
  const auto* temperature_k = series.find(Quantity::temperature);
  const auto* pressure_pa = series.find(Quantity::pressure);
  if (temperature_k != nullptr && pressure_pa != nullptr) {
    for (std::size_t i = 0; i < height_m.size(); ++i) {
      air.density_kg_m3.push_back((*pressure_pa)[i] / (gas_constant_j_kg_k * (*temperature_k)[i]));
    }
    air.read = {Quantity::temperature, Quantity::pressure};
    air.derived.push_back("the air density follows from temperature and pressure" + why);
    return air;
  }
  for (const double height : height_m) {
    air.density_kg_m3.push_back(atmosphere.density_kg_m3(height));
  }
  air.derived.push_back("the air density is that of the scenario at these heights" + why);
  return air;
}

/// Both are of the file, and a column in another unit than its header says shows here.
std::optional<std::string> disagreement(const Series& series, const std::vector<sim::PathSample>& samples) {
  double climbed_m = 0.0;
  for (std::size_t i = series.liftoff; i < series.apogee; ++i) {
    climbed_m += 0.5 * (samples[i].up_m_s + samples[i + 1].up_m_s) * (samples[i + 1].time_s - samples[i].time_s);
  }
  const double height_m = samples[series.apogee].height_m - samples[series.liftoff].height_m;
  if (std::abs(climbed_m - height_m) <= 1.0 + 0.03 * height_m) {
    return std::nullopt;
  }
  return fmt::format(
      "Height and speed of the file do not agree: up to the highest row it rises by {:.0f} m, but its speeds give "
      "{:.0f} m.",
      height_m, climbed_m);
}

std::string listed(const std::vector<Quantity>& quantities) {
  std::string all;
  for (std::size_t i = 0; i < quantities.size(); ++i) {
    all += i == 0 ? "" : i + 1 == quantities.size() ? " and " : ", ";
    all += files::word(quantities[i]);
  }
  return all;
}

/// Whoever exported a column expects it to count.
std::optional<std::string> left_unused(const flight::Table& table, const Columns& columns,
                                       const std::vector<Quantity>& used) {
  constexpr std::size_t most_named = 6;
  std::string names;
  std::size_t count = 0;
  for (std::size_t i = 0; i < table.columns().size(); ++i) {
    const bool is_used = std::ranges::any_of(columns.all(), [&](const FoundColumn& column) {
      return column.found.column == i && std::ranges::find(used, column.quantity) != used.end();
    });
    if (!is_used && ++count <= most_named) {
      names += (names.empty() ? "" : ", ") + flight::in_quotes(table.columns()[i]);
    }
  }
  if (count == 0) {
    return std::nullopt;
  }
  return fmt::format("Columns of the file that are not used: {}{}.", names,
                     count > most_named ? fmt::format(" and {} more columns", count - most_named) : "");
}

std::string origin(const std::string& name, const Series& series, const std::vector<Quantity>& read,
                   const std::vector<std::string>& derived) {
  return fmt::format(
      "The path of this flight is that of {} ({} to {:.2f} s): {} are read from it; {}. Thrust, drag, mass and wind of "
      "vehicle and scenario play no part in it.",
      name, text::counted(series.times_s.size(), "row"), series.times_s.back(), listed(read), fmt::join(derived, "; "));
}

}  // namespace

Trajectory parse_trajectory(std::string text, const std::string& name, const sim::Scenario& scenario) {
  if (scenario.surroundings != sim::Surroundings::flight) {
    throw text::Error{
        text::ErrorKind::bad_configuration,
        fmt::format("{}: a trajectory is flown in a flight, and environment.surroundings is \"{}\"", scenario.name,
                    scenario.surroundings == sim::Surroundings::tunnel ? "tunnel" : "gimbal")};
  }
  const files::Loaded file = files::parse(std::move(text), name);
  const flight::Table& table = file.table;
  const Columns columns{table};
  const Series series = read_series(table, columns);
  const std::vector<double> height_m = heights(series);
  const Motion motion = motion_of(series, scenario.guide.tilt_rad);
  const Air air = air_of(table, columns, series, height_m, scenario.atmosphere);

  Trajectory trajectory;
  std::vector<sim::PathSample>& samples = trajectory.path.samples;
  samples.reserve(series.times_s.size());
  for (std::size_t i = 0; i < series.times_s.size(); ++i) {
    samples.push_back(
        {.time_s = series.times_s[i],
         .height_m = height_m[i],
         .up_m_s = motion.up_m_s[i],
         .across_m_s = motion.across_m_s[i],
         .along_axis_m_s = motion.along_axis_m_s[i],
         .density_kg_m3 = air.density_kg_m3[i],
         .tilt_rad = motion.tilt_rad[i],
         .axial_specific_force_m_s2 = motion.felt_m_s2.empty() ? std::nullopt : std::optional{motion.felt_m_s2[i]}});
  }
  trajectory.path.liftoff_s = series.times_s[series.liftoff];
  trajectory.path.burnout_s = burnout_s(series, samples);
  if (!series.climbs_to_the_end || samples.back().up_m_s < least_climb_m_s) {
    trajectory.path.apogee_s = series.times_s[series.apogee];
  }
  std::vector<Quantity> read{series.find(Quantity::height) != nullptr ? Quantity::height
                                                                      : Quantity::height_above_the_sea};
  read.insert(read.end(), motion.read.begin(), motion.read.end());
  read.insert(read.end(), air.read.begin(), air.read.end());
  std::vector<std::string> derived = motion.derived;
  derived.insert(derived.end(), air.derived.begin(), air.derived.end());
  trajectory.notes.push_back(origin(name, series, read, derived));
  trajectory.notes.insert(trajectory.notes.end(), file.notes.begin(), file.notes.end());
  trajectory.notes.insert(trajectory.notes.end(), series.notes.begin(), series.notes.end());
  read.insert(read.end(), series.needed.begin(), series.needed.end());
  if (auto sentence = left_unused(table, columns, read)) {
    trajectory.notes.push_back(*std::move(sentence));
  }
  if (auto sentence = disagreement(series, samples)) {
    trajectory.notes.push_back(*std::move(sentence));
  }
  return trajectory;
}

Trajectory load_trajectory(const std::string& path, const sim::Scenario& scenario) {
  return parse_trajectory(text::read_input(path), path, scenario);
}

}  // namespace fantail::trajectory
