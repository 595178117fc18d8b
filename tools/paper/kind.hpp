// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace fantail::paper {

/// The rule, of which there is one: what ours was made from decides the kind of a row, whatever came out. A printed
/// statement is reproduced if it had no part in ours and ours agrees; that can be of the first three kinds only.
enum class Kind : std::uint8_t {
  computed,          ///< from other printed numbers alone
  simulated,         ///< by a run with the published inputs, none of which was chosen to meet it
  described,         ///< printed in words; seen in such a run, or in other printed numbers
  fitted,            ///< an input that is not printed was chosen to meet it, or to meet what it follows from
  read_back,         ///< a round trip: it was an input, and our analysis finds it again
  definition,        ///< an equation or an input, taken as printed: nothing is compared but whether it was taken
  outside,           ///< about what no model here contains
  error_in_print,    ///< it contradicts other printed statements
  not_reproducible,  ///< it needs an input that is not printed
};

inline constexpr std::array kinds{Kind::computed, Kind::simulated,      Kind::described,
                                  Kind::fitted,   Kind::read_back,      Kind::definition,
                                  Kind::outside,  Kind::error_in_print, Kind::not_reproducible};

[[nodiscard]] constexpr bool counts_as_reproduced(Kind kind) {
  return kind == Kind::computed || kind == Kind::simulated || kind == Kind::described;
}

/// Rows that teach nothing of the measurement: page and terminal keep them back until a reader asks.
[[nodiscard]] constexpr bool is_folded(Kind kind) {
  return kind == Kind::read_back || kind == Kind::definition || kind == Kind::outside;
}

[[nodiscard]] constexpr std::size_t place_of(Kind kind) { return static_cast<std::size_t>(kind); }

[[nodiscard]] std::string_view name(Kind kind);   ///< for files: "read_back"
[[nodiscard]] std::string_view words(Kind kind);  ///< for readers: "read back"

/// The rule for readers, a sentence a kind.
[[nodiscard]] std::string_view rule_text();

}  // namespace fantail::paper
