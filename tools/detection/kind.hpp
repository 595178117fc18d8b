// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace fantail::detection {

/// What happens to an armed rocket. The order is that of their seeds, so a new kind comes last.
enum class Kind : std::uint8_t {
  handling,
  drop,
  transport,
  shaking,
  chuff,
  misfire,
  neighbour,
  gust,
  vibration,
  bias,
  tilt,
  launch,
  launch_at_2_g,
  launch_one_bad,
  raised_rail,
  missed_flight,
  uncontrolled_flight,
  stirred_launch,
};
inline constexpr std::size_t kinds = 18;

[[nodiscard]] constexpr std::size_t index(Kind kind) { return static_cast<std::size_t>(kind); }
[[nodiscard]] constexpr bool is_launch(Kind kind) {
  return (kind >= Kind::launch && kind <= Kind::raised_rail) || kind == Kind::stirred_launch;
}
/// A whole flight, from the pad to the hands that carry the rocket home. It counts for those rules that did not control
/// it, and then only what comes after it.
[[nodiscard]] constexpr bool is_flight(Kind kind) {
  return kind == Kind::missed_flight || kind == Kind::uncontrolled_flight;
}

/// What a model draws, and how much that is worth.
struct KindInfo {
  std::string_view name;      ///< on the command line
  std::string_view what;      ///< happens, with the ranges that are drawn
  std::string_view source;    ///< of the ranges
  std::string_view weakness;  ///< what it leaves out or only assumes
};
extern const std::array<KindInfo, kinds> kind_table;

[[nodiscard]] inline const KindInfo& info(Kind kind) { return kind_table[index(kind)]; }
/// By its name; empty for another.
[[nodiscard]] std::optional<Kind> kind_of(std::string_view name);

/// How the two accelerometers are. At most one is not well, either with the same probability.
enum class Condition : std::uint8_t {
  well,
  dead,       ///< from a moment on it delivers nothing
  frozen,     ///< from a moment on it repeats its last sample, until the board's watch over its counts notices
  stuck,      ///< from a moment on it stands where it is, except for its noise, so that no watch notices
  saturated,  ///< from a moment on it stands at the positive end of its range
};
inline constexpr std::size_t conditions = 5;
inline constexpr std::array<std::string_view, conditions> condition_names{"well", "one dead", "one frozen", "one stuck",
                                                                          "one saturated"};

/// Follows from the number, so that any number of events has its share of each: every second one has both well; no
/// launch with one bad has, and all other launches have.
[[nodiscard]] constexpr Condition condition_of(Kind kind, std::uint64_t event) {
  if (is_launch(kind) && kind != Kind::launch_one_bad) {
    return Condition::well;
  }
  const std::uint64_t turn = kind == Kind::launch_one_bad ? event : event / 2;
  const bool is_well = kind != Kind::launch_one_bad && event % 2 == 0;
  return is_well ? Condition::well : static_cast<Condition>(1 + turn % (conditions - 1));
}

}  // namespace fantail::detection
