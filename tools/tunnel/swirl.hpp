// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "logs/roll_log.hpp"
#include "result/document.hpp"
#include "tunnel/statistics.hpp"
#include "tunnel/steady.hpp"
#include "tunnel/tunnel_log.hpp"

namespace fantail::tunnel {

/// A rocket that rolled freely while the fan went through its set points.
struct RollSession {
  logs::RollLog roll;
  TunnelLog wind;
  SteadySegments steady;  ///< of the wind
};

/// Damping and torque constant of the rocket that rolled. An offset depends on their ratio, and so on no area.
struct OwnRoll {
  double alpha_m2 = 0.0;
  double beta_m = 0.0;
  std::string source;  ///< whose numbers these are, a clause for the result: "as given"
};

/// Of Tasha III, which the shipped vehicle tasha3_tunnel is made like, and of no other rocket.
[[nodiscard]] OwnRoll published_roll();

struct SwirlOptions {
  OwnRoll roll;
  double from_speed_m_s = 20.0;  ///< the swirl is the mean difference from here on
};

/// One set point of one session.
struct OffsetPoint {
  SteadySegment segment{};
  KnownMean speed_m_s{};
  KnownMean rate_rad_s{};
  double canard_rad = 0.0;  ///< where the canards really stood; zero for a log that does not say
  double offset_rad = 0.0;  ///< equivalent fin offset (Eq 27), without what the canards did
  double standard_error_rad = 0.0;
};

/// Both sessions at one speed.
struct OffsetDifference {
  double speed_m_s = 0.0;
  double without_rad = 0.0;
  double with_rad = 0.0;
  double difference_rad = 0.0;  ///< without minus with: what the swirl adds
  double standard_error_rad = 0.0;
  bool counted = false;  ///< fast enough for the mean
};

/// The mean difference.
struct SwirlOffset {
  double offset_rad = 0.0;
  double standard_error_rad = 0.0;        ///< of the points, or of their scatter over speed where that is larger
  std::optional<double> deviation_rad{};  ///< standard deviation over the speeds; empty for a single one
  std::size_t speeds = 0;
};

struct Swirl {
  SwirlOptions options{};
  std::vector<OffsetPoint> without{};
  std::vector<OffsetPoint> with{};
  std::vector<OffsetDifference> differences{};
  std::optional<SwirlOffset> swirl{};  ///< empty when the sessions share no speed that is fast enough
  std::vector<std::string> remarks{};
};

/// Throws text::Error (bad_data) when no set point of a session became steady, when the roll log has no samples in
/// one, or when the air stood still.
[[nodiscard]] Swirl examine_swirl(const RollSession& without, const RollSession& with, const SwirlOptions& options);

struct SwirlSessions {
  RollSession without;  ///< flow straightener
  RollSession with;
};

/// What `fantail tunnel swirl` says: nothing was asked; undecided where the swirl is unknown.
[[nodiscard]] result::Document swirl_answer(const SwirlSessions& sessions, const Swirl& swirl,
                                            const result::Made& made);
/// Every figure in its JSON, for the manual.
[[nodiscard]] std::vector<result::Listed> listed_swirl_fields();

}  // namespace fantail::tunnel
