// SPDX-License-Identifier: MIT
#include "tune/flights.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "campaign/flown_run.hpp"
#include "predict/run.hpp"
#include "protocol/plan_block.hpp"
#include "report/running_figures.hpp"
#include "runs/runner.hpp"

namespace fantail::tune {
namespace {

constexpr double settling_time_s = 1.0;

/// What is wanted of a row under control.
struct Controlled {
  double time_s;
  double reference_rad;
  double roll_angle_rad;  ///< the true one
  double command_rad;
};

/// The rows under control, one by one.
class UnderControl {
 public:
  explicit UnderControl(bool tunnel) : zero_{tunnel} {}
  explicit UnderControl(const flight::Flight& flight) : UnderControl{flight.tunnel} {
    std::ranges::for_each(flight.rows, [this](const flight::Row& row) { add(row); });
  }

  void add(const flight::Row& row) {
    zero_.add(row);
    if (row.phase == core::Phase::controlling) {
      rows_.push_back({row.time_s, row.reference_rad, row.truth->roll_angle_rad, row.command_rad});
    }
  }

  [[nodiscard]] double zero_rad() const { return zero_.rad(); }

  /// Calls `each` with every row, and whether it is settled.
  template <typename Each>
  void for_each(const flight::Clock& clock, Each each) const {
    std::optional<double> settles_at_s;
    double reference_rad = 0.0;
    for (const Controlled& row : rows_) {
      const double time_s = clock(row.time_s);
      if (!settles_at_s || row.reference_rad != reference_rad) {
        settles_at_s = time_s + settling_time_s;
        reference_rad = row.reference_rad;
      }
      each(row, time_s >= *settles_at_s);
    }
  }

 private:
  report::TrueZero zero_;
  std::vector<Controlled> rows_;
};

class Mean {
 public:
  void add(double error_rad) {
    sum_rad_ += error_rad;
    ++count_;
    largest_rad_ = std::max(largest_rad_, error_rad);
  }
  [[nodiscard]] std::optional<RollError> found() const {
    return count_ == 0 ? std::nullopt : std::optional{RollError{sum_rad_ / static_cast<double>(count_), largest_rad_}};
  }

 private:
  double sum_rad_ = 0.0;
  double largest_rad_ = 0.0;
  std::size_t count_ = 0;
};

RollErrors roll_errors(const UnderControl& control, const flight::Clock& clock) {
  Mean settled;
  Mean all;
  control.for_each(clock, [&](const Controlled& row, bool is_settled) {
    const double error_rad = std::abs(row.roll_angle_rad - control.zero_rad() - row.reference_rad);
    all.add(error_rad);
    if (is_settled) {
      settled.add(error_rad);
    }
  });
  return {.settled = settled.found(), .all = all.found()};
}

Flown flown(const sim::Scenario& scenario) {
  UnderControl control{scenario.surroundings != sim::Surroundings::flight};
  const campaign::JudgedFlight judged = campaign::fly_and_judge(
      scenario, [&](const flight::Row& row, const flight::Flight& /*so_far*/) { control.add(row); });
  return {.errors = roll_errors(control, judged.flight.clock),
          .outcome = judged.verdict.outcome,
          .allowed_tilt_end_s = judged.verdict.allowed_tilt_end_s,
          .saturated_share = judged.figures.saturated_fraction.value_or(0.0),
          .extremes = judged.flight.extremes};
}

}  // namespace

RollErrors roll_errors(const flight::Flight& flight) { return roll_errors(UnderControl{flight}, {}); }

std::optional<double> command_noise_rad(const flight::Flight& flight) {
  constexpr std::size_t window = 200;  // rows of a millisecond
  std::vector<double> stretch_rad;
  double squares = 0.0;
  std::size_t count = 0;
  const auto end_stretch = [&] {
    for (std::size_t begin = 0; begin + window <= stretch_rad.size(); begin += window) {
      double sum_rad = 0.0;
      double sum_squares = 0.0;
      for (std::size_t i = begin; i < begin + window; ++i) {
        sum_rad += stretch_rad[i];
        sum_squares += stretch_rad[i] * stretch_rad[i];
      }
      squares += std::max(0.0, sum_squares - sum_rad * sum_rad / window);
      count += window;
    }
    stretch_rad.clear();
  };
  UnderControl{flight}.for_each({}, [&](const Controlled& row, bool is_settled) {
    if (is_settled) {
      stretch_rad.push_back(row.command_rad);
    } else {
      end_stretch();
    }
  });
  end_stretch();
  return count == 0 ? std::nullopt : std::optional{std::sqrt(squares / static_cast<double>(count))};
}

std::vector<Pair> fly_pairs(const sim::Scenario& scenario, const core::FlightPlan& after, const Request& request,
                            const std::function<void(std::size_t)>& look) {
  constexpr std::uint64_t pairs_of_a_part = 4;
  std::vector<Pair> pairs(request.flights);
  const auto fly_pair = [&](std::uint64_t i) {
    Pair pair{.seed = runs::seed_of_run(scenario.seed, i)};
    sim::Scenario rocket = drawn(scenario, request.spread, pair.seed);
    pair.damping_m2 = rocket.vehicle.roll_plant.damping_m2;
    pair.torque_m = rocket.vehicle.roll_plant.torque_m;
    pair.before = flown(rocket);
    rocket.plan = after;
    pair.after = flown(rocket);
    return pair;
  };
  const std::string name = fmt::format("pairs.{:08x}.", protocol::plan_crc(after));
  runs::run(runs::rows_into<Pair>(pairs, pairs_of_a_part, name, fly_pair), request.kept, request.threads, look);
  return pairs;
}

std::vector<Sum> fly_each(const sim::Scenario& scenario, const std::vector<core::FlightPlan>& plans,
                          const Request& request, const std::function<void(std::size_t)>& look) {
  std::vector<Pair> rockets(plans.size() * request.flights);
  const auto fly_one = [&](std::uint64_t i) {
    sim::Scenario rocket = drawn(scenario, request.spread, runs::seed_of_run(scenario.seed, i % request.flights));
    rocket.plan = plans[i / request.flights];
    return Pair{.after = flown(rocket)};
  };
  runs::Flights flights = runs::rows_into<Pair>(rockets, request.flights, "", fly_one);
  for (std::size_t i = 0; i < plans.size(); ++i) {
    flights.parts[i].name = fmt::format("choice.{:08x}", protocol::plan_crc(plans[i]));
  }
  runs::run(flights, request.kept, request.threads, look);
  std::vector<Sum> sums;
  for (std::size_t i = 0; i < plans.size(); ++i) {
    const auto own = rockets.begin() + static_cast<std::ptrdiff_t>(i * request.flights);
    sums.push_back(sum({own, own + static_cast<std::ptrdiff_t>(request.flights)}, &Pair::after));
  }
  return sums;
}

std::optional<RollError> compared(const Flown& flown) {
  return flown.errors.settled ? flown.errors.settled : flown.errors.all;
}

Sum sum(const std::vector<Pair>& pairs, Flown Pair::* of) {
  Sum all{.flights = pairs.size(), .is_settled = true};
  Mean means;
  bool all_known = true;
  for (const Pair& pair : pairs) {
    const Flown& flown = pair.*of;
    all.tilt_ends.add(flown.outcome == report::Outcome::held ? flown.allowed_tilt_end_s : std::nullopt);
    all.held += flown.outcome == report::Outcome::held ? 1 : 0;
    all.steady += report::is_steady(flown.outcome) ? 1 : 0;
    all.off_command += flown.outcome == report::Outcome::off_command ? 1 : 0;
    all.outside_model += flown.outcome == report::Outcome::outside_model ? 1 : 0;
    all.extremes = flight::worst_of({all.extremes, flown.extremes});
    all.not_judged += flown.outcome == report::Outcome::not_judged ? 1 : 0;
    all.is_settled = all.is_settled && flown.errors.settled;
    if (const auto error = compared(flown)) {
      means.add(error->mean_rad);
      all.largest_rad = std::max(all.largest_rad.value_or(0.0), error->largest_rad);
    } else {
      all_known = false;
    }
  }
  all.mean_rad = all_known && means.found() ? std::optional{means.found()->mean_rad} : std::nullopt;
  return all;
}

}  // namespace fantail::tune
