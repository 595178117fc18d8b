// SPDX-License-Identifier: MIT
#include "faults/flown_cell.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include <fmt/core.h>

#include "runs/runner.hpp"
#include "sim/world.hpp"
#include "text/error.hpp"

namespace fantail::faults {
namespace {

using core::Microseconds;

/// The angle that a pulse asks for, by the plan.
std::optional<double> angle_rad(const core::CanardPlan& canard, const std::optional<hal::Pulse>& pulse) {
  if (!pulse) {
    return std::nullopt;
  }
  const double from_centre_us =
      1e-3 * static_cast<double>(pulse->count()) - static_cast<double>(canard.pulse_centre_us);
  return from_centre_us / static_cast<double>(canard.pulse_per_radian_us);
}

void fly(const sim::Scenario& scenario, const std::function<void(const Moment& moment)>& take) {
  sim::World world{scenario};
  core::Phase phase = core::Phase::safe;
  while (!world.over()) {
    const core::TickRecord& record = world.tick();
    const hal::sim::WorldSide& hardware = world.hardware();
    Moment moment{.time_s = 1e-6 * static_cast<double>(world.now().count()) - scenario.pad_time_s,
                  .ticked = !world.is_down(),
                  .true_shaft_rad = world.shafts_rad(),
                  .true_roll_rad = world.truth().roll_angle_rad};
    phase = moment.ticked ? record.phase : phase;
    moment.phase = phase;
    moment.completed = hardware.watchdog_fed == hardware.time;
    for (std::size_t i = 0; i < core::canard_count; ++i) {
      moment.commanded_rad[i] = angle_rad(scenario.plan.canards.each[i], hardware.pulses[i]);
    }
    take(moment);
    world.advance();
  }
}

std::size_t ignition_of(const sim::Scenario& scenario) {
  return static_cast<std::size_t>(std::llround(scenario.pad_time_s * 1e3));
}

/// From the first moment of a phase of the twin to the one after its last; empty phases are empty stretches.
struct Stretch {
  std::size_t begin = 0;
  std::size_t end = 0;
};

Stretch stretch_of(const Twin& twin, Phase phase, std::size_t ignition) {
  const auto first = [&twin](core::Phase wanted) {
    return static_cast<std::size_t>(std::ranges::find(twin.phases, wanted) - twin.phases.begin());
  };
  const std::size_t armed = first(core::Phase::armed);
  const std::size_t finished = first(core::Phase::finished);
  const std::size_t begin = twin.control_begin.value_or(finished);
  const std::size_t end = twin.control_end ? *twin.control_end + 1 : finished;
  switch (phase) {
    case Phase::pad: return {0, armed};
    case Phase::armed: return {armed, ignition};
    case Phase::launched: return {ignition, begin};
    case Phase::controlling: return {begin, end};
    case Phase::after_control: break;
  }
  return {end, twin.phases.size()};
}

Twin fly_twin(sim::Scenario scenario, std::uint64_t seed, const Limits& limits) {
  scenario.seed = seed;
  Twin twin;
  fly(scenario, [&twin](const Moment& moment) { twin.add(moment); });
  if (!twin.control_begin && std::ranges::find(twin.phases, core::Phase::dormant) == twin.phases.end()) {
    throw text::Error{
        text::ErrorKind::bad_configuration,
        fmt::format(
            "{}: with seed {}, control never begins even without a fault, so there is no flight to compare with",
            scenario.name, seed)};
  }
  constexpr FaultTime no_fault{.begin_s = 3600.0, .end_s = 3600.0};
  Judge judge{limits, twin, no_fault, 0.0};
  fly(scenario, [&judge](const Moment& moment) { judge.add(moment); });
  if (const Findings alone = judge.findings(); !alone.breach.empty()) {
    throw text::Error{
        text::ErrorKind::bad_configuration,
        fmt::format("{}: with seed {} and none of the faults, the flight breaks a rule for every flight: {}",
                    scenario.name, seed, alone.what_it_was())};
  }
  return twin;
}

}  // namespace

std::string Cell::name() const { return fmt::format("{}/{}/{}", row->device, row->fault, faults::name(phase)); }

std::string Cell::safe() const {
  return sentence(expected()) + (row->shaft == Shaft::obeys ? "" : "; " + row->shaft_sentence());
}

Cell cell_of(const std::string& name) {
  for (const FaultRow& row : fault_table()) {
    for (std::size_t i = 0; i < phases; ++i) {
      const Cell cell{.row = &row, .phase = static_cast<Phase>(i)};
      if (cell.name() == name) {
        return cell;
      }
    }
  }
  throw text::Error{text::ErrorKind::usage,
                    fmt::format("\"{}\" is not a cell; allowed: DEVICE/FAULT/PHASE as on the page, such as {}", name,
                                Cell{.row = fault_table().data(), .phase = Phase::controlling}.name())};
}

Twins fly_twins(const sim::Scenario& scenario, std::size_t seeds, unsigned threads,
                const std::function<void(std::size_t)>& look) {
  Twins twins{.scenario = scenario, .seeds = {scenario.seed}, .twins = {}, .limits = limits_of(scenario)};
  for (std::size_t i = 1; i < seeds; ++i) {
    twins.seeds.push_back(runs::seed_of_run(scenario.seed, i));
  }
  twins.twins.resize(seeds);
  runs::parallel_for(
      seeds, threads, [&](std::size_t i) { twins.twins[i] = fly_twin(scenario, twins.seeds[i], twins.limits); },
      look ? look : [](std::size_t) {});
  const auto closed = std::ranges::find_if(twins.twins, [](const Twin& twin) { return !twin.control_begin; });
  twins.stay_at_trim =
      std::ranges::none_of(twins.twins, [](const Twin& twin) { return twin.control_begin.has_value(); });
  if (closed != twins.twins.end() && !twins.stay_at_trim) {
    throw text::Error{text::ErrorKind::bad_configuration,
                      fmt::format("{}: the plan's gate stays closed with seed {} and opens with others; allowed: seeds "
                                  "that agree",
                                  scenario.name, twins.seeds[static_cast<std::size_t>(closed - twins.twins.begin())])};
  }
  return twins;
}

int end_of(Phase phase, const Twins& twins) {
  const std::size_t ignition = ignition_of(twins.scenario);
  int end_ms = std::numeric_limits<int>::max();
  for (const Twin& twin : twins.twins) {
    end_ms = std::min(end_ms, static_cast<int>(stretch_of(twin, phase, ignition).end) - static_cast<int>(ignition));
  }
  return end_ms;
}

Grid::Grid(const Twins& twins, Phase phase, int step_ms, int every) {
  const std::size_t ignition = ignition_of(twins.scenario);
  for (std::size_t seed = 0; seed < twins.twins.size(); ++seed) {
    const Stretch stretch = stretch_of(twins.twins[seed], phase, ignition);
    const auto step = static_cast<std::size_t>(step_ms);
    // So that a short phase is not left out: of a few onsets as many as a third of them leave.
    const std::size_t steps = (stretch.end - stretch.begin + step - 1) / step;
    const std::size_t stride = step * std::clamp<std::size_t>(steps / 3, 1, static_cast<std::size_t>(every));
    rows_.push_back({.first = size_,
                     .begin_ms = static_cast<int>(stretch.begin) - static_cast<int>(ignition),
                     .stride_ms = static_cast<int>(stride)});
    size_ += (stretch.end - stretch.begin + stride - 1) / stride;
  }
}

Grid::Run Grid::operator[](std::uint64_t run) const {
  const auto row = std::ranges::upper_bound(rows_, run, {}, &Row::first) - 1;
  return {.seed = static_cast<std::size_t>(row - rows_.begin()),
          .begin_ms = row->begin_ms + static_cast<int>(run - row->first) * row->stride_ms};
}

sim::Scenario scenario_of(const Twins& twins, const Cell& cell, const Grid::Run& run, std::uint64_t number) {
  sim::Scenario scenario = twins.scenario;
  scenario.seed = twins.seeds[run.seed];
  for (const sim::Fault& fault : faults_of(cell.row->recipe, 1e-3 * run.begin_ms, number, scenario)) {
    scenario.faults.push_back(fault);
    scenario.fault_variant += number;
  }
  return scenario;
}

Findings fly_run(const Twins& twins, const Cell& cell, const Grid::Run& run, std::uint64_t number) {
  const sim::Scenario scenario = scenario_of(twins, cell, run, number);
  const double begin_s = 1e-3 * run.begin_ms;
  Judge judge{twins.limits,
              twins.twins[run.seed],
              {.begin_s = begin_s, .end_s = end_of(cell.row->recipe, begin_s), .shafts = shafts_of(*cell.row, number)},
              cell.expected().settle_s};
  fly(scenario, [&judge](const Moment& moment) { judge.add(moment); });
  return judge.findings();
}

}  // namespace fantail::faults
