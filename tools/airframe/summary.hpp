// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "airframe/model/build_up.hpp"
#include "result/document.hpp"
#include "sim/vehicle.hpp"

namespace fantail::airframe {

/// Less than this is called marginal: the usual rule of thumb.
inline constexpr double least_margin_calibres = 1.0;

/// Doubtful: it would be stable or marginal, but by numbers that the design's file contradicts, that contradict each
/// other or that lack parts.
enum class Stability : std::uint8_t { stable, marginal, unstable, unknown, doubtful };

/// One number of a vehicle: as computed from its shape and parts, and as its file has it.
struct Line {
  std::string what;
  std::string unit;
  std::optional<model::Estimate> computed{};  ///< without a range where low and high are the value
  std::optional<double> in_file{};
  int decimals = 3;
};

/// What `fantail airframe` says of a vehicle that has a shape.
struct Summary {
  model::BuildUp build_up;
  std::vector<Line> lines;
  Stability stability = Stability::unknown;
  std::string sentence;               ///< of the static margin, and of the comparison
  std::vector<std::string> doubts{};  ///< what makes it doubtful, a clause each
  /// Whether mass and both centres are those that the design's file has stored; empty: not read from a design.
  std::optional<bool> agrees_with_design{};
  std::vector<std::string> remarks;           ///< doubts and contradictions, a sentence each
  std::optional<double> centre_of_gravity_m;  ///< at lift-off: the file's, else that of the parts
};

/// "4.46 to 17.83"; where one end is infinite "4.46 or more" or "-4.46 or less".
[[nodiscard]] std::string range_text(const model::Estimate& estimate, int decimals);

[[nodiscard]] Summary summarize(const sim::Vehicle& vehicle);

/// Holds a vehicle that was read from a design file against what that file has stored of it. The sentence of a summary
/// that has been judged then says where they differ by more than 2 % of mass or 0.2 calibres, what was left out of the
/// design, or that there was nothing to compare with. Another vehicle's summary stays as it is.
void compare_with_design(Summary& summary, const sim::Vehicle& vehicle);

/// Holds what the file says twice against each other: sizes in [shape] and [airframe]; mass, balance and inertias by
/// the parts and in [body] and [airframe]. Looks for its balance at lift-off, too. The sentence of a summary that has
/// been judged then says what differs by more than its tolerance, and whether that balance is unknown.
void doubt_own_numbers(Summary& summary, const sim::Vehicle& vehicle);

/// Puts a reason, a sentence, in front of the verdict, which is doubtful from then on.
void doubt(Summary& summary, const std::string& why);

/// "the parts in [masses] weigh 3.764 kg, but ..."; empty: they weigh what the vehicle does, or are not known.
[[nodiscard]] std::string parts_off_mass(const model::BuildUp& computed, const sim::Vehicle& vehicle);

/// Is it stable? Undecided where it is marginal, doubtful or not compared with the design that it was read from.
[[nodiscard]] result::Document answer(const sim::Vehicle& vehicle, const Summary& summary, const result::Made& made);
/// Every figure in its JSON, for the manual.
[[nodiscard]] std::vector<result::Listed> listed_fields();

/// The static margin while the motor burns, with the limits of the verdict; or why it is not shown.
[[nodiscard]] std::vector<result::Block> margin_over_time(const sim::Vehicle& vehicle, const Summary& summary);

/// The rocket from the side, nose to the left, to scale, with its centres of gravity and pressure: an SVG that takes
/// its colours from the page.
[[nodiscard]] std::string side_view(const sim::Geometry& shape, const Summary& summary, double width);

}  // namespace fantail::airframe
