// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "paper/kind.hpp"

namespace fantail::paper {

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
