// SPDX-License-Identifier: MIT
#include "rare/study.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <iterator>
#include <map>
#include <memory>
#include <mutex>
#include <numbers>
#include <numeric>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "campaign/draw.hpp"
#include "campaign/flown_run.hpp"
#include "distributions/quantiles.hpp"
#include "distributions/shares.hpp"
#include "input/scenario_file.hpp"
#include "rare/margin.hpp"
#include "runs/runner.hpp"
#include "sim/random.hpp"
#include "text/error.hpp"

namespace fantail::rare {
namespace {

constexpr std::size_t worst_shown = 3;
constexpr std::size_t samples_of_a_part = 40;
constexpr std::size_t chains_of_a_part = 4;  // each of ten flights
constexpr std::size_t flights_for_modes = 200;
constexpr std::size_t fewest_of_mode = 5;  // the mean of fewer says little
constexpr std::uint64_t stream_of_laws = 5'000;

/// All that a search asks of the files.
struct Task {
  const Options& options;
  input::ScenarioFiles files;
  std::vector<campaign::Spread> spreads;
  campaign::Drawer drawer;

  explicit Task(const Options& asked)
      : options{asked},
        files{campaign::files_of(asked.campaign)},
        spreads{campaign::spreads_of(asked.campaign, files)},
        drawer{campaign::drawer_of(asked.campaign, spreads)} {}

  struct Flown {
    campaign::FlownRun run{};
    double margin = 0.0;
  };
  /// `own`: of this thread; they are left with what was drawn. Empty where the laws exclude it.
  [[nodiscard]] std::optional<Flown> fly(input::ScenarioFiles& own, const Point& point) const {
    auto draw = drawer.draw_at(point.normals);
    if (!draw) {
      return std::nullopt;
    }
    double far = failed_by_an_event;  // where the files refuse what was drawn together
    campaign::FlownRun run = campaign::fly_drawn(
        own, *std::move(draw), point.seed,
        [&](const sim::Scenario& scenario, const campaign::FlownRun& flown, const campaign::JudgedFlight& judged) {
          far = margin(options.question, scenario, flown, judged);
        });
    return Flown{.run = std::move(run), .margin = far};
  }
};

/// Of threads that each change their own: reading them takes a tenth of a flight.
class Files {
 public:
  explicit Files(const Options& options) : options_{options} {}

  [[nodiscard]] std::shared_ptr<input::ScenarioFiles> take() {
    {
      const std::lock_guard lock{mutex_};
      if (!idle_.empty()) {
        auto files = std::move(idle_.back());
        idle_.pop_back();
        return files;
      }
    }
    return std::make_shared<input::ScenarioFiles>(campaign::files_of(options_.campaign));
  }
  void give_back(std::shared_ptr<input::ScenarioFiles> files) {
    const std::lock_guard lock{mutex_};
    idle_.push_back(std::move(files));
  }

 private:
  const Options& options_;
  std::mutex mutex_;
  std::vector<std::shared_ptr<input::ScenarioFiles>> idle_;
};

/// Mean and standard deviation of each drawn number, whatever its law.
struct Laws {
  std::vector<double> means{};
  std::vector<double> deviations{};

  explicit Laws(const Task& task) {
    constexpr int draws = 20'000;
    std::vector<double> squares;
    int drawn = 0;
    sim::Random random{task.options.campaign.seed, stream_of_laws};
    std::vector<double> normals(task.drawer.dimensions());
    for (int i = 0; i < draws; ++i) {
      std::ranges::generate(normals, [&] { return random.gaussian(); });
      const auto draw = task.drawer.draw_at(normals);
      if (!draw) {
        continue;
      }
      means.resize(draw->numbers.size());
      squares.resize(draw->numbers.size());
      drawn += 1;
      for (std::size_t k = 0; k < means.size(); ++k) {
        const double from_mean = draw->numbers[k] - means[k];
        means[k] += from_mean / drawn;
        squares[k] += from_mean * (draw->numbers[k] - means[k]);
      }
    }
    for (const double square : squares) {
      deviations.push_back(std::sqrt(square / std::max(drawn - 1, 1)));
    }
  }

  [[nodiscard]] std::vector<double> sigmas(const std::vector<double>& numbers) const {
    std::vector<double> all(numbers.size(), 0.0);
    for (std::size_t k = 0; k < numbers.size(); ++k) {
      all[k] = deviations[k] > 0.0 ? (numbers[k] - means[k]) / deviations[k] : 0.0;
    }
    return all;
  }
};

double distance(const Sample& sample) {
  return std::inner_product(sample.point.normals.begin(), sample.point.normals.end(), sample.point.normals.begin(),
                            0.0);
}

Found found_at(const Task& task, const Laws& laws, const Sample& sample) {
  const auto draw = task.drawer.draw_at(sample.point.normals);
  Found found{.point = sample.point, .sigmas = laws.sigmas(draw->numbers), .margin = sample.margin};
  for (const input::Override& change : draw->changes) {
    found.changes.push_back(campaign::lines_of({change}));
  }
  return found;
}

std::vector<Quantity> quantities_of(const Task& task, const std::vector<std::vector<double>>& sigmas) {
  std::vector<Quantity> all;
  for (std::string& name : campaign::quantity_names(task.spreads)) {
    const std::size_t k = all.size();
    const auto count = static_cast<double>(sigmas.size());
    double sum = 0.0;
    double squares = 0.0;
    for (const std::vector<double>& one : sigmas) {
      sum += one[k];
      squares += one[k] * one[k];
    }
    const double mean = sum / count;
    all.push_back({.name = std::move(name),
                   .mean_sigmas = mean,
                   .deviation_sigmas = std::sqrt(std::max(0.0, squares / count - mean * mean))});
  }
  std::ranges::stable_sort(all, std::ranges::greater{}, [](const Quantity& q) {
    return std::max(std::abs(q.mean_sigmas), q.far_sigmas() - 1.0);  // moved to one side, or to either
  });
  return all;
}

/// By what the failed flights fail: of a part of them, evenly over their margins, each flown again.
std::vector<Mode> modes_of(const Task& task, const Laws& laws, const std::vector<Sample>& failing,
                           const std::function<void()>& look) {
  const std::size_t step = 1 + (failing.size() - 1) / flights_for_modes;
  std::map<std::string, std::vector<std::vector<double>>> by_criterion;
  input::ScenarioFiles own = campaign::files_of(task.options.campaign);
  double flown = 0.0;
  for (std::size_t i = 0; i < failing.size(); i += step) {
    look();
    const auto again = task.fly(own, failing[i].point);
    const auto& failed_by = again->run.failed_by;
    const bool is_of_figure = task.options.question.relation != campaign::Relation::is || failed_by.empty();
    by_criterion[is_of_figure ? task.options.question.text() : failed_by.front()].push_back(
        laws.sigmas(again->run.numbers));
    flown += 1.0;
  }
  std::vector<Mode> modes;
  for (const auto& [criterion, sigmas] : by_criterion) {
    modes.push_back(
        {.criterion = criterion,
         .share = static_cast<double>(sigmas.size()) / flown,
         .quantities = sigmas.size() < fewest_of_mode ? std::vector<Quantity>{} : quantities_of(task, sigmas)});
  }
  std::ranges::stable_sort(modes, std::ranges::greater{}, &Mode::share);
  return modes;
}

double upper_tail(double normal) { return 0.5 * std::erfc(normal / std::numbers::sqrt2); }

/// The standard normal number that is as rare as this one is with five degrees of freedom, both of variance 1.
double as_rare_with_student_5(double number) {
  const double t = std::abs(number) * std::sqrt(5.0 / 3.0);
  const double share = 1.0 / (1.0 + t * t / 5.0);
  const double from_middle =
      (std::atan(t / std::sqrt(5.0)) + t / std::sqrt(5.0) * share * (1.0 + 2.0 / 3.0 * share)) / std::numbers::pi;
  const double normal = -distributions::normal_quantile(std::max(0.5 - from_middle, 1e-300));
  return number < 0.0 ? -normal : normal;
}

/// Of the half space of this probability that lies where the failures are; empty: they lie in no one direction, or no
/// number is normal.
std::optional<double> heavier_tails(const Task& task, const Estimate& estimate) {
  std::vector<double> mean(task.drawer.dimensions(), 0.0);
  for (const Sample& sample : estimate.failing) {
    for (std::size_t i = 0; i < mean.size(); ++i) {
      mean[i] += sample.point.normals[i] / static_cast<double>(estimate.failing.size());
    }
  }
  const double length = std::sqrt(std::inner_product(mean.begin(), mean.end(), mean.begin(), 0.0));
  const double reach = -distributions::normal_quantile(estimate.probability);
  bool any = false;
  double squares = 0.0;
  std::size_t dimension = 0;
  for (const campaign::Spread& spread : task.spreads) {
    for (std::size_t i = 0; i < spread.dimensions(); ++i, ++dimension) {
      double number = reach * mean[dimension] / length;
      if (spread.law == campaign::Law::normal) {
        number = as_rare_with_student_5(number);
        any = true;
      }
      squares += number * number;
    }
  }
  // Where failures lie on all sides, or by chance alone, their mean is near the middle.
  return any && length > 0.7 * reach ? std::optional{upper_tail(std::sqrt(squares))} : std::nullopt;
}

}  // namespace

Study search(const Options& options, const std::function<void(std::uint64_t)>& look) {
  if (const std::string objection = objection_to(options.question); !objection.empty()) {
    throw text::Error{text::ErrorKind::usage, objection};
  }
  const Task task{options};
  const sim::Scenario middle = task.files.read();
  std::atomic<std::uint64_t> flown{0};
  const MakeAll make_all = [&](std::size_t batch, std::size_t count, const std::function<Chain(std::size_t)>& make) {
    std::vector<Chain> chains(count);
    const runs::Flights flights = runs::rows_into<Chain>(
        chains, batch == 0 ? samples_of_a_part : chains_of_a_part, fmt::format("batch_{:02}_", batch),
        [&](std::uint64_t chain) { return make(static_cast<std::size_t>(chain)); });
    (void)runs::run(flights, options.kept, options.threads, [&](std::uint64_t /*done*/) { look(flown); });
    if (std::ranges::any_of(chains, [](const Chain& chain) { return chain.samples.empty(); })) {
      throw text::Error{text::ErrorKind::bad_configuration,
                        middle.name +
                            ": a thousand draws in a row were outside what their fields allow: so is nearly all "
                            "of a law with outside = \"truncate\""};
    }
    return chains;
  };
  const Settings settings{.master_seed = options.campaign.seed,
                          .dimensions = task.drawer.dimensions(),
                          .samples_a_level = options.flights_a_level};
  Files files{options};
  const Margin margin = [&](const Point& point) {
    const auto own = files.take();
    const auto found = task.fly(*own, point);
    files.give_back(own);
    flown += found ? 1 : 0;
    return found ? std::optional{found->margin} : std::nullopt;
  };
  Study study{.scenario = middle.name,
              .vehicle = middle.vehicle.name,
              .plan = middle.plan_name,
              .options = options,
              .estimate = estimate(settings, margin, make_all)};
  for (const campaign::Spread& spread : task.spreads) {
    if (spread.law == campaign::Law::rows) {
      std::ranges::transform(spread.fields, std::back_inserter(study.discrete),
                             [](const input::NumberField& field) { return field.name(); });
    }
  }
  const auto events = static_cast<std::uint64_t>(std::ranges::count(study.estimate.plain_margins, failed_by_an_event));
  if (events == 0) {
    study.events_unseen = distributions::upper_bound_95(0, study.estimate.plain_margins.size());
  }
  const std::vector<Sample>& failing = study.estimate.failing;
  if (failing.empty()) {
    return study;
  }
  const Laws laws{task};
  study.likeliest = found_at(task, laws, *std::ranges::min_element(failing, {}, distance));
  for (std::size_t i = 0; i < failing.size() && study.worst.size() < worst_shown; ++i) {
    if (i == 0 || failing[i].point.normals != failing[i - 1].point.normals) {  // a move that was refused stays
      study.worst.push_back(found_at(task, laws, failing[i]));
    }
  }
  study.modes = modes_of(task, laws, failing, [&] { look(flown); });
  study.events_share = static_cast<double>(std::ranges::count(failing, failed_by_an_event, &Sample::margin)) /
                       static_cast<double>(failing.size());
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
    input::ScenarioFiles own = campaign::files_of(study.options.campaign);
    const auto flown = task.fly(own, found.point);
    if (!flown || flown->margin != found.margin) {
      throw std::logic_error{"a flight of the search is another one when it is flown again"};
    }
    found.outcome = flown->run.outcome;
    if (found.outcome == "refused") {
      return;
    }
    sim::Scenario scenario = own.read();
    scenario.seed = found.point.seed;
    scenario.changed_values = whole.size() + found.changes.size();
    std::vector<std::string> changes = whole;
    changes.insert(changes.end(), found.changes.begin(), found.changes.end());
    campaign::write_flight(scenario, std::move(changes), note, folder / name);
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
