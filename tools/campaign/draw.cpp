// SPDX-License-Identifier: MIT
#include "campaign/draw.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include <fmt/core.h>

#include "distributions/quantiles.hpp"
#include "runs/runner.hpp"
#include "sim/random.hpp"
#include "text/error.hpp"

namespace fantail::campaign {
namespace {

/// Of the random numbers of a run; those of the world begin at one.
constexpr std::uint64_t first_stream = 2'000;
constexpr std::uint64_t again_stream = 3'000;  ///< one for each spread
constexpr int most_draws = 1'000;

/// The middle of a step, so that neither 0 nor 1 is ever drawn.
double open_unit(std::uint64_t random_bits) { return (static_cast<double>(random_bits >> 12U) + 0.5) * 0x1p-52; }

std::vector<double> normal(const Spread& spread, std::span<const double> normals) {
  std::vector<double> numbers = spread.means;
  std::size_t place = 0;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    double sum = 0.0;
    for (std::size_t k = 0; k <= i; ++k) {
      sum += spread.correlation_root[place++] * normals[k];
    }
    numbers[i] += spread.standard_deviations[i] * sum;
  }
  return numbers;
}

double triangular(const Spread& spread, double unit) {
  const double width = spread.high - spread.low;
  const double share_below_mode = (spread.mode - spread.low) / width;
  return unit < share_below_mode ? spread.low + std::sqrt(unit * width * (spread.mode - spread.low))
                                 : spread.high - std::sqrt((1.0 - unit) * width * (spread.high - spread.mode));
}

/// Laws that are made of standard normal numbers; the others are made of one that is even between 0 and 1.
bool takes_normals(const Spread& spread) { return spread.law == Law::normal || spread.law == Law::next_row; }

std::vector<double> numbers_of_normals(const Spread& spread, std::span<const double> normals) {
  return spread.law == Law::normal ? normal(spread, normals) : spread.next_row->draw(normals);
}

std::vector<double> numbers_of_unit(const Spread& spread, double unit) {
  if (spread.law == Law::uniform) {
    return {spread.low + unit * (spread.high - spread.low)};
  }
  if (spread.law == Law::triangular) {
    return {triangular(spread, unit)};
  }
  const auto row = static_cast<std::size_t>(unit * static_cast<double>(spread.rows.size()));
  return spread.rows[std::min(row, spread.rows.size() - 1)];
}

std::vector<double> numbers_of(const Spread& spread, std::span<const double> unit) {
  if (!takes_normals(spread)) {
    return numbers_of_unit(spread, unit[0]);
  }
  std::vector<double> normals(unit.size());
  std::ranges::transform(unit, normals.begin(), distributions::normal_quantile);
  return numbers_of_normals(spread, normals);
}

std::vector<double> after(Effect effect, const input::NumberField& field, double number) {
  std::vector<double> values = field.values;
  for (double& value : values) {
    value = effect == Effect::value ? number : effect == Effect::offset ? value + number : value * number;
  }
  return values;
}

struct Leaves {
  const input::NumberField* field;
  double value;
};

/// The first of the values that its field does not allow.
std::optional<Leaves> first_outside(const Spread& spread, const std::vector<double>& numbers) {
  for (std::size_t i = 0; i < spread.fields.size(); ++i) {
    const input::NumberField& field = spread.fields[i];
    for (const double value : after(spread.effect, field, numbers[i])) {
      if (!(value >= field.range.minimum && value <= field.range.maximum)) {
        return Leaves{.field = &field, .value = value};
      }
    }
  }
  return std::nullopt;
}

constexpr const char* truncate_instead = "outside = \"truncate\" draws again instead";

[[noreturn]] void refuse(const Spread& spread, const std::string& who, const Leaves& leaves, const char* advice) {
  throw text::Error{text::ErrorKind::bad_configuration,
                    fmt::format("{}: {} draws {} = {}; allowed: {} to {}; {}", spread.where, who, leaves.field->name(),
                                leaves.value, leaves.field->range.minimum, leaves.field->range.maximum, advice)};
}

void take(Draw& draw, const Spread& spread, const std::vector<double>& numbers) {
  for (std::size_t i = 0; i < spread.fields.size(); ++i) {
    draw.numbers.push_back(numbers[i]);
    draw.changes.push_back(spread.fields[i].with(after(spread.effect, spread.fields[i], numbers[i])));
  }
}

}  // namespace

double unit_coordinate(std::uint64_t master_seed, std::uint64_t run, std::size_t dimension) {
  return open_unit(sim::Random{runs::key_of_run(master_seed, run), first_stream + dimension}.bits());
}

Draw Drawer::draw(std::uint64_t run) const {
  Draw draw;
  std::size_t dimension = 0;
  for (std::size_t s = 0; s < spreads_.size(); ++s) {
    const Spread& spread = spreads_[s];
    std::vector<double> unit;
    unit.reserve(spread.dimensions());
    for (std::size_t i = 0; i < spread.dimensions(); ++i) {
      unit.push_back(unit_coordinate(master_seed_, run, dimension++));
    }
    std::vector<double> numbers = numbers_of(spread, unit);
    sim::Random random{runs::key_of_run(master_seed_, run), again_stream + s};
    int draws = 1;
    for (auto left = first_outside(spread, numbers); left; left = first_outside(spread, numbers)) {
      if (spread.outside == Outside::refuse) {
        refuse(spread, fmt::format("run {}", run), *left, truncate_instead);
      }
      if (++draws > most_draws) {
        refuse(spread, fmt::format("run {}", run), *left,
               "a thousand draws in a row were outside: so is nearly all of the law");
      }
      for (double& coordinate : unit) {
        coordinate = open_unit(random.bits());
      }
      numbers = numbers_of(spread, unit);
      ++draw.drawn_again;
    }
    take(draw, spread, numbers);
  }
  return draw;
}

std::optional<Draw> Drawer::draw_at(std::span<const double> normals) const {
  Draw draw;
  for (const Spread& spread : spreads_) {
    const std::span<const double> own = normals.first(spread.dimensions());
    normals = normals.subspan(own.size());
    const std::vector<double> numbers = takes_normals(spread)
                                            ? numbers_of_normals(spread, own)
                                            : numbers_of_unit(spread, distributions::normal_tail(-own[0]));
    if (const auto left = first_outside(spread, numbers)) {
      if (spread.outside == Outside::refuse) {
        refuse(spread, "a flight of the search", *left, truncate_instead);
      }
      return std::nullopt;
    }
    take(draw, spread, numbers);
  }
  return draw;
}

std::size_t Drawer::dimensions() const {
  std::size_t all = 0;
  for (const Spread& spread : spreads_) {
    all += spread.dimensions();
  }
  return all;
}

}  // namespace fantail::campaign
