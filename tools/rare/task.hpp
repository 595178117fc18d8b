// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "campaign/draw.hpp"
#include "campaign/flown_run.hpp"
#include "input/scenario_file.hpp"
#include "rare/margin.hpp"
#include "rare/study.hpp"

namespace fantail::rare {

/// What a search flies: a point becomes a flight, and what is left to its limits. The options outlive it.
class Task {
 public:
  /// Throws text::Error for files without spread, or that do not fly.
  explicit Task(const Options& options);

  struct Flown {
    campaign::FlownRun run{};
    Left left{};
    bool is_failed = false;
  };
  /// From any thread. Empty where the laws exclude the point. `look` as campaign::fly_drawn() calls it. Throws
  /// text::Error where a field refuses the point.
  [[nodiscard]] std::optional<Flown> fly(const Point& point, const campaign::LookAtFlight& look = {}) const;

  /// What is drawn there, which the laws must not exclude.
  [[nodiscard]] campaign::Draw draw_at(const Point& point) const { return *drawer.draw_at(point.normals); }

  const Options& options;
  const std::vector<campaign::Spread> spreads;
  const campaign::Drawer drawer;
  const sim::Scenario middle;  ///< without a draw

 private:
  Task(const Options& options, const input::ScenarioFiles& files);

  /// Every flight changes the files: each thread has its own, which none reads anew.
  mutable std::mutex mutex_;
  mutable std::vector<std::unique_ptr<input::ScenarioFiles>> idle_;
};

}  // namespace fantail::rare
