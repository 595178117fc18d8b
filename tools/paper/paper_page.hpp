// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

#include "paper/claim.hpp"

namespace fantail::paper {

/// How many claims came to what.
struct Tally {
  std::size_t reproduced = 0;
  // Those by what they rest on.
  std::size_t reproduced_derived = 0;
  std::size_t reproduced_fitted = 0;
  std::size_t reproduced_round_trip = 0;
  std::size_t differs = 0;
  std::size_t not_reproducible = 0;
  std::size_t error_in_print = 0;
};
[[nodiscard]] Tally tally(std::span<const Chapter> chapters);

/// How it came out, in a sentence.
[[nodiscard]] std::string summary(const Tally& tally);

/// The whole reproduction as one page that loads nothing.
[[nodiscard]] std::string paper_html(std::span<const Chapter> chapters, const std::string& version);

/// An object: tally, and "claims" with place, what, theirs, ours, difference, finding,
/// basis, why. Ends with a newline.
[[nodiscard]] std::string paper_json(std::span<const Chapter> chapters, const std::string& version);

}  // namespace fantail::paper
