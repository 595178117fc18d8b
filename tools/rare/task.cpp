// SPDX-License-Identifier: MIT
#include "rare/task.hpp"

#include <utility>

namespace fantail::rare {

Task::Task(const Options& asked) : Task{asked, campaign::files_of(asked.campaign)} {}

Task::Task(const Options& asked, const input::ScenarioFiles& files)
    : options{asked},
      spreads{campaign::spreads_of(asked.campaign, files)},
      drawer{campaign::drawer_of(asked.campaign, spreads)},
      middle{files.read()} {}

std::optional<Task::Flown> Task::fly(const Point& point, const campaign::LookAtFlight& look) const {
  auto draw = drawer.draw_at(point.normals);
  if (!draw) {
    return std::nullopt;
  }
  std::unique_ptr<input::ScenarioFiles> files;
  if (const std::lock_guard lock{mutex_}; !idle_.empty()) {
    files = std::move(idle_.back());
    idle_.pop_back();
  }
  if (!files) {
    files = std::make_unique<input::ScenarioFiles>(campaign::files_of(options.campaign));
  }
  Flown flown;
  flown.run = campaign::fly_drawn(
      *files, *std::move(draw), point.seed,
      [&](const sim::Scenario& scenario, const campaign::FlownRun& run, const campaign::JudgedFlight& judged) {
        flown.left = left_of(options.question, scenario, run, judged);
        if (look) {
          look(scenario, run, judged);
        }
      });
  flown.is_failed = options.question.is_failed_by(flown.run);
  const std::lock_guard lock{mutex_};
  idle_.push_back(std::move(files));
  return flown;
}

}  // namespace fantail::rare
