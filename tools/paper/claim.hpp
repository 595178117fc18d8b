// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace fantail::paper {

/// The rule, of which there is one: what ours was made from decides the kind of a row, whatever came out. A printed
/// statement is reproduced if it had no part in ours and ours agrees; that can be of the first three kinds only.
enum class Kind : std::uint8_t {
  computed,          ///< from other printed numbers alone
  simulated,         ///< by a run with the published inputs, none of which was chosen to meet it
  described,         ///< printed in words; seen in such a run, or in other printed numbers
  fitted,            ///< an input that is not printed was chosen to meet it, or a related value
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

/// One printed statement beside ours.
struct Claim {
  std::string place{};  ///< "Section 4.2", "Eq 38", "Table 2"
  std::string what{};
  std::string theirs{};
  std::string ours{};
  std::string difference{};
  Kind kind = Kind::not_reproducible;
  bool agrees = true;  ///< false: ours is another value, and the reason is given
  std::string why{};   ///< the reason, or what the agreement rests on; may be empty when it agrees
};

/// What came of it, for files: "reproduced", "differs", or the name of a kind that cannot be reproduced.
[[nodiscard]] std::string_view finding(const Claim& claim);
/// What files called its basis before there were kinds: "derived", "fitted", "round_trip", "simulated", "none".
[[nodiscard]] std::string_view basis(const Claim& claim);
/// For readers: "fitted", "fitted, differs".
[[nodiscard]] std::string kind_words(const Claim& claim);

/// Of a kind that is folded, and as it was put in.
[[nodiscard]] inline bool is_folded(const Claim& claim) { return claim.agrees && is_folded(claim.kind); }

/// A printed number and ours.
struct Numbers {
  std::string place{};
  std::string what{};
  double theirs = 0.0;
  double ours = 0.0;
  std::string unit{};
  int decimals = 2;
  double tolerance = 0.0;  ///< largest difference that counts as agreement
  Kind kind = Kind::simulated;
  /// When it is larger: what the reason is. Without a reason it still is a difference, and the page says so.
  std::string why_otherwise{};
  std::string remark{};  ///< when it agrees
};

/// A number that other printed numbers contradict is an error in the print.
[[nodiscard]] Claim compare(const Numbers& numbers);

/// A result in words, and whether ours shows it, too. `why` says from what.
struct InWords {
  std::string place{};
  std::string what{};
  std::string theirs{};
  std::string ours{};
  bool holds = false;
  Kind kind = Kind::described;
  std::string why{};
};
[[nodiscard]] Claim compare(const InWords& in_words);

/// A statement that rests on data nobody else has; `ours` says what a simulated stand-in gave, or is
/// empty.
[[nodiscard]] Claim unpublished(std::string place, std::string what, std::string theirs, std::string why,
                                std::string ours = {});

/// A slip of the print, and what it must read.
[[nodiscard]] Claim slip(std::string place, std::string what, std::string printed, std::string must_be,
                         std::string why);

struct Chapter {
  std::string title{};
  std::string introduction{};
  std::vector<Claim> claims{};
  std::vector<std::string> figures_html{};
};

}  // namespace fantail::paper
