// SPDX-License-Identifier: MIT
#include "rare/study.hpp"

#include <algorithm>
#include <atomic>
#include <iterator>
#include <numeric>
#include <stdexcept>
#include <utility>

#include <fmt/core.h>

#include "rare/margin.hpp"
#include "rare/modes.hpp"
#include "rare/task.hpp"
#include "runs/runner.hpp"
#include "text/error.hpp"

namespace fantail::rare {
namespace {

constexpr std::size_t worst_shown = 3;
constexpr std::size_t flights_of_yardstick = 100;
constexpr std::size_t samples_of_a_part = 40;
constexpr std::size_t chains_of_a_part = 4;  // each of ten flights

double distance(const Sample& sample) {
  const std::vector<double>& normals = sample.point.normals;
  return std::inner_product(normals.begin(), normals.end(), normals.begin(), 0.0);
}

Found found_at(const Task& task, const Sample& sample) {
  Found found{.point = sample.point, .margin = sample.margin};
  for (const input::Override& change : task.draw_at(sample.point).changes) {
    found.changes.push_back(campaign::lines_of({change}));
  }
  return found;
}

/// Flown first, on as many threads as all others.
Yardstick yardstick_of(const Task& task, const Settings& settings, const std::function<void()>& look) {
  std::vector<Left> plain(flights_of_yardstick);
  const runs::Flights flights =
      runs::rows_into<Left>(plain, samples_of_a_part, "yardstick_", [&](std::uint64_t number) {
        const auto flown = task.fly(plain_point(settings, static_cast<std::size_t>(number)));
        return flown ? flown->left : Left{};
      });
  (void)runs::run(flights, task.options.kept, task.options.threads, [&](std::uint64_t /*done*/) { look(); });
  return {task.options.question, plain};
}

}  // namespace

Study search(const Options& options, const std::function<void(std::uint64_t)>& look) {
  if (const std::string objection = objection_to(options.question); !objection.empty()) {
    throw text::Error{text::ErrorKind::usage, objection};
  }
  const Task task{options};
  std::atomic<std::uint64_t> flown{0};
  const Settings settings{.master_seed = options.campaign.seed,
                          .dimensions = task.drawer.dimensions(),
                          .samples_a_level = options.flights_a_level};
  const Yardstick yardstick = yardstick_of(task, settings, [&] { look(++flown); });
  const MakeAll make_all = [&](std::size_t batch, std::size_t count, const std::function<Chain(std::size_t)>& make) {
    std::vector<Chain> chains(count);
    const runs::Flights flights = runs::rows_into<Chain>(
        chains, batch == 0 ? samples_of_a_part : chains_of_a_part, fmt::format("batch_{:02}_", batch),
        [&](std::uint64_t chain) { return make(static_cast<std::size_t>(chain)); });
    (void)runs::run(flights, options.kept, options.threads, [&](std::uint64_t /*done*/) { look(flown); });
    if (std::ranges::any_of(chains, [](const Chain& chain) { return chain.samples.empty(); })) {
      throw text::Error{text::ErrorKind::bad_configuration,
                        task.middle.name +
                            ": a thousand draws in a row were outside what their fields allow: so is nearly all "
                            "of a law with outside = \"truncate\""};
    }
    return chains;
  };
  const Margin margin = [&](const Point& point) {
    const auto found = task.fly(point);
    flown += found ? 1 : 0;
    return found ? std::optional{yardstick.margin(found->left, found->is_failed)} : std::nullopt;
  };
  Study study{.scenario = task.middle.name,
              .vehicle = task.middle.vehicle.name,
              .plan = task.middle.plan_name,
              .options = options,
              .estimate = estimate(settings, margin, make_all)};
  for (const campaign::Spread& spread : task.spreads) {
    if (spread.law == campaign::Law::rows) {
      std::ranges::transform(spread.fields, std::back_inserter(study.discrete),
                             [](const input::NumberField& field) { return field.name(); });
    }
  }
  study.events = static_cast<std::uint64_t>(std::ranges::count(study.estimate.plain_margins, failed_by_an_event));
  if (study.estimate.nearest) {
    const auto nearest = task.fly(study.estimate.nearest->point);
    const auto which = yardstick.nearest(nearest->left);
    study.led_to = which && options.question.relation == campaign::Relation::is
                       ? std::optional{std::string{followed[*which]}}
                       : std::nullopt;
  }
  const std::vector<Sample>& failing = study.estimate.failing;
  if (failing.empty() || study.estimate.end == End::always_fails) {
    return study;
  }
  study.likeliest = found_at(task, *std::ranges::min_element(failing, {}, distance));
  for (std::size_t i = 0; i < failing.size() && study.worst.size() < worst_shown; ++i) {
    if (i == 0 || failing[i].point.normals != failing[i - 1].point.normals) {  // a move that was refused stays
      study.worst.push_back(found_at(task, failing[i]));
    }
  }
  study.modes = modes_of(task, failing, [&] { look(flown); });
  if (study.estimate.end == End::found && study.estimate.levels.size() > 1) {
    study.with_heavier_tails = heavier_tails(task, study.estimate);
  }
  return study;
}

void fly_again(Study& study, const std::filesystem::path& folder, const std::function<void()>& look) {
  const Task task{study.options};
  std::vector<std::string> whole;
  for (const input::Override& change : study.options.campaign.changes) {
    whole.push_back(campaign::lines_of({change}));
  }
  const auto again = [&](Found& found, const std::string& name, const std::string& note) {
    look();
    std::optional<sim::Scenario> scenario;  // empty: the files refuse what was drawn together
    const auto flown =
        task.fly(found.point, [&](const sim::Scenario& as_flown, const auto&, const auto&) { scenario = as_flown; });
    if (!flown || !flown->is_failed) {
      throw std::logic_error{"a flight of the search is another one when it is flown again"};
    }
    found.outcome = flown->run.outcome;
    if (!scenario) {
      return;
    }
    scenario->changed_values = whole.size() + found.changes.size();
    std::vector<std::string> changes = whole;
    changes.insert(changes.end(), found.changes.begin(), found.changes.end());
    campaign::write_flight(*scenario, std::move(changes), note, folder / name);
    found.folder = name;
  };
  if (study.likeliest) {
    again(
        *study.likeliest, "likeliest",
        "A search for rare failures found this flight. No failed flight is nearer to the mean of all that was drawn.");
  }
  for (std::size_t i = 0; i < study.worst.size(); ++i) {
    again(study.worst[i], fmt::format("worst_{}", i + 1),
          "A search for rare failures found this flight, one of its worst.");
  }
}

}  // namespace fantail::rare
