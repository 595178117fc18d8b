// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/flight_plan_members.hpp"
#include "core/inputs.hpp"
#include "core/tick_record.hpp"
#include "flight_log/flight_log.hpp"
#include "input/document.hpp"

namespace fantail::flight_log {

/// The first place where a replay does not give what was recorded.
struct Difference {
  std::size_t tick = 0;  ///< index in Flight::ticks
  std::string field{};   ///< as in the schema; "digest" when only a signal differs that the log leaves out
  std::string recorded{};
  std::string replayed{};
};

struct Regeneration {
  /// As many as Flight::ticks; empty where no checkpoint leads to the tick without a gap.
  std::vector<std::optional<core::TickRecord>> records;
  std::size_t compared = 0;
  std::size_t unreachable = 0;
  std::optional<Difference> first_difference;
  std::size_t differing = 0;  ///< ticks
  std::string obstacle;       ///< a sentence when nothing could be replayed: no header, another law, no checkpoint

  /// Every tick that is there was replayed and gave what was recorded.
  [[nodiscard]] bool complete_and_equal() const { return compared > 0 && unreachable == 0 && differing == 0; }
};

/// Where the canards stood; empty where an encoder had nothing to say, and all of them without the plan, which has the
/// encoders' zeros.
[[nodiscard]] core::EncoderAngles encoders_of(const Flight& flight, const protocol::LogTick& tick);

/// What went into the flight law at a tick of a flight, whose canards are those of the plan.
[[nodiscard]] core::Inputs inputs_of(const Flight& flight, const protocol::LogTick& tick,
                                     const core::CanardsPlan& canards);

/// What the checkpoints of this program's flight law by this plan are known by.
[[nodiscard]] std::uint32_t state_layout(const core::FlightPlan& plan = core::default_plan());

/// Runs the recorded inputs through the flight law, from every checkpoint that follows a gap on, and compares each tick
/// with what was recorded, byte for byte. `plan` is flight.plan, or a changed one: then the inputs are still those of
/// the flight that was flown (open loop), and the differences are what the change would have done to the commands.
[[nodiscard]] Regeneration regenerate(const Flight& flight, const core::FlightPlan& plan);

/// The plan of a flight with some values changed, for a replay that a person has asked for. Throws text::Error:
/// bad_data when `log`, as the person calls it, holds no plan that can be used; for a change that a replay cannot show;
/// bad_configuration as changed_plan() does.
[[nodiscard]] core::FlightPlan plan_for_replay(const Flight& flight, const std::string& log,
                                               std::span<const input::Override> changes);

/// regenerate(), for which nothing stands in the way. Throws text::Error (bad_data) that says what does.
[[nodiscard]] Regeneration replay(const Flight& flight, const std::string& log, const core::FlightPlan& plan);

}  // namespace fantail::flight_log
